use brunovsky::{
    Error, Scalar,
    fuzzy::{Gaussian, IntervalMembership, UncertainGaussian},
};
use proptest::prelude::*;

use crate::support::{cases, real};

in_both_precisions! {
    its_grades_are_those_of_the_widths_at_either_end,
    a_certain_one_is_a_gaussian,
    parameters_out_of_range_are_refused,
}

fn its_grades_are_those_of_the_widths_at_either_end<T: Scalar>() {
    proptest!(cases(256), |(centre in -2.0..2.0_f64, lower in 0.1..2.0_f64, blur in 0.0..2.0_f64, e in -9.0..9.0_f64)| {
        let (centre, widths, e) = (real::<T>(centre), [lower, lower + blur].map(real::<T>), real(e));
        let own = UncertainGaussian::new(centre, widths).unwrap();
        prop_assert_eq!((own.centre(), own.widths()), (centre, widths));
        prop_assert_eq!(own.grades(e), widths.map(|width| Gaussian::new(centre, width).unwrap().grade(e)));
        let [low, high] = own.grades(e);
        prop_assert!(low <= high);
    });
}

fn a_certain_one_is_a_gaussian<T: Scalar>() {
    let gaussian = Gaussian::new(real::<T>(0.3), real(0.7)).unwrap();
    let own = UncertainGaussian::from(gaussian);
    assert_eq!(own.grades(real(1.1)), [gaussian.grade(real(1.1)); 2]);
}

fn parameters_out_of_range_are_refused<T: Scalar>() {
    let attempt = |centre: f64, widths: [f64; 2]| {
        UncertainGaussian::<T>::new(real(centre), widths.map(real)).unwrap_err()
    };
    assert_eq!(
        attempt(0.0, [2.0, 1.0]),
        Error::Above { name: "lower width", value: 2.0, limit: 1.0 }
    );
    assert_eq!(attempt(0.0, [0.0, 1.0]), Error::NotPositive { name: "lower width", value: 0.0 });
    assert_eq!(attempt(0.0, [1.0, -1.0]), Error::NotPositive { name: "upper width", value: -1.0 });
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(attempt(bad, [1.0, 1.0]), Error::NonFinite { name: "centre", .. }));
        assert!(matches!(attempt(0.0, [bad, 1.0]), Error::NonFinite { name: "lower width", .. }));
        assert!(matches!(attempt(0.0, [1.0, bad]), Error::NonFinite { name: "upper width", .. }));
    }
}
