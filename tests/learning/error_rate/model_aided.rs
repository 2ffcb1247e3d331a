use approx::assert_abs_diff_eq;
use brunovsky::{
    Scalar,
    differentiator::{Differentiator, FilteredDifference, HighGain, RobustExact, Tracking},
    learning::{ClosedLoop, ErrorRate, ModelAided},
};
use proptest::prelude::*;

use crate::support::{cases, quiet, real, ulps};

in_both_precisions! {
    a_constant_uncertainty_under_a_linear_model_is_found_exactly,
    an_input_that_is_not_reported_is_taken_for_uncertainty,
    the_first_sample_knows_of_no_uncertainty,
    the_uncertainty_is_the_rate_of_what_the_model_does_not_explain,
    with_a_high_gain_observer_it_is_the_extended_state_observer,
}

/// A sample of a plant with ẋ_n = a + b·u + Δ.
fn sample<T: Scalar>(x_n: f64, drift: f64, gain: f64, u: f64, u_b: f64) -> ClosedLoop<T, 2> {
    let mut at =
        ClosedLoop { drift: real(drift), gain: real(gain), u: real(u), u_b: real(u_b), ..quiet() };
    at.x[1] = real(x_n);
    at
}

/// Samples of the plant with a = 1 + 2t, b = 3 − t/4 and constant Δ under inputs held for periods of any length. x_n is the
/// integral of a line over each period, so that the mean of its ends is exact.
fn linear_model(periods: &[(f64, f64)], delta: f64) -> Vec<(f64, [f64; 4])> {
    let (drift, gain) = (|t: f64| 1.0 + 2.0 * t, |t: f64| 3.0 - 0.25 * t);
    let (mut t, mut x_n) = (0.0, 0.5);
    let mut samples = vec![(1.0, [x_n, drift(t), gain(t), 0.0])];
    for (dt, u) in periods {
        let middle = t + 0.5 * dt;
        x_n += dt * (drift(middle) + gain(middle) * u + delta);
        t += dt;
        samples.push((*dt, [x_n, drift(t), gain(t), *u]));
    }
    samples
}

fn periods() -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((0.1..0.5_f64, -4.0..4.0_f64), 1..10)
}

/// The inputs are random and have nothing to do with u_n and u_b, as behind an actuator that saturates: s = −(u_n + Δ) all the
/// same, because the applied input is the one reported.
fn a_constant_uncertainty_under_a_linear_model_is_found_exactly<T: Scalar>() {
    proptest!(cases(300), |(periods in periods(), delta in -9.0..9.0_f64, u_n in -9.0..9.0_f64, u_b in -9.0..9.0_f64)| {
        let mut source = ModelAided::<T>::new();
        for (k, (dt, [x_n, drift, gain, u])) in linear_model(&periods, delta).into_iter().enumerate() {
            let s = source.error_rate(&sample(x_n, drift, gain, u, u_b), real(u_n), real(dt)).unwrap() + real(u_b);
            let known = if k == 0 { 0.0 } else { delta };
            // x_n < 150 is rounded before its difference is divided by dt ≥ 0.1.
            assert_abs_diff_eq!(s, real::<T>(-(u_n + known)), epsilon = ulps(150.0 * 10.0 * 4.0));
        }
    });
}

/// The report counts: if the plant got u and the command u + 1 is reported, s is off by the mean of b.
fn an_input_that_is_not_reported_is_taken_for_uncertainty<T: Scalar>() {
    let samples = linear_model(&[(0.25, 1.5), (0.5, -0.5)], 0.75);
    let mut source = ModelAided::<T>::new();
    let mut last_gain = None;
    for (dt, [x_n, drift, gain, u]) in samples {
        let s = source
            .error_rate(&sample::<T>(x_n, drift, gain, u + 1.0, 0.0), T::zero(), real(dt))
            .unwrap();
        if let Some(last_gain) = last_gain.replace(gain) {
            assert_abs_diff_eq!(
                s,
                real::<T>(-0.75 + 0.5 * (last_gain + gain)),
                epsilon = ulps(100.0)
            );
        }
    }
}

fn the_first_sample_knows_of_no_uncertainty<T: Scalar>() {
    let at = sample::<T>(7.0, 1e3, 5.0, -3.0, 2.5);
    assert_eq!(ModelAided::<T>::new().error_rate(&at, real(0.5), real(0.1)), Ok(real(-2.5 - 0.5)));
}

