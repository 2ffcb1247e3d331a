//! Error integrals against closed forms.

use brunovsky::{Error, Scalar, simulation::ErrorMetrics};
use proptest::prelude::*;

use crate::{at_f32_and_f64, num};

/// e = exp(−t) from t = `start` to `start` + 4.
fn exponential(steps: u32, start: f64) -> ErrorMetrics<f64> {
    let samples = (0..=steps).map(|k| 4.0 * f64::from(k) / f64::from(steps));
    ErrorMetrics::of(samples.map(|t| (start + t, (-t).exp()))).unwrap()
}

/// ∫e, ∫e², ∫t·e over [0, T] and √(∫e²/T), T = 4.
fn closed_forms() -> [f64; 4] {
    let (end, last) = (4.0, f64::exp(-4.0));
    let ise = (1.0 - last * last) / 2.0;
    [1.0 - last, ise, 1.0 - (1.0 + end) * last, (ise / end).sqrt()]
}

fn figures(metrics: &ErrorMetrics<f64>) -> [f64; 4] {
    [metrics.iae(), metrics.ise(), metrics.itae(), metrics.rms().unwrap()]
}

#[test]
fn the_integrals_of_an_exponential_converge_to_their_closed_forms_with_second_order() {
    let errors = |steps| {
        let found = figures(&exponential(steps, 0.0));
        core::array::from_fn::<_, 4, _>(|i| (found[i] - closed_forms()[i]).abs())
    };
    let (coarse, fine) = (errors(400), errors(800));
    for (coarse, fine) in coarse.iter().zip(fine) {
        let order = (coarse / fine).log2();
        assert!((order - 2.0).abs() < 0.01, "order {order}");
    }
    assert_eq!(exponential(400, 0.0).maximum(), 1.0);
}

#[test]
fn time_counts_from_the_first_sample() {
    let (now, later) = (figures(&exponential(800, 0.0)), figures(&exponential(800, 64.0)));
    for (now, later) in now.iter().zip(later) {
        // Times near 64 are rounded to 64·ε, weighted by a curvature that is no larger than the 800 terms.
        approx::assert_relative_eq!(*now, later, max_relative = 64.0 * f64::EPSILON * 800.0);
    }
}

/// The trapezoidal rule is exact for constants, and for t·|e| too: c·T, c²·T, c·T²/2, c.
fn constants_are_exact<T: Scalar>() {
    for c in [3.0, -3.0] {
        // Whole numbers and halves; the times are not evenly spaced.
        let samples = [2.0, 3.0, 3.5, 6.0, 10.0].map(|t| (num::<T>(t), num::<T>(c)));
        let metrics = ErrorMetrics::of(samples).unwrap();
        assert_eq!(metrics.iae(), num(24.0));
        assert_eq!(metrics.ise(), num(72.0));
        assert_eq!(metrics.itae(), num(96.0));
        assert_eq!(metrics.maximum(), num(3.0));
        assert_eq!(metrics.rms(), Some(num(3.0)));
    }
}

fn without_duration_there_is_no_mean<T: Scalar>() {
    let mut metrics = ErrorMetrics::<T>::default();
    assert_eq!(metrics.rms(), None);
    metrics.push(num(1.0), num(-2.0)).unwrap();
    assert_eq!(metrics.rms(), None);
    assert_eq!((metrics.iae(), metrics.ise(), metrics.itae()), (T::zero(), T::zero(), T::zero()));
    assert_eq!(metrics.maximum(), num(2.0));
    metrics.push(num(1.5), num(2.0)).unwrap();
    assert_eq!(metrics.rms(), Some(num(2.0)));
}

fn bad_samples_are_refused_and_not_taken<T: Scalar>() {
    let mut metrics =
        ErrorMetrics::of([(0.0, 1.0), (2.0, -1.0)].map(|(t, e)| (num::<T>(t), num(e)))).unwrap();
    let before = metrics;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = metrics.push(num(bad), T::one()).unwrap_err();
        assert!(matches!(error, Error::NonFinite { name: "t", .. }));
        let error = metrics.push(num(3.0), num(bad)).unwrap_err();
        assert!(matches!(error, Error::NonFinite { name: "e", .. }));
        assert_eq!(metrics, before);
    }
    for limit in [2.0, 1.0, -1.0] {
        let error = Error::NotBelow { name: "time of the sample before", value: 2.0, limit };
        assert_eq!(metrics.push(num(limit), T::one()), Err(error));
        assert_eq!(metrics, before);
    }
    let first = ErrorMetrics::of([(num::<T>(f64::NAN), T::one())]);
    assert!(matches!(first, Err(Error::NonFinite { name: "t", .. })));
}

at_f32_and_f64! {
    a_constant_error_is_integrated_exactly => constants_are_exact,
    before_the_second_sample_there_is_no_mean => without_duration_there_is_no_mean,
    times_that_stand_still_and_values_that_are_not_finite_are_refused => bad_samples_are_refused_and_not_taken,
}

proptest! {
    /// Scaling e by c and time by τ, powers of two, is exact: IAE by c·τ, ISE by c²·τ, ITAE by c·τ², RMS and maximum by c.
    #[test]
    fn the_figures_have_their_units(
        errors in prop::collection::vec(-9.0..9.0_f64, 2..30), c in -8..8_i32, tau in -8..8_i32,
    ) {
        let metrics = |c: f64, tau: f64| {
            let samples = errors.iter().enumerate().map(|(k, e)| (0.3 * k as f64 * tau, c * e));
            ErrorMetrics::of(samples).unwrap()
        };
        let (c, tau) = (2.0_f64.powi(c), 2.0_f64.powi(tau));
        let (plain, scaled) = (metrics(1.0, 1.0), metrics(c, tau));
        let [iae, ise, itae, rms] = figures(&plain);
        prop_assert_eq!(figures(&scaled), [iae * c * tau, ise * c * c * tau, itae * c * tau * tau, rms * c]);
        prop_assert_eq!(scaled.maximum(), plain.maximum() * c);
        prop_assert_eq!(metrics(-c, tau), scaled);
    }
}
