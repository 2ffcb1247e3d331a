use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::{Elliptic, IntervalMembership, Triangular},
};
use proptest::prelude::*;

use crate::support::{cases, real, ulps};

in_both_precisions! {
    it_lies_on_its_curves,
    it_is_certain_at_the_centre_and_at_the_ends_of_its_support,
    with_both_exponents_one_it_is_a_triangle,
    toward_the_end_of_its_support_the_shares_go_on_continuously,
    parameters_out_of_range_are_refused,
}

fn elliptic<T: Scalar>(centre: f64, reach: f64, exponents: [f64; 2]) -> Elliptic<T> {
    Elliptic::new(real(centre), real(reach), exponents.map(real)).unwrap()
}

/// |z|^a + μ^a = 1, which names neither of them first.
fn it_lies_on_its_curves<T: Scalar>() {
    proptest!(cases(256), |(z in -0.99..0.99_f64, lower in 0.2..1.0_f64, upper in 1.0..4.0_f64)| {
        let own = elliptic::<T>(0.5, 2.0, [lower, upper]);
        let grades = own.grades(real::<T>(0.5) + real::<T>(2.0) * real(z));
        for (grade, a) in grades.into_iter().zip([lower, upper].map(real::<T>)) {
            prop_assert!(grade >= T::zero() && grade <= T::one() + ulps(4.0));
            // e is rounded at 2.5, and |z|^a takes that times a.
            assert_abs_diff_eq!(real::<T>(z).abs().powf(a) + grade.powf(a), T::one(), epsilon = ulps(64.0));
        }
        prop_assert!(grades[0] <= grades[1] + ulps(4.0));
    });
}

fn it_is_certain_at_the_centre_and_at_the_ends_of_its_support<T: Scalar>() {
    let own = elliptic::<T>(0.5, 2.0, [0.4, 3.0]);
    assert_eq!((own.centre(), own.reach()), (real(0.5), real(2.0)));
    assert_eq!(own.exponents(), [0.4, 3.0].map(real));
    assert_eq!(own.grades(real(0.5)), [T::one(); 2]);
    for e in [-1.5, 2.5, -2.0, 3.0, 1e30, -1e30] {
        assert_eq!(own.grades(real(e)), [T::zero(); 2]);
    }
}

fn with_both_exponents_one_it_is_a_triangle<T: Scalar>() {
    let own = elliptic::<T>(0.5, 2.0, [1.0, 1.0]);
    let triangle = Triangular::new(real::<T>(-1.5), real(0.5), real(2.5)).unwrap();
    for k in -40..=40 {
        let e = real::<T>(f64::from(k) / 8.0);
        for grade in own.grades(e) {
            assert_abs_diff_eq!(grade, triangle.grade(e), epsilon = ulps(4.0));
        }
    }
}

/// Two of them that part at 2.5: from there on the second is alone, at its end at 4.5 as before and after, where the lower grade is
/// nothing beside the upper one, unless it is the same.
fn toward_the_end_of_its_support_the_shares_go_on_continuously<T: Scalar>() {
    for (exponents, limit) in [([0.5, 2.0], 0.0), ([2.0, 2.0], 1.0), ([1.0, 1.0], 1.0)] {
        let row = [elliptic::<T>(0.5, 2.0, exponents), elliptic(2.5, 2.0, exponents)];
        let after = Elliptic::shares(&row, real(5.0));
        assert_eq!((after.lower, after.upper), ([T::zero(), T::one()], [T::zero(), T::one()]));
        assert_eq!(after.ratio, real(limit));
        for far in [1e30, -1e30] {
            let shares = Elliptic::shares(&row, real(far));
            let alone = if far > 0.0 { after.upper } else { [T::one(), T::zero()] };
            assert_eq!((shares.lower, shares.upper), (alone, alone));
        }
        let before = Elliptic::shares(&row, real::<T>(4.5) - ulps(64.0));
        assert_eq!((before.lower, before.upper), (after.lower, after.upper));
        // (2·(1 − z))^(1/½) beside (2·(1 − z))^½ for 1 − z = 32ε.
        assert_abs_diff_eq!(before.ratio, after.ratio, epsilon = real(1e-6));
    }
}

fn parameters_out_of_range_are_refused<T: Scalar>() {
    let attempt = |centre: f64, reach: f64, exponents: [f64; 2]| {
        Elliptic::<T>::new(real(centre), real(reach), exponents.map(real)).unwrap_err()
    };
    assert_eq!(attempt(0.0, 0.0, [1.0; 2]), Error::NotPositive { name: "reach", value: 0.0 });
    assert_eq!(
        attempt(0.0, 1.0, [2.0, 1.0]),
        Error::Above { name: "lower exponent", value: 2.0, limit: 1.0 }
    );
    assert_eq!(
        attempt(0.0, 1.0, [0.0, 1.0]),
        Error::NotPositive { name: "lower exponent", value: 0.0 }
    );
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(attempt(bad, 1.0, [1.0; 2]), Error::NonFinite { name: "centre", .. }));
        assert!(matches!(attempt(0.0, bad, [1.0; 2]), Error::NonFinite { name: "reach", .. }));
        assert!(matches!(
            attempt(0.0, 1.0, [1.0, bad]),
            Error::NonFinite { name: "upper exponent", .. }
        ));
    }
}
