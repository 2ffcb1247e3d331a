//! Step responses of first and second order and of non-minimum phase, by their closed forms.

use brunovsky::{Error, Scalar, simulation::StepInfo};
use proptest::prelude::*;

use crate::{at_f32_and_f64, num};

/// The characteristics of y(t) for t ∈ [0, end], sampled with period `h`.
fn measure(y: impl Fn(f64) -> f64, h: f64, end: f64, y_init: f64, y_final: f64) -> StepInfo<f64> {
    let samples = (0..=(end / h).round() as u32).map(|k| f64::from(k) * h);
    StepInfo::of(samples.map(|t| (t, y(t))), y_init, y_final).unwrap()
}

fn first_order(t: f64) -> f64 {
    1.0 - (-t / 0.7).exp()
}

#[test]
fn a_first_order_lag_rises_in_t_ln_9_and_settles_in_t_ln_50() {
    let errors = |h| {
        let info = measure(first_order, h, 7.0, 0.0, 1.0);
        assert_eq!((info.overshoot(), info.undershoot()), (0.0, 0.0));
        // A monotone response is largest at its last sample.
        approx::assert_abs_diff_eq!(info.peak(), first_order(7.0), epsilon = 1e-15);
        approx::assert_abs_diff_eq!(info.peak_time(), 7.0, epsilon = 1e-14);
        let rise = info.rise_time().unwrap() - 0.7 * 9.0_f64.ln();
        let settling = info.settling_time().unwrap() - 0.7 * 50.0_f64.ln();
        rise.abs().max(settling.abs())
    };
    // Interpolation errs by y″h²/(8·ẏ) ≤ h²/(8T) at each crossing.
    for h in [0.07, 0.007, 0.0007] {
        assert!(errors(h) <= 2.0 * h * h / (8.0 * 0.7) + 1e-12, "{h}: {}", errors(h));
    }
}

/// 1/(p² + 2ζp + 1): y = 1 − e^(−ζt)·(cos ωt + (ζ/ω)·sin ωt), ω = √(1 − ζ²).
fn second_order(zeta: f64) -> impl Fn(f64) -> f64 {
    let omega = (1.0 - zeta * zeta).sqrt();
    move |t| 1.0 - (-zeta * t).exp() * ((omega * t).cos() + zeta / omega * (omega * t).sin())
}

/// A time at which y crosses `level`, by bisection between `low` and `high`.
fn crossing(y: impl Fn(f64) -> f64, level: f64, mut low: f64, mut high: f64) -> f64 {
    let side = y(low) < level;
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if (y(middle) < level) == side { low = middle } else { high = middle }
    }
    high
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn an_underdamped_response_has_the_overshoot_and_times_of_the_textbook(zeta in 0.2..0.7_f64) {
        let y = second_order(zeta);
        let omega = (1.0 - zeta * zeta).sqrt();
        let h = 0.002;
        let info = measure(&y, h, 40.0, 0.0, 1.0);
        let overshoot = (-core::f64::consts::PI * zeta / omega).exp();
        let peak_time = core::f64::consts::PI / omega;
        // The nearest sample is at most h/2 from the peak, where |ÿ| ≤ 1.
        prop_assert!((info.overshoot() - 100.0 * overshoot).abs() <= 100.0 * h * h / 8.0);
        prop_assert!((info.peak() - 1.0 - overshoot).abs() <= h * h / 8.0);
        prop_assert!((info.peak_time() - peak_time).abs() <= h);
        let rise = crossing(&y, 0.9, 0.0, peak_time) - crossing(&y, 0.1, 0.0, peak_time);
        // |ÿ| ≤ 1 and ẏ > 0.1 at both levels bound the error of interpolation by h²/8/ẏ.
        prop_assert!((info.rise_time().unwrap() - rise).abs() <= 2.0 * h * h / 8.0 / 0.1);
        // Extremes lie at multiples of π/ω with size e^(−ζt): the last one outside of the band, then the crossing after it.
        let last = (1..).take_while(|k| (-zeta * peak_time * f64::from(*k)).exp() > 0.02).last().unwrap();
        let next = f64::from(last + 1) * peak_time;
        // A peak that only grazes the band is as sharp as its curvature; the sampled one may miss it.
        let grazing = [last, last + 1].iter().any(|k| ((-zeta * peak_time * f64::from(*k)).exp() - 0.02).abs() < 1e-3);
        if !grazing {
            let level = if last % 2 == 1 { 1.02 } else { 0.98 };
            let settling = crossing(&y, level, next - peak_time, next);
            // ẏ² ≥ (size² − band²)·ω² stays above 0.005 away from grazing.
            prop_assert!((info.settling_time().unwrap() - settling).abs() <= h * h / 8.0 / 0.005);
        }
    }

    /// Everything but the peak refers to the normalized response, so y → a·y + b changes nothing; a < 0 makes it fall.
    #[test]
    fn scale_and_offset_do_not_matter(
        zeta in 0.2..0.7_f64, a in prop_oneof![-50.0..-0.1_f64, 0.1..50.0_f64], b in -10.0..10.0_f64,
    ) {
        let y = second_order(zeta);
        let plain = measure(&y, 0.01, 30.0, 0.0, 1.0);
        let moved = measure(|t| a * y(t) + b, 0.01, 30.0, b, a + b);
        // η is recovered with a few roundings of |b/a| ≤ 100; crossings divide that by ẏ·h, and by the slope 0.07 at the band.
        let rounding = 8.0 * f64::EPSILON * (1.0 + (b / a).abs());
        let close = |p: f64, q: f64, slope: f64| (p - q).abs() <= rounding / slope;
        prop_assert!(close(plain.rise_time().unwrap(), moved.rise_time().unwrap(), 0.01));
        prop_assert!(close(plain.settling_time().unwrap(), moved.settling_time().unwrap(), 1e-4));
        prop_assert!(close(plain.overshoot(), moved.overshoot(), 0.01));
        prop_assert!(close(plain.undershoot(), moved.undershoot(), 0.01));
        let (plain, moved) = (plain.steady_state_error().unwrap(), moved.steady_state_error().unwrap());
        prop_assert!((plain * a - moved).abs() <= rounding * a.abs());
    }
}

