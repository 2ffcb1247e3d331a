use approx::assert_abs_diff_eq;
use brunovsky::{Scalar, learning::Switching};
use proptest::prelude::*;

use crate::support::{any_magnitude, cases, least, real, sign_by_definition, ulps};

in_both_precisions! {
    the_implicit_sign_satisfies_its_defining_equation,
    the_explicit_sign_is_the_smoothed_one,
    the_set_valued_sign_is_a_projection,
    an_implicit_sign_without_boundary_layer_is_the_set_valued_one,
    the_implicit_sign_approaches_the_set_valued_one_as_delta_vanishes,
    every_sign_is_odd_bounded_and_does_not_decrease,
    an_implicit_step_neither_grows_nor_crosses_zero,
    zero_has_no_sign,
    explicit_steps_end_in_a_period_two_cycle_of_known_amplitude,
    explicit_steps_below_the_ratio_of_two_die_out,
    delta_is_read_back,
}

fn all<T: Scalar>(delta: T) -> [Switching<T>; 3] {
    [Switching::Explicit { delta }, Switching::Implicit { delta }, Switching::SetValued]
}

/// (|s| − αh·ς)·(1 − ς) = δ·ς is s⁺ = s − αh·ς with ς = s⁺/(s⁺ + δ), cleared of its quotient. Its terms are at most |s|, αh
/// and δ, so rounding of ς leaves a few ulps of their sum.
fn the_implicit_sign_satisfies_its_defining_equation<T: Scalar>() {
    proptest!(cases(20_000), |(s in any_magnitude::<T>(), reach in any_magnitude::<T>(), delta in any_magnitude::<T>())| {
        let (reach, delta) = (reach.abs(), delta.abs());
        let sign = Switching::Implicit { delta }.sign(s, reach).copysign(T::one());
        let residual = (s.abs() - reach * sign) * (T::one() - sign) - delta * sign;
        prop_assert!(residual.abs() <= (s.abs() + reach + delta) * ulps(4.0));
    });
}

fn the_explicit_sign_is_the_smoothed_one<T: Scalar>() {
    proptest!(cases(1000), |(s in any_magnitude::<T>(), reach in any_magnitude::<T>(), delta in any_magnitude::<T>())| {
        let delta = delta.abs();
        prop_assert_eq!(Switching::Explicit { delta }.sign(s, reach.abs()), s / (s.abs() + delta));
    });
}

fn the_set_valued_sign_is_a_projection<T: Scalar>() {
    proptest!(cases(1000), |(s in any_magnitude::<T>(), reach in any_magnitude::<T>())| {
        let reach = reach.abs();
        let projection = (s / reach).max(-T::one()).min(T::one());
        prop_assert_eq!(Switching::SetValued.sign(s, reach), projection);
    });
}

fn an_implicit_sign_without_boundary_layer_is_the_set_valued_one<T: Scalar>() {
    proptest!(cases(1000), |(s in any_magnitude::<T>(), reach in any_magnitude::<T>())| {
        let reach = reach.abs();
        let bare = Switching::Implicit { delta: T::zero() };
        prop_assert_eq!(bare.sign(s, reach), Switching::SetValued.sign(s, reach));
    });
}

/// With ς₀ the set-valued sign of s > 0, |s| − αh·ς ≥ αh·(ς₀ − ς) and 1 − ς ≥ ς₀ − ς ≥ 0, so the defining equation gives
/// αh·(ς₀ − ς)² ≤ δ. The magnitudes keep δ above the least normal number.
fn the_implicit_sign_approaches_the_set_valued_one_as_delta_vanishes<T: Scalar>() {
    proptest!(cases(5000), |(ratio in 0.0..3.0_f64, size in -18..36_i32, decade in 0..18_i32)| {
        let reach = real::<T>(10.0_f64.powi(size));
        let (s, delta) = (reach * real(ratio), reach * real(10.0_f64.powi(-decade)));
        let limit = Switching::SetValued.sign(s, reach);
        let sign = Switching::Implicit { delta }.sign(s, reach);
        prop_assert!(sign <= limit + ulps(4.0));
        prop_assert!(limit - sign <= (delta / reach).sqrt() + ulps(4.0));
    });
}

