use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    differentiator::{BackwardDifference, Differentiator, FilteredDifference},
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, cases, error_on_a_sine, is_least_at, rates, real, ulps};

in_both_precisions! {
    a_ramp_is_approached_geometrically,
    the_response_to_a_step_decays_geometrically,
    without_time_constant_it_is_the_backward_difference,
    a_parabola_is_followed_with_the_stated_delay,
    white_noise_comes_out_with_the_stated_variance,
    a_settled_ramp_stays_exact_when_the_period_varies,
    a_time_constant_that_is_negative_or_not_finite_is_refused,
    noise_or_a_bound_out_of_range_is_refused,
}

fn filter<T: Scalar>(tau: f64) -> FilteredDifference<T> {
    FilteredDifference::new(real(tau)).unwrap()
}

/// y(k) = τ/(τ + h)·y(k−1) + h/(τ + h)·1 with y(0) = 0, so y(k) = 1 − qᵏ with q = τ/(τ + h). The rounding of a step is forgotten at
/// the same pace, after (τ + h)/h ≤ 41 steps; that of e ≤ 25 is divided by h as well.
fn a_ramp_is_approached_geometrically<T: Scalar>() {
    proptest!(cases(100), |(tau in 0.0..2.0_f64, h in 0.05..0.2_f64)| {
        let q = tau / (tau + h);
        for (k, rate) in rates::<T>(filter(tau), h, 100, |t| t).into_iter().enumerate() {
            assert_abs_diff_eq!(rate, real(1.0 - q.powi(k as i32)), epsilon = ulps(200.0 / h));
        }
    });
}

/// A step of 1 at the second sample passes once as 1/(τ + h) and then decays by q.
fn the_response_to_a_step_decays_geometrically<T: Scalar>() {
    proptest!(cases(100), |(tau in 0.0..2.0_f64, h in 0.05..0.2_f64)| {
        let q = tau / (tau + h);
        let rates = rates::<T>(filter(tau), h, 100, |t| if t > 0.0 { 1.0 } else { 0.0 });
        prop_assert_eq!(rates[0], T::zero());
        for (k, rate) in rates.into_iter().enumerate().skip(1) {
            // k factors q, each off by two ulps or so, of something no larger than 1/(τ + h) < 20; k·qᵏ < 20.
            assert_abs_diff_eq!(rate, real(q.powi(k as i32 - 1) / (tau + h)), epsilon = ulps(800.0));
        }
    });
}

fn without_time_constant_it_is_the_backward_difference<T: Scalar>() {
    let signal = |t: f64| (3.0 * t).sin() + t * t;
    assert_eq!(
        rates::<T>(filter(0.0), 0.1, 50, signal),
        rates::<T>(BackwardDifference::new(), 0.1, 50, signal)
    );
    assert_eq!(
        error_on_a_sine(filter(0.0), 0.1, f64::cos),
        error_on_a_sine(BackwardDifference::new(), 0.1, f64::cos)
    );
}

/// For e = t²/2, y = t − (τ + h/2) solves the recursion exactly: a delay of τ + h/2. The transient is over after 25·τ.
fn a_parabola_is_followed_with_the_stated_delay<T: Scalar>() {
    let (tau, h) = (0.5, 0.125);
    let rates = rates::<T>(filter(tau), h, 320, |t| 0.5 * t * t);
    for (k, rate) in rates.into_iter().enumerate().skip(200) {
        // e ≤ 800 is a multiple of 1/128 and exact; y ≤ 40 rounds at each of the (τ + h)/h = 5 steps that are remembered.
        assert_abs_diff_eq!(rate, real(k as f64 * h - tau - 0.5 * h), epsilon = ulps(40.0 * 10.0));
    }
}

/// The variance of filtered white noise is V·Σ g², g the response to a single 1: the sum itself, until its terms vanish.
fn white_noise_comes_out_with_the_stated_variance<T: Scalar>() {
    for (tau, h) in [(0.0, 0.1), (0.05, 0.1), (0.5, 0.1), (2.0, 0.2), (0.3, 0.01)] {
        let response = rates::<T>(filter(tau), h, 1000, |t| if t == h { 1.0 } else { 0.0 });
        let sum = response.into_iter().fold(T::zero(), |sum, g| sum + g * g);
        let variance = 2.0 / ((tau + h) * (2.0 * tau + h));
        assert_abs_diff_eq!(sum, real(variance), epsilon = real::<T>(variance) * ulps(1000.0));
    }
}

/// (τ·a + a·dt)/(τ + dt) = a at any dt.
fn a_settled_ramp_stays_exact_when_the_period_varies<T: Scalar>() {
    let (mut source, mut e_n, slope) = (filter::<T>(0.5), 0.0, -3.0);
    let periods = core::iter::repeat_n(0.5, 100).chain([0.125, 2.0, 0.25, 0.0625, 1.0]);
    let mut sample = |dt: f64| {
        e_n += slope * dt;
        source.update(real(e_n), real(dt)).unwrap()
    };
    let settled: Vec<T> = periods.map(&mut sample).skip(90).collect();
    assert!(settled.iter().all(|rate| (*rate - real(slope)).abs() <= ulps(8.0)));
}

fn a_time_constant_that_is_negative_or_not_finite_is_refused<T: Scalar>() {
    let attempt = |bad: f64| FilteredDifference::<T>::new(real(bad)).unwrap_err();
    assert_eq!(attempt(-1.0), Error::Negative { name: "time constant", value: -1.0 });
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "time constant", .. }));
    }
}

/// The bias of the delay τ on |ÿ| ≤ L and the variance σ²/τ² of the noise.
#[test]
fn the_time_constant_for_noise_makes_the_largest_mean_square_error_the_least() {
    for (noise, bound) in [(1e-3, 1.0), (0.02, 5.0), (2.0, 0.1)] {
        let tau = FilteredDifference::for_noise(noise, bound).unwrap().time_constant();
        let cost = |tau: f64| (bound * tau).powi(2) + (noise / tau).powi(2);
        assert!(is_least_at(cost, tau));
    }
}

fn noise_or_a_bound_out_of_range_is_refused<T: Scalar>() {
    let attempt = |noise, bound| FilteredDifference::<T>::for_noise(real(noise), real(bound));
    for bad in [0.0, -1.0] {
        let refused = |name| Err(Error::NotPositive { name, value: bad });
        assert_eq!(attempt(bad, 1.0), refused("noise"));
        assert_eq!(attempt(1.0, bad), refused("bound on the rate"));
    }
}
