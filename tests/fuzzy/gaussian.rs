use approx::{assert_relative_eq, assert_ulps_eq};
use brunovsky::{Error, Scalar, fuzzy::Gaussian};
use proptest::prelude::*;

use crate::support::{cases, real, ulps};

in_both_precisions! {
    a_membership_gives_back_its_centre_and_width,
    the_grade_is_one_at_the_centre_and_one_half_at_the_half_width,
    the_distance_is_counted_in_widths,
    the_grade_is_even_about_the_centre_and_falls_away_from_it,
    the_grade_of_a_far_input_vanishes,
    a_centre_that_is_not_finite_is_refused,
    a_width_that_is_not_positive_and_finite_is_refused,
}

fn gaussian<T: Scalar>(centre: f64, width: f64) -> Gaussian<T> {
    Gaussian::new(real(centre), real(width)).unwrap()
}

fn a_membership_gives_back_its_centre_and_width<T: Scalar>() {
    let membership = gaussian::<T>(-1e30, 1e-30);
    assert_eq!(membership.centre(), real(-1e30));
    assert_eq!(membership.width(), real(1e-30));
}

/// μ(c ± σ·√(2 ln 2)) = exp(−ln 2).
fn the_grade_is_one_at_the_centre_and_one_half_at_the_half_width<T: Scalar>() {
    let membership = gaussian::<T>(0.75, 3.0);
    let half_width = real::<T>(3.0 * (2.0 * core::f64::consts::LN_2).sqrt());
    assert_eq!(membership.grade(real(0.75)), T::one());
    // Half an ulp of e ≤ 5 moves the grade by its slope, at most 0.3, times that; the exponential adds its own.
    for e in [real::<T>(0.75) + half_width, real::<T>(0.75) - half_width] {
        assert_relative_eq!(membership.grade(e), real(0.5), epsilon = ulps(4.0));
    }
}

fn the_distance_is_counted_in_widths<T: Scalar>() {
    proptest!(cases(256), |(m in -40..40_i32, centre in -40..40_i32, width in 1..40_i32)| {
        let membership = gaussian::<T>(centre.into(), width.into());
        // Integers: the difference and the quotient are exact.
        prop_assert_eq!(membership.distance(real((centre + m * width).into())), real(m.into()));
    });
}

fn the_grade_is_even_about_the_centre_and_falls_away_from_it<T: Scalar>() {
    proptest!(cases(256), |(near in 0..2000_i32, farther in 1..2000_i32, centre in -2000..2000_i32)| {
        // Thousandths in binary, so e − c has no rounding error.
        let at = |n: i32| real::<T>(f64::from(n) / 1024.0);
        let membership = Gaussian::new(at(centre), real(0.5)).unwrap();
        let grade = membership.grade(at(centre + near));
        prop_assert_eq!(grade, membership.grade(at(centre - near)));
        prop_assert!(membership.grade(at(centre + near + farther)) < grade);
        prop_assert!(grade > T::zero() && grade <= T::one());
        let m = f64::from(near) / 512.0;
        // ln μ = −M²/2; the logarithm turns the relative rounding error of μ into an absolute one.
        assert_ulps_eq!(grade.ln(), real(-0.5 * m * m), epsilon = ulps(4.0), max_ulps = 4);
    });
}

fn the_grade_of_a_far_input_vanishes<T: Scalar>() {
    for e in [1e3, 1e30, -1e3, -1e30] {
        assert_eq!(gaussian::<T>(0.0, 1.0).grade(real(e)), T::zero());
        assert_eq!(gaussian::<T>(0.0, 1e-30).grade(real(e)), T::zero());
    }
}

fn a_centre_that_is_not_finite_is_refused<T: Scalar>() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = Gaussian::<T>::new(real(bad), T::one()).unwrap_err();
        assert!(
            matches!(refused, Error::NonFinite { name: "centre", value } if value.to_bits() == bad.to_bits())
        );
    }
}

fn a_width_that_is_not_positive_and_finite_is_refused<T: Scalar>() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = Gaussian::<T>::new(T::zero(), real(bad)).unwrap_err();
        assert!(
            matches!(refused, Error::NonFinite { name: "width", value } if value.to_bits() == bad.to_bits())
        );
    }
    for bad in [0.0, -0.0, -1.0] {
        let refused = Gaussian::<T>::new(T::zero(), real(bad)).unwrap_err();
        assert_eq!(refused, Error::NotPositive { name: "width", value: bad });
    }
}
