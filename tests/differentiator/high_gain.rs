use approx::{assert_abs_diff_eq, assert_relative_eq};
use brunovsky::{
    Error, Scalar,
    differentiator::{BackwardDifference, Differentiator, HighGain},
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, cases, impulse_response, is_least_at, rates, real, rng, ulps};

in_both_precisions! {
    the_poles_are_where_they_were_put,
    white_noise_comes_out_with_the_stated_variance,
    a_parabola_is_followed_with_the_stated_delay_in_first_order_and_none_in_second,
    for_long_periods_it_is_the_difference_quotient,
    a_parameter_out_of_range_is_refused,
}

/// Bandwidths and periods: ω·h from a twentieth to two.
const CASES: [(f64, f64); 4] = [(5.0, 0.01), (20.0, 0.01), (3.0, 0.1), (4.0, 0.5)];

/// Left to itself every estimate obeys the difference equation whose roots are all q: with the poles in other places it would not.
fn the_poles_are_where_they_were_put<T: Scalar>() {
    for (omega, h) in CASES {
        let q = real::<T>((-omega * h).exp());
        let scale = real::<T>(omega);
        let first = impulse_response(HighGain::first_order(real(omega)).unwrap(), h, 40);
        for g in first.windows(3).skip(1) {
            let rest = g[2] - (q + q) * g[1] + q * q * g[0];
            assert_abs_diff_eq!(rest / scale, T::zero(), epsilon = ulps(60.0));
        }
        let second = impulse_response(HighGain::second_order(real(omega)).unwrap(), h, 40);
        for g in second.windows(4).skip(1) {
            let three = real::<T>(3.0);
            let rest = g[3] - three * q * g[2] + three * q * q * g[1] - q * q * q * g[0];
            assert_abs_diff_eq!(rest / scale, T::zero(), epsilon = ulps(200.0));
        }
    }
}

/// V·Σ g² over the response to a single 1. The second order's closed form is Morrison's for the velocity of a fading quadratic.
fn white_noise_comes_out_with_the_stated_variance<T: Scalar>() {
    let sum = |response: Vec<T>| response.into_iter().fold(T::zero(), |sum, g| sum + g * g);
    for (omega, h) in CASES {
        let q = (-omega * h).exp();
        let tanh = (omega * h / 2.0).tanh();
        let first = sum(impulse_response(HighGain::first_order(real(omega)).unwrap(), h, 1500));
        assert_relative_eq!(first, real(2.0 / (h * h) * tanh.powi(3)), max_relative = ulps(3000.0));
        let second = sum(impulse_response(HighGain::second_order(real(omega)).unwrap(), h, 1500));
        let wanted = (1.0 - q).powi(3) * (13.0 + 50.0 * q + 49.0 * q * q)
            / (2.0 * (1.0 + q).powi(5) * h * h);
        assert_relative_eq!(second, real(wanted), max_relative = ulps(10_000.0));
    }
    // The limits for short periods that the tuning rules use.
    let (omega, h) = (1.0, 1e-3_f64);
    assert_relative_eq!(
        2.0 / (h * h) * (omega * h / 2.0).tanh().powi(3),
        h / 4.0,
        max_relative = 1e-6
    );
}

fn a_parabola_is_followed_with_the_stated_delay_in_first_order_and_none_in_second<T: Scalar>() {
    let h = 0.125;
    for omega in [2.0, 8.0] {
        let first = HighGain::first_order(real::<T>(omega)).unwrap();
        let delay = first.delay(real(h)).unwrap();
        let coth = 1.0 / (omega * h / 2.0).tanh();
        assert_relative_eq!(delay, real(h * coth - h / 2.0), max_relative = ulps(8.0));
        let second = HighGain::second_order(real(omega)).unwrap();
        let parabola = |t: f64| 0.5 * t * t;
        for k in 300..320_u32 {
            let t = real::<T>(f64::from(k) * h);
            // y ≤ 800 is exact; the prediction rounds it, and the gain of some ω divides what is left.
            let rounding = ulps::<T>(800.0 * 40.0);
            let found = |rates: Vec<T>| rates[k as usize];
            assert_abs_diff_eq!(
                found(rates(first, h, 320, parabola)),
                t - delay,
                epsilon = rounding
            );
            assert_abs_diff_eq!(found(rates(second, h, 320, parabola)), t, epsilon = rounding);
        }
    }
}

/// q = 0.
fn for_long_periods_it_is_the_difference_quotient<T: Scalar>() {
    let signal = |t: f64| (0.1 * t).sin();
    let difference = rates::<T>(BackwardDifference::new(), 4.0, 50, signal);
    let observed = rates(HighGain::first_order(real(1e3)).unwrap(), 4.0, 50, signal);
    for (one, other) in difference.into_iter().zip(observed) {
        assert_abs_diff_eq!(one, other, epsilon = ulps(4.0));
    }
}

/// V = ε₀² − 2·ε₀·ε₁/ω + 3·(ε₁/ω)² solves FᵀP + PF = −2 for the observer in continuous time. Here y = 0, so the estimates are the errors.
#[test]
fn no_sequence_of_periods_upsets_the_first_order() {
    proptest!(cases(300), |(omega in 0.1..50.0_f64, kick in -1.0..1.0_f64, decades in prop::collection::vec(-5.0..3.0_f64, 30))| {
        let mut source = HighGain::first_order(omega).unwrap();
        let v = |source: &HighGain<f64, 2>| {
            let [value, rate] = source.estimates().unwrap();
            let rate = rate / omega;
            value * value - 2.0 * value * rate + 3.0 * rate * rate
        };
        source.update(kick, 1.0).unwrap();
        for decade in decades {
            let before = v(&source);
            source.update(0.0, 10.0_f64.powf(decade) / omega).unwrap();
            prop_assert!(v(&source) < before || before < 1e-250);
        }
    });
}