/// (1 − βp)/(p + 1)² with β = 1: y = 1 − (1 + t)·e^(−t) − t·e^(−t) = 1 − (1 + 2t)·e^(−t), least at t = ½.
#[test]
fn a_non_minimum_phase_response_undershoots() {
    let y = |t: f64| 1.0 - (1.0 + 2.0 * t) * (-t).exp();
    let info = measure(y, 0.001, 20.0, 0.0, 1.0);
    let deepest = 2.0 * (-0.5_f64).exp() - 1.0;
    // The samples include t = ½.
    approx::assert_relative_eq!(info.undershoot(), 100.0 * deepest, max_relative = 1e-12);
    assert_eq!(info.overshoot(), 0.0);
    let rise = crossing(y, 0.9, 1.0, 20.0) - crossing(y, 0.1, 1.0, 20.0);
    approx::assert_abs_diff_eq!(info.rise_time().unwrap(), rise, epsilon = 1e-6);
}

#[test]
fn a_response_that_arrives_too_low_or_keeps_oscillating_has_no_times() {
    let low = measure(|t| 0.89 * first_order(t), 0.01, 20.0, 0.0, 1.0);
    assert_eq!((low.rise_time(), low.settling_time()), (None, None));
    approx::assert_abs_diff_eq!(low.steady_state_error().unwrap(), 0.11, epsilon = 1e-12);
    let oscillating = measure(|t| 1.0 - t.cos(), 0.01, 20.0 * core::f64::consts::PI, 0.0, 1.0);
    assert_eq!(oscillating.settling_time(), None);
    assert!(oscillating.rise_time().is_some());
    // It settles, and leaves again with its last sample.
    let leaving = StepInfo::of([(0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 1.1)], 0.0, 1.0).unwrap();
    assert_eq!(leaving.settling_time(), None);
}

/// Samples on a straight line, where linear interpolation is exact: 10 % at t = 1, 90 % at t = 9, the band at 9.8.
fn a_ramp_is_interpolated_exactly<T: Scalar>() {
    for (start, y_init, y_final) in [(0.0, 0.0, 1.0), (5.0, 20.0, -20.0)] {
        let y = |t: f64| y_init + (y_final - y_init) * (t / 10.0).min(1.0);
        let samples = [0.0, 4.0, 10.0, 12.0].map(|t| (num::<T>(start + t), num::<T>(y(t))));
        let info = StepInfo::of(samples, num(y_init), num(y_final)).unwrap();
        let epsilon = T::default_epsilon() * num(64.0);
        approx::assert_abs_diff_eq!(info.rise_time().unwrap(), num(8.0), epsilon = epsilon);
        approx::assert_abs_diff_eq!(info.settling_time().unwrap(), num(9.8), epsilon = epsilon);
        assert_eq!(info.steady_state_error(), Some(T::zero()));
        assert_eq!(info.peak(), num(y_init.abs().max(y_final.abs())));
        // The first of equal peaks.
        assert_eq!(info.peak_time(), num(if y_init == 0.0 { 10.0 } else { start }));
    }
}

