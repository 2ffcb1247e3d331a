//! The system of the simulation study, against its formula (eq_3rdsystems) term by term.

use brunovsky::{
    Scalar,
    plant::{FeedbackLinearizable, Plant, ThirdOrder},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, num},
};

fn drift<T: Scalar>(x: [f64; 3]) -> T {
    ThirdOrder::new().drift(&SVector::from(x.map(num::<T>)))
}

/// On the axes all terms but one are constant, so each can be read off by itself; each is computed alike, so equality is exact
/// but for the sum with the constant 1 = e⁰.
fn has_the_four_terms<T: Scalar>() {
    for value in [-2.5, -0.5, 0.0, 0.75, 3.0] {
        let v = num::<T>(value);
        let epsilon = T::default_epsilon() * num(32.0);
        let x1 = v.exp() - v - v;
        approx::assert_abs_diff_eq!(drift::<T>([value, 0.0, 0.0]), x1, epsilon = epsilon);
        approx::assert_abs_diff_eq!(drift::<T>([0.0, value, 0.0]), T::one() - v, epsilon = epsilon);
        approx::assert_abs_diff_eq!(
            drift::<T>([0.0, 0.0, value]),
            T::one() - v.sin(),
            epsilon = epsilon
        );
    }
}

/// a is a sum of functions of one variable each.
fn is_separable<T: Scalar>(x: [f64; 3]) {
    let apart =
        drift::<T>([x[0], 0.0, 0.0]) + drift::<T>([0.0, x[1], 0.0]) + drift::<T>([0.0, 0.0, x[2]])
            - num(2.0);
    // The terms are at most e³ ≈ 20 and there are a dozen roundings.
    assert_equal_to_rounding(&SVector::from([drift::<T>(x)]), &SVector::from([apart]), 12.0 * 20.0);
}

proptest! {
    #[test]
    fn the_terms_add_up(x in prop::array::uniform3(-3.0..3.0_f64)) {
        is_separable::<f32>(x);
        is_separable::<f64>(x);
    }

    #[test]
    fn the_state_equations_are_those_of_the_paper(x in prop::array::uniform3(-3.0..3.0_f64), u in -9.0..9.0_f64) {
        let a = x[0].exp() - (2.0 * x[0] + x[1] + x[2].sin());
        let found = ThirdOrder::new().derivative(0.0, &x.into(), &[u].into());
        // A different order of the sum: five roundings of numbers below 40.
        assert_equal_to_rounding(&found, &SVector::from([x[1], x[2], a + u]), 200.0);
    }
}

fn is_unforced_at_the_origin_with_rate_one<T: Scalar>() {
    let origin = SVector::zeros();
    assert_eq!(ThirdOrder::<T>::new().drift(&origin), T::one());
    assert_eq!(ThirdOrder::<T>::new().input_gain(&origin), T::one());
}

at_f32_and_f64! {
    each_variable_enters_by_its_own_term => has_the_four_terms,
    at_the_origin_the_drift_is_e_to_the_zero => is_unforced_at_the_origin_with_rate_one,
}
