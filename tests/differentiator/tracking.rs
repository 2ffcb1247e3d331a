use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    differentiator::{Differentiator, HighGain, Tracking},
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, cases, rates, real, ulps};

in_both_precisions! {
    in_the_layer_it_is_the_high_gain_observer,
    the_acceleration_stays_within_its_limit,
    a_parameter_out_of_range_is_refused,
}

/// The rate has the transfer function (h/T²)·(1 − z⁻¹)/(1 − (1 − h/T)·z⁻¹)² there.
fn in_the_layer_it_is_the_high_gain_observer<T: Scalar>() {
    let signal = |t: f64| (3.0 * t).sin() + 0.1 * (40.0 * t).cos();
    for (h, horizon) in [(0.05, 0.2), (0.01, 0.1), (0.05, 0.06)] {
        let tracked = rates::<T>(Tracking::new(real(1e6), real(horizon)).unwrap(), h, 300, signal);
        let omega = -(1.0_f64 - h / horizon).ln() / h;
        let observed = rates::<T>(HighGain::first_order(real(omega)).unwrap(), h, 300, signal);
        for (one, other) in tracked.into_iter().zip(observed) {
            assert_abs_diff_eq!(one, other, epsilon = ulps(500.0 / h));
        }
    }
}

/// Time-optimal: accelerate for half of the way, brake for the other half. A step of S takes 2·√(S/r) at a peak of √(S·r), and the layer T more.
#[test]
fn a_step_is_reached_in_the_least_time_without_overshoot() {
    let h = 1e-3;
    for (size, r) in [(1.0, 4.0), (10.0, 2.5), (0.3, 30.0)] {
        let mut source = Tracking::new(r, 5.0 * h).unwrap();
        source.update(0.0, h).unwrap();
        let time = 2.0 * f64::sqrt(size / r);
        let (mut reached, mut peak) = (None, 0.0_f64);
        for k in 0..(2.0 * time / h) as u32 {
            peak = peak.max(source.update(size, h).unwrap());
            let (followed, _) = source.estimates().unwrap();
            assert!(followed <= size * (1.0 + 1e-9));
            if reached.is_none() && followed > 0.999 * size {
                reached = Some(f64::from(k) * h);
            }
        }
        // 99.9 % are reached √0.001·time/2 before the end; the layer costs a few T, and up to one of acceleration.
        let reached = reached.unwrap();
        assert!((0.96 * time..time + 4.0 * 5.0 * h).contains(&reached), "{reached} of {time}");
        let optimal = f64::sqrt(size * r);
        assert!((optimal - r * 5.0 * h..optimal + r * h).contains(&peak), "{peak} of {optimal}");
    }
}

fn the_acceleration_stays_within_its_limit<T: Scalar>() {
    proptest!(cases(50), |(samples in prop::collection::vec((-9.0..9.0_f64, 0.01..0.5_f64), 50))| {
        let (r, mut last): (f64, T) = (2.5, T::zero());
        let mut source = Tracking::new(real(r), real(0.1)).unwrap();
        for (y, dt) in samples {
            let rate: T = source.update(real(y), real(dt)).unwrap();
            prop_assert!((rate - last).abs() <= real::<T>(r * dt) + (rate.abs() + last.abs()) * ulps(4.0));
            last = rate;
        }
    });
}

/// No limit cycle: on a ramp the sampled optimal control comes to rest.
#[test]
fn on_a_ramp_nothing_chatters() {
    for r in [2.0, 200.0, 2e4] {
        let rates: Vec<f64> = rates(Tracking::new(r, 0.01).unwrap(), 0.01, 2000, |t| 0.5 * t);
        assert!(rates[1000..].iter().all(|rate: &f64| (rate - 0.5).abs() < 1e-9));
    }
}

/// Able to stop at y at any time: x₁ is v²/(2r) behind on a ramp of slope v > r·T, where the layer shifts that by a few T.
#[test]
fn on_a_steep_ramp_it_keeps_the_distance_to_brake() {
    let (h, r) = (1e-4, 4.0);
    for slope in [0.5, 2.0] {
        let mut source = Tracking::new(r, 2.0 * h).unwrap();
        for k in 0..100_000_u32 {
            source.update(slope * f64::from(k) * h, h).unwrap();
        }
        let (followed, rate) = source.estimates().unwrap();
        let behind = slope * 99_999.0 * h - followed;
        assert_abs_diff_eq!(rate, slope, epsilon = 1e-9);
        assert_abs_diff_eq!(behind, slope * slope / (2.0 * r), epsilon = 6.0 * h * slope);
    }
}

#[test]
fn for_noise_it_is_as_wide_as_the_high_gain_observer() {
    let (noise, bound, h) = (0.02, 5.0, 1e-3);
    let tracking = Tracking::for_noise(noise, bound, h).unwrap();
    let omega = HighGain::<f64, 2>::for_noise(noise, bound, h).unwrap().bandwidth();
    assert_eq!(
        tracking,
        Tracking::new(2.0 * bound + 3.0 * noise * omega * omega, 1.0 / omega).unwrap()
    );
}

fn a_parameter_out_of_range_is_refused<T: Scalar>() {
    let attempt = |r: f64, horizon: f64| Tracking::<T>::new(real(r), real(horizon));
    for bad in [0.0, -1.0] {
        assert_eq!(attempt(bad, 1.0), Err(Error::NotPositive { name: "acceleration", value: bad }));
        assert_eq!(attempt(1.0, bad), Err(Error::NotPositive { name: "horizon", value: bad }));
    }
    for bad in NOT_FINITE {
        assert!(matches!(attempt(1.0, bad), Err(Error::NonFinite { name: "horizon", .. })));
        assert!(matches!(
            Tracking::for_noise(real::<T>(bad), T::one(), T::one()),
            Err(Error::NonFinite { name: "noise", .. })
        ));
    }
}
