//! Elementary functions against those of double precision. The bounds are those of the documentation; with the feature `reproducible` the
//! portable functions are tested, without it those of the platform, which have to keep them too.

use brunovsky::elementary::{cos, hypot, sin, sin_cos};
use proptest::prelude::*;

/// Every 9973rd number of single precision up to `limit`, and its negative.
fn singles(limit: f32) -> impl Iterator<Item = f32> {
    (0..=limit.to_bits()).step_by(9973).map(f32::from_bits).flat_map(|x| [x, -x])
}

fn error(x: f32) -> f64 {
    let (sin, cos) = sin_cos(x);
    let x = f64::from(x);
    (f64::from(sin) - x.sin()).abs().max((f64::from(cos) - x.cos()).abs())
}

#[test]
fn sine_and_cosine_keep_their_bound_up_to_8192() {
    for x in singles(8192.0) {
        assert!(error(x) <= 1.2e-7, "{x}: {:e}", error(x));
    }
}

/// The nearest f32 to 2π is off by 1 part in 3.5·10⁷, which is less than half an ulp of any x, 2⁻²⁵ of it at least.
#[test]
fn beyond_that_the_error_is_that_of_an_x_half_an_ulp_off() {
    for x in singles(f32::MAX).filter(|x| x.abs() > 8192.0) {
        let half_an_ulp = f64::from(x.abs().next_up() - x.abs()) / 2.0;
        // 2⁻²⁵·x ≤ ½ ulp(x); at the upper end ulp is infinite.
        assert!(error(x) <= 1.2e-7 + half_an_ulp, "{x}: {:e}", error(x));
    }
}

#[test]
fn of_what_is_not_finite_there_is_no_sine() {
    for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let (sin, cos) = sin_cos(x);
        assert!(sin.is_nan() && cos.is_nan(), "{x}: {sin}, {cos}");
    }
}

#[test]
fn the_sine_keeps_the_sign_of_zero() {
    assert_eq!(sin(0.0_f32).to_bits(), 0.0_f32.to_bits());
    assert_eq!(sin(-0.0_f32).to_bits(), (-0.0_f32).to_bits());
}

/// |computed − true| in units of the last place of the true value.
fn ulps(computed: f32, exact: f64) -> f64 {
    let size = (exact as f32).abs();
    let ulp = f64::from(size.next_up()) - f64::from(size);
    (f64::from(computed) - exact).abs() / ulp
}

proptest! {
    #[test]
    fn the_hypotenuse_is_within_two_ulps(x in any::<f32>(), y in any::<f32>()) {
        let exact = f64::from(x).hypot(f64::from(y));
        if exact <= f64::from(f32::MAX) {
            prop_assert!(ulps(hypot(x, y), exact) <= 2.0, "{}", ulps(hypot(x, y), exact));
        } else {
            prop_assert_eq!(hypot(x, y), f32::INFINITY);
        }
    }

    #[test]
    fn the_hypotenuse_of_comparable_sides_is_within_two_ulps(
        scale in -37..38_i32, x in 0.1..10.0_f32, y in 0.1..10.0_f32,
    ) {
        let (x, y) = (x * 10.0_f32.powi(scale), y * 10.0_f32.powi(scale));
        let exact = f64::from(x).hypot(f64::from(y));
        prop_assume!(exact <= f64::from(f32::MAX));
        prop_assert!(ulps(hypot(x, y), exact) <= 2.0, "{}", ulps(hypot(x, y), exact));
    }

    #[test]
    fn the_hypotenuse_is_even_and_symmetric(x in any::<f32>(), y in any::<f32>()) {
        for other in [hypot(y, x), hypot(-x, y), hypot(x, -y)] {
            prop_assert_eq!(hypot(x, y).to_bits(), other.to_bits());
        }
    }

    #[test]
    fn sine_is_odd_and_cosine_even(x in any::<f32>()) {
        prop_assert_eq!(sin(-x).to_bits(), (-sin(x)).to_bits());
        prop_assert_eq!(cos(-x).to_bits(), cos(x).to_bits());
    }

    #[test]
    fn doubles_are_those_of_the_field(x in any::<f64>(), y in any::<f64>()) {
        use nalgebra::ComplexField;
        prop_assert_eq!((sin(x), cos(x)), ComplexField::sin_cos(x));
        prop_assert_eq!(hypot(x, y), ComplexField::hypot(x, y));
    }
}

#[test]
fn a_side_that_is_not_finite_is_no_hypotenuse() {
    assert!(hypot(f32::NAN, 1.0).is_nan() && hypot(1.0, f32::NAN).is_nan());
    for side in [f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(hypot(side, 1.0), f32::INFINITY);
        assert_eq!(hypot(0.0, side), f32::INFINITY);
    }
    assert_eq!(hypot(0.0_f32, 0.0), 0.0);
}