/// With a = sin t, b = 2 + cos t, u = 1.5 and Δ = cos 2t, x_n has a closed form, and s + Δ̄, Δ̄ the mean of Δ over the period, is
/// the error of the trapezoidal rule: of second order, h²/12·max|ä + b̈·u| in size. Against Δ itself the source is half a period
/// late: of first order at the sample and of second order half a period before.
#[test]
fn the_mean_uncertainty_of_the_period_is_found_to_second_order() {
    let (u, amplitude) = (1.5, 1.0_f64.hypot(1.5));
    let integral = |t: f64| 0.5 * (2.0 * t).sin();
    let x_n = |t: f64| -t.cos() + (2.0 * t + t.sin()) * u + integral(t);
    let error = |h: f64, wanted: &dyn Fn(f64) -> f64| {
        let mut source = ModelAided::new();
        let mut worst = 0.0_f64;
        for k in 0..(4.0 / h).round() as u32 {
            let t = f64::from(k) * h;
            let at = sample::<f64>(x_n(t), t.sin(), 2.0 + t.cos(), u, 0.0);
            let s = source.error_rate(&at, 0.0, h).unwrap();
            worst = worst.max(if k == 0 { 0.0 } else { (s + wanted(t)).abs() });
        }
        worst
    };
    for h in [0.02_f64, 0.01] {
        let order = |wanted: &dyn Fn(f64, f64) -> f64| {
            (error(h, &|t| wanted(t, h)) / error(h / 2.0, &|t| wanted(t, h / 2.0))).log2()
        };
        assert!((1.99..2.01).contains(&order(&|t, h| (integral(t) - integral(t - h)) / h)));
        assert!((0.98..1.02).contains(&order(&|t, _| (2.0 * t).cos())));
        assert!((1.98..2.02).contains(&order(&|t, h| (2.0 * t - h).cos())));
        let size = error(h, &|t| (integral(t) - integral(t - h)) / h);
        assert!((0.99..1.01).contains(&(size / (h * h / 12.0 * amplitude))));
    }
}

/// The rest z = x_n − ∫(a + b·u) dt, summed up by hand, through the differentiator alone.
fn the_uncertainty_is_the_rate_of_what_the_model_does_not_explain<T: Scalar>() {
    fn check<T: Scalar, D: Differentiator<Scalar = T> + Clone>(differentiator: D) {
        proptest!(cases(50), |(periods in periods(), delta in -9.0..9.0_f64)| {
            let mut source = ModelAided::through(differentiator.clone());
            let (mut alone, mut explained) = (differentiator.clone(), 0.0);
            let mut last: Option<(f64, f64)> = None;
            for (dt, [x_n, drift, gain, u]) in linear_model(&periods, delta) {
                let (from, b) = last.replace((drift, gain)).unwrap_or((drift, gain));
                // Before the first sample any number does.
                explained += 0.5 * dt * (from + drift + (b + gain) * u);
                let s = source.error_rate(&sample(x_n, drift, gain, u, 2.0), real(0.5), real(dt)).unwrap();
                let rate = alone.update(real(x_n - explained), real(dt)).unwrap();
                // As above, times what is remembered.
                assert_abs_diff_eq!(s, real::<T>(-2.5) - rate, epsilon = ulps(150.0 * 10.0 * 40.0));
            }
        });
    }
    check(FilteredDifference::new(real::<T>(0.2)).unwrap());
    check(HighGain::second_order(real::<T>(3.0)).unwrap());
    check(Tracking::new(real::<T>(20.0), real(0.5)).unwrap());
    check(RobustExact::first_order(real::<T>(4.0)).unwrap());
}

/// x̂ and Δ̂ from the observer's equations, for a constant period: predict x̂ by the model and Δ̂, correct both.
fn with_a_high_gain_observer_it_is_the_extended_state_observer<T: Scalar>() {
    let (omega, h) = (4.0, 0.25);
    let q = f64::exp(-omega * h);
    let inputs: Vec<(f64, f64)> = (0..20).map(|k| (h, f64::from(k % 5) - 2.0)).collect();
    let mut source = ModelAided::through(HighGain::first_order(real::<T>(omega)).unwrap());
    let (mut x_hat, mut delta_hat) = (0.0, 0.0);
    let mut last: Option<(f64, f64)> = None;
    for (dt, [x_n, drift, gain, u]) in linear_model(&inputs, 2.5) {
        match last.replace((drift, gain)) {
            None => x_hat = x_n,
            Some((a, b)) => {
                x_hat += dt * (0.5 * (a + drift) + 0.5 * (b + gain) * u + delta_hat);
                let surprise = x_n - x_hat;
                x_hat += (1.0 - q * q) * surprise;
                delta_hat += (1.0 - q) * (1.0 - q) / h * surprise;
            }
        }
        let s = source.error_rate(&sample(x_n, drift, gain, u, 0.0), T::zero(), real(dt)).unwrap();
        // x_n < 300, rounded and divided by h, some ten of them remembered.
        assert_abs_diff_eq!(s, real(-delta_hat), epsilon = ulps(300.0 / 0.25 * 10.0));
    }
    // 20 samples of e^(−1) each.
    assert!((delta_hat - 2.5).abs() < 1e-4);
}
