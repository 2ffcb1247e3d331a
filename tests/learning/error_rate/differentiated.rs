use brunovsky::{
    Scalar,
    differentiator::{BackwardDifference, Differentiator, HighGain, RobustExact},
    learning::ErrorRate,
};

use crate::support::{at_error, real};

in_both_precisions! {
    a_differentiator_takes_the_last_error_and_nothing_else,
}

/// ė_n is what it says of e_n, whatever u_n is.
fn a_differentiator_takes_the_last_error_and_nothing_else<T: Scalar>() {
    fn check<T: Scalar>(source: impl Differentiator<Scalar = T> + Clone) {
        let (mut plain, mut learning) = (source.clone(), source);
        for k in 0..30 {
            let (e_n, u_n, h) = (real((0.3 * f64::from(k)).sin()), real(f64::from(k)), real(0.1));
            let rate = ErrorRate::<T, 2>::error_rate(&mut learning, &at_error(e_n), u_n, h);
            assert_eq!(rate, plain.update(e_n, h));
        }
    }
    check::<T>(BackwardDifference::new());
    check::<T>(HighGain::second_order(real(5.0)).unwrap());
    check::<T>(RobustExact::first_order(real(9.0)).unwrap());
}