/// Random periods over four decades: 400 samples leave nothing.
#[test]
fn random_periods_do_not_upset_the_second_order() {
    proptest!(cases(100), |(decades in prop::collection::vec(-2.0..2.0_f64, 400))| {
        let mut source = HighGain::second_order(1.0).unwrap();
        source.update(1.0, 1.0).unwrap();
        let total: f64 = decades.iter().map(|decade| 10.0_f64.powf(*decade)).sum();
        for decade in decades {
            source.update(0.0, 10.0_f64.powf(decade)).unwrap();
        }
        prop_assume!(total > 100.0);
        prop_assert!(source.estimates().unwrap().iter().all(|z| z.abs() < 1e-9));
    });
}

/// A parabola and the noise that has the sign of the response, last sample first, attain it together.
#[test]
fn the_error_bound_is_attained_and_never_exceeded() {
    for (omega, h) in CASES {
        let source = HighGain::first_order(omega).unwrap();
        let (bound, noise) = (2.0, 0.03);
        let allowed = source.error_bound(bound, noise, h).unwrap();
        let samples = (40.0 / (omega * h)) as u32 + 10;
        let response = impulse_response(source, h, samples);
        let worst = |k: u32| response[(samples - 1 - k) as usize].signum();
        let t = |k: u32| f64::from(k) * h;
        let mut attained = source;
        let mut rate = 0.0;
        for k in 0..samples {
            rate = attained.update(0.5 * bound * t(k) * t(k) - noise * worst(k), h).unwrap();
        }
        assert_relative_eq!(bound * t(samples - 1) - rate, allowed, max_relative = 1e-9);

        // ÿ of either sign from sample to sample, and noise likewise.
        let (mut source, mut rng, mut y, mut v) = (source, rng(), 0.0, 0.0);
        for k in 0..20 * samples {
            let acceleration = bound * f64::from(rng.random_range(0..2_i32) * 2 - 1);
            let rate = source.update(y + noise * rng.random_range(-1.0..1.0), h).unwrap();
            prop_assert_within(k > samples, rate - v, allowed);
            y += h * v + 0.5 * h * h * acceleration;
            v += h * acceleration;
        }
    }
}

fn prop_assert_within(settled: bool, error: f64, allowed: f64) {
    assert!(!settled || error.abs() <= allowed, "{error} > {allowed}");
}

/// In the limit of short periods it is 2L/ω + 2εω/e.
#[test]
fn the_error_bound_has_the_limit_of_continuous_time() {
    let found = HighGain::first_order(10.0).unwrap().error_bound(3.0, 0.01, 1e-6).unwrap();
    assert_relative_eq!(
        found,
        2.0 * 3.0 / 10.0 + 2.0 * 0.01 * 10.0 / 1.0_f64.exp(),
        max_relative = 1e-4
    );
}

#[test]
fn the_bandwidth_for_noise_makes_the_largest_mean_square_error_the_least() {
    for (noise, bound, h) in [(1e-3, 1.0, 1e-3_f64), (0.02, 5.0, 0.01), (2.0, 0.1, 0.05)] {
        let first = HighGain::<f64, 2>::for_noise(noise, bound, h).unwrap().bandwidth();
        let cost =
            |omega: f64| (2.0 * bound / omega).powi(2) + noise * noise * h * omega.powi(3) / 4.0;
        assert!(is_least_at(cost, first));
        let second = HighGain::<f64, 3>::for_noise(noise, bound, h).unwrap().bandwidth();
        let cost = |omega: f64| {
            (3.0 * bound / omega.powi(2)).powi(2) + 1.75 * noise * noise * h * omega.powi(3)
        };
        assert!(is_least_at(cost, second));
    }
}

fn a_parameter_out_of_range_is_refused<T: Scalar>() {
    for bad in [0.0, -1.0] {
        let refused = |name| Error::NotPositive { name, value: bad };
        let [bad, one] = [bad, 1.0].map(real::<T>);
        assert_eq!(HighGain::first_order(bad).unwrap_err(), refused("bandwidth"));
        assert_eq!(HighGain::second_order(bad).unwrap_err(), refused("bandwidth"));
        assert_eq!(HighGain::<T, 2>::for_noise(bad, one, one).unwrap_err(), refused("noise"));
        assert_eq!(
            HighGain::<T, 3>::for_noise(one, bad, one).unwrap_err(),
            refused("bound on the rate")
        );
        assert_eq!(HighGain::<T, 2>::for_noise(one, one, bad).unwrap_err(), refused("dt"));
        assert_eq!(HighGain::first_order(one).unwrap().delay(bad).unwrap_err(), refused("dt"));
    }
    for bad in NOT_FINITE {
        let refused = HighGain::first_order(real::<T>(bad)).unwrap_err();
        assert!(matches!(refused, Error::NonFinite { name: "bandwidth", .. }));
    }
    let source = HighGain::first_order(T::one()).unwrap();
    let refused = |name| Error::Negative { name, value: -1.0 };
    assert_eq!(
        source.error_bound(-T::one(), T::one(), T::one()).unwrap_err(),
        refused("bound on the rate")
    );
    assert_eq!(source.error_bound(T::one(), -T::one(), T::one()).unwrap_err(), refused("noise"));
}