fn every_sign_is_odd_bounded_and_does_not_decrease<T: Scalar>() {
    let factors = prop_oneof![Just(1.0), 1.0..1.001_f64, 1.0..10.0_f64];
    proptest!(cases(5000), |(s in any_magnitude::<T>(), reach in any_magnitude::<T>(), delta in any_magnitude::<T>(), more in factors)| {
        let (s, reach) = (s.abs(), reach.abs());
        for switching in all(delta.abs()) {
            let sign = switching.sign(s, reach);
            prop_assert!(sign >= T::zero() && sign <= T::one());
            prop_assert_eq!(switching.sign(-s, reach), -sign);
            // The curve rises; what is computed lies within rounding of it.
            prop_assert!(switching.sign(s * real(more), reach) >= sign - ulps(4.0));
        }
    });
}

/// 0 ≤ αh·ς ≤ |s|, so 0 ≤ |s⁺| ≤ |s| with the sign of s, at any reach. A ς or an s⁺ = δ·ς/(1 − ς) below the normal numbers is off
/// by up to the least number there is, but never by more than itself.
fn an_implicit_step_neither_grows_nor_crosses_zero<T: Scalar>() {
    proptest!(cases(5000), |(s in any_magnitude::<T>(), reach in any_magnitude::<T>(), delta in any_magnitude::<T>())| {
        let (s, reach) = (s.abs(), reach.abs());
        for switching in [Switching::Implicit { delta: delta.abs() }, Switching::SetValued] {
            let travel = reach * switching.sign(s, reach);
            let (after, rounding) = (s - travel, s * ulps(4.0) + reach * least());
            prop_assert!(after.abs() <= s + rounding);
            let underflow = if switching.delta() > T::zero() { reach * (least::<T>() / switching.delta()) } else { T::zero() };
            prop_assert!(after >= -rounding - underflow);
        }
    });
}

fn zero_has_no_sign<T: Scalar>() {
    proptest!(cases(256), |(reach in any_magnitude::<T>(), delta in any_magnitude::<T>())| {
        for switching in all(delta.abs()) {
            prop_assert_eq!(switching.sign(T::zero(), reach.abs()), T::zero());
            prop_assert_eq!(switching.sign(-T::zero(), reach.abs()), T::zero());
        }
    });
}

/// s after `steps` explicit steps without a disturbance.
fn explicit<T: Scalar>(s: T, reach: T, delta: T, steps: u32) -> T {
    (0..steps).fold(s, |s, _| s - reach * Switching::Explicit { delta }.sign(s, reach))
}

/// a − αh·a/(a + δ) = −a has the solution a = αh/2 − δ. Near it, errors shrink by 1 − 4δ/αh a step, by 0.82 at the least here,
/// so rounding errors of a step add up to fewer than 6 of their kind.
fn explicit_steps_end_in_a_period_two_cycle_of_known_amplitude<T: Scalar>() {
    proptest!(cases(200), |(ratio in 2.2..20.0_f64, start in 0.01..30.0_f64, delta in any_magnitude::<T>())| {
        let delta = delta.abs();
        let reach = delta * real(ratio);
        let amplitude = reach * real(0.5) - delta;
        let end = explicit(delta * real(start), reach, delta, 1000);
        assert_abs_diff_eq!(end.abs(), amplitude, epsilon = reach * ulps(16.0));
        assert_abs_diff_eq!(explicit(end, reach, delta, 1), -end, epsilon = reach * ulps(16.0));
    });
}

/// Near zero a step multiplies s by 1 − αh/δ, by 0.9 at the most here; farther out it takes off at least αh/2 ≥ 0.05·δ. 1000
/// steps leave less than 0.9⁵⁰⁰ of δ, or the rounding of that.
fn explicit_steps_below_the_ratio_of_two_die_out<T: Scalar>() {
    proptest!(cases(200), |(ratio in 0.1..1.9_f64, start in 0.01..10.0_f64, delta in any_magnitude::<T>())| {
        let delta = delta.abs();
        let end = explicit(delta * real(start), delta * real(ratio), delta, 1000);
        prop_assert!(end.abs() <= delta * real(1e-6));
    });
}

fn delta_is_read_back<T: Scalar>() {
    assert_eq!(
        all(real::<T>(0.05)).map(|switching| switching.delta()),
        [0.05, 0.05, 0.0].map(real)
    );
}

/// The closed form against bisection, where bisection is accurate: δ and αh within some decades of s.
#[test]
fn the_closed_form_agrees_with_bisection() {
    proptest!(cases(2000), |(s in -10.0..10.0_f64, reach in 0.01..10.0_f64, delta in 0.01..10.0_f64)| {
        for switching in all(delta) {
            assert_abs_diff_eq!(switching.sign(s, reach), sign_by_definition(switching, s, reach), epsilon = 1e-14);
        }
    });
}