fn a_response_that_starts_at_its_end_is_settled_at_once<T: Scalar>() {
    let info =
        StepInfo::of([1.0, 2.0].map(|t| (num::<T>(t), T::one())), T::zero(), T::one()).unwrap();
    assert_eq!((info.rise_time(), info.settling_time()), (Some(T::zero()), Some(T::zero())));
    let none = StepInfo::<T>::new(T::zero(), T::one()).unwrap();
    assert_eq!(
        (none.rise_time(), none.settling_time(), none.steady_state_error()),
        (None, None, None)
    );
}

fn bad_samples_and_ends_are_refused<T: Scalar>() {
    let new = |from: f64, to: f64| StepInfo::<T>::new(num(from), num(to));
    let singular = Error::Singular { name: "y_final - y_init", value: 0.0 };
    assert_eq!(new(2.0, 2.0), Err(singular));
    let mut info = StepInfo::of(
        [(0.0, 0.0), (2.0, 1.0)].map(|(t, y)| (num::<T>(t), num(y))),
        T::zero(),
        T::one(),
    )
    .unwrap();
    let before = info;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(new(bad, 1.0), Err(Error::NonFinite { name: "y_init", .. })));
        assert!(matches!(new(1.0, bad), Err(Error::NonFinite { name: "y_final", .. })));
        assert!(matches!(info.push(num(bad), T::one()), Err(Error::NonFinite { name: "t", .. })));
        assert!(matches!(info.push(num(3.0), num(bad)), Err(Error::NonFinite { name: "y", .. })));
        assert_eq!(info, before);
    }
    for limit in [2.0, 1.0] {
        let error = Error::NotBelow { name: "time of the sample before", value: 2.0, limit };
        assert_eq!(info.push(num(limit), T::one()), Err(error));
        assert_eq!(info, before);
    }
    // Each end is finite, their difference is not.
    let largest = T::max_value().unwrap();
    let span = StepInfo::new(-largest, largest);
    assert!(matches!(span, Err(Error::NonFinite { name: "y_final - y_init", .. })));
}

/// Times, ordinates and spans that are finite, and a rise time, an overshoot or a steady-state error that would not be.
fn figures_beyond_the_range_are_refused<T: Scalar>() {
    let most = T::max_value().unwrap();
    let half = most * num(0.5);
    for (y_final, first, second) in [
        (T::one(), (-most, T::zero()), (most, T::one())),
        (T::one(), (T::zero(), T::zero()), (T::one(), half)),
        (half, (T::zero(), T::zero()), (T::one(), -most)),
    ] {
        let mut info = StepInfo::new(T::zero(), y_final).unwrap();
        info.push(first.0, first.1).unwrap();
        let before = info;
        assert!(matches!(info.push(second.0, second.1), Err(Error::NonFinite { .. })));
        assert_eq!(info, before);
        info.push(first.0 * num(0.5) + T::one(), y_final).unwrap();
        assert!(info.rise_time().unwrap().is_finite());
    }
}

at_f32_and_f64! {
    crossings_between_samples_are_interpolated => a_ramp_is_interpolated_exactly,
    at_the_end_from_the_start => a_response_that_starts_at_its_end_is_settled_at_once,
    bad_ends_and_samples_are_refused_and_not_taken => bad_samples_and_ends_are_refused,
    figures_beyond_the_range_are_refused_and_not_taken => figures_beyond_the_range_are_refused,
}

/// A finite response whose normalized value is beyond the range is refused like one that is itself beyond it.
///
/// Were the infinite η taken, the next crossing would be interpolated between it and a number, which makes the settling
/// time NaN.
#[test]
fn a_response_beyond_the_range_in_units_of_the_step_is_refused() {
    let found = StepInfo::of([(0.0, 0.0), (1.0, 1e300), (2.0, 1e-300)], 0.0, 1e-300);
    assert!(matches!(found, Err(Error::NonFinite { .. })), "{found:?}");
}
