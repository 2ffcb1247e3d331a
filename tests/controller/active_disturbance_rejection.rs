//! Active disturbance rejection: the poles of the observer, its errors against their bounds, and the loop of a plant that nobody knows.

use brunovsky::{
    Error, Scalar,
    channel::Saturation,
    controller::{ActiveDisturbanceRejection, Controller, Gains, Limited, Measurement, Reference},
    differentiator::{Differentiator, HighGain},
    plant::{FeedbackLinearizable, Pendulum, Uncertain},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{flc, num, real, run},
};

const B0: f64 = 1.6;

fn adrc<const N: usize>(bandwidth: f64) -> ActiveDisturbanceRejection<f64, N> {
    let gains = Gains::from_lambda(1.0).unwrap();
    ActiveDisturbanceRejection::new(gains, bandwidth, B0).unwrap()
}

/// A chain y⁽ᴺ⁾ = f + b₀·u with ḟ and u constant over a period: its Taylor polynomial.
#[derive(Debug, Clone, Copy)]
struct Truth<const N: usize> {
    x: SVector<f64, N>,
    f: f64,
}

impl<const N: usize> Truth<N> {
    fn after(self, u: f64, rate: f64, h: f64) -> Self {
        let power = |j: usize| h.powi(j as i32) / (1..=j).map(|k| k as f64).product::<f64>();
        let x = SVector::from_fn(|i, _| {
            let chain = (i..N).map(|j| self.x[j] * power(j - i)).sum::<f64>();
            chain + (self.f + B0 * u) * power(N - i) + rate * power(N - i + 1)
        });
        Self { x, f: self.f + rate * h }
    }

    /// f − f̂ and y − z₁ after each of the periods, in which u and ḟ are as given and u is reported.
    fn observed(
        mut self,
        observer: &mut ActiveDisturbanceRejection<f64, N>,
        periods: impl IntoIterator<Item = (f64, f64)>,
        h: f64,
    ) -> Vec<[f64; 2]> {
        let mut arrived = 0.0;
        let errors = periods.into_iter().map(|(u, rate)| {
            // Of the state only y is true.
            let told = SVector::from_fn(|i, _| if i == 0 { self.x[0] } else { 0.0 });
            let measurement = Measurement::new(told).with_applied([arrived]);
            let seen = observer.update(&measurement, &Reference::setpoint(0.0), h).unwrap();
            let errors = [self.f - seen.f, self.x[0] - seen.z[0]];
            arrived = u;
            self = self.after(u, rate, h);
            errors
        });
        errors.collect()
    }
}

/// With a constant f the errors obey (E − q)ᴺ⁺¹ = 0, E the shift by a sample.
fn all_poles_are_where_they_are_said_to_be<const N: usize>(inputs: &[f64], wh: f64) {
    let h = 0.1;
    let start = Truth { x: SVector::<f64, N>::from_fn(|i, _| 1.0 - 0.7 * i as f64), f: 0.6 };
    let periods = inputs.iter().map(|u| (*u, 0.0));
    let errors = start.observed(&mut adrc(wh / h), periods, h);
    let q = (-wh).exp();
    let scale = errors.iter().flatten().map(|error| error.abs()).fold(1.0, f64::max);
    for window in errors.windows(N + 2).skip(1) {
        for kind in 0..2 {
            let (mut sum, mut weight) = (0.0, 1.0);
            for (j, error) in window.iter().rev().enumerate() {
                sum += weight * error[kind];
                weight *= -q * (N + 1 - j) as f64 / (j + 1) as f64;
            }
            // f̂ has roundings of y divided by hᴺ in it.
            let rounding = 1e-13 * scale / if kind == 0 { h.powi(N as i32) } else { 1.0 };
            assert!(sum.abs() <= rounding, "{N}: {sum} > {rounding}");
        }
    }
}

proptest! {
    #[test]
    fn all_poles_of_the_observer_are_at_q(
        inputs in prop::collection::vec(-1.0..1.0_f64, 30), wh in 0.05..3.0_f64,
    ) {
        all_poles_are_where_they_are_said_to_be::<1>(&inputs, wh);
        all_poles_are_where_they_are_said_to_be::<2>(&inputs, wh);
        all_poles_are_where_they_are_said_to_be::<3>(&inputs, wh);
        all_poles_are_where_they_are_said_to_be::<4>(&inputs, wh);
    }

    /// The bounds hold for every ḟ within L, and for a steady one they are the errors.
    #[test]
    fn the_errors_stay_within_their_bounds_and_attain_them(
        rates in prop::collection::vec(-1.0..1.0_f64, 400), wh in 0.2..2.0_f64, h in 0.01..0.3_f64, l in 0.1..5.0_f64,
    ) {
        fn check<const N: usize>(rates: &[f64], wh: f64, h: f64, l: f64) {
            let observer = adrc::<N>(wh / h);
            let bounds = [observer.disturbance_error(l, h), observer.output_error(l, h)].map(Result::unwrap);
            let start = Truth { x: SVector::<f64, N>::zeros(), f: 0.0 };
            // Whatever the rounding of y, up to L·t^(N+1), is divided by.
            let size = l * (400.0 * h).powi(N as i32 + 1) + 1.0;
            let rounding = [1e-14 * size / h.powi(N as i32), 1e-14 * size];
            let by_chance = rates.iter().map(|rate| (-rate, l * rate));
            for errors in &start.observed(&mut { observer }, by_chance, h)[200..] {
                for kind in 0..2 {
                    assert!(errors[kind].abs() <= bounds[kind] + rounding[kind], "{N}, {kind}");
                }
            }
            let steadily = rates.iter().map(|rate| (*rate, l));
            let errors = start.observed(&mut { observer }, steadily, h)[399];
            for kind in 0..2 {
                let slack = 1e-6 * bounds[kind] + 10.0 * rounding[kind];
                assert!((errors[kind] - bounds[kind]).abs() <= slack, "{N}, {kind}: {errors:?}, {bounds:?}");
            }
        }
        check::<1>(&rates, wh, h, l);
        check::<2>(&rates, wh, h, l);
    }

    /// In order 1, and in order 2 without an input, the observer is the high-gain differentiator.
    #[test]
    fn it_is_the_high_gain_differentiator_of_what_the_input_does_not_explain(
        ys in prop::collection::vec(-1.0..1.0_f64, 20), us in prop::collection::vec(-1.0..1.0_f64, 20), h in 0.02..0.5_f64,
    ) {
        let (mut first, mut second) = (adrc::<1>(4.0), adrc::<2>(4.0));
        let mut alone = HighGain::first_order(4.0).unwrap();
        let mut twice = HighGain::second_order(4.0).unwrap();
        let reference = (Reference::setpoint(0.0), Reference::setpoint(0.0));
        for (y, u) in ys.iter().zip(&us) {
            let state = Measurement::new([*y]).with_applied([*u]);
            let seen = first.update(&state, &reference.0, h).unwrap();
            let f = alone.update_beyond(*y, B0 * u * h, h).unwrap();
            prop_assert!((seen.f - f).abs() <= 1e-12 / h);

            let state = Measurement::new([*y, 0.0]).with_applied([0.0]);
            let seen = second.update(&state, &reference.1, h).unwrap();
            twice.update(*y, h).unwrap();
            let [value, rate, second] = twice.estimates().unwrap();
            prop_assert!((seen.z - SVector::from([value, rate])).amax() <= 1e-12 / h);
            prop_assert!((seen.f - second).abs() <= 1e-12 / (h * h));
        }
    }
}

#[test]
fn the_bounds_tend_to_those_of_continuous_time() {
    let observer = adrc::<2>(8.0);
    let (dt, l) = (1e-6, 3.0);
    let f = observer.disturbance_error(l, dt).unwrap();
    approx::assert_relative_eq!(f, 3.0 * l / 8.0, max_relative = 1e-4);
    let y = observer.output_error(l, dt).unwrap();
    approx::assert_relative_eq!(y, l / 512.0, max_relative = 1e-4);
}

fn pendulum() -> Pendulum<f64> {
    Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap()
}

fn on_pendulum(observer: f64, share: f64) -> ActiveDisturbanceRejection<f64, 2> {
    let gain = pendulum().input_gain(&SVector::zeros());
    let gains = Gains::from_lambda(3.0).unwrap();
    ActiveDisturbanceRejection::new(gains, observer, share * gain).unwrap()
}

/// Of the pendulum it knows b₀ and the angle. Its loop nears that of feedback linearization, which knows all, as 1/ω_o.
#[test]
fn the_loop_tends_to_that_of_a_perfect_model_as_the_bandwidth_grows() {
    let (reference, start) = (|_| Reference::setpoint(0.3), [0.8, 0.0]);
    let ideal = run(&pendulum(), flc(pendulum(), 3.0), reference, start, 1e-4, 4.0);
    let distance = |bandwidth| {
        let samples = run(&pendulum(), on_pendulum(bandwidth, 1.0), reference, start, 1e-4, 4.0);
        let distances = samples.iter().zip(&ideal).map(|(a, b)| (a.x - b.x)[0].abs());
        distances.fold(0.0, f64::max)
    };
    let order = (distance(150.0) / distance(300.0)).log2();
    assert!((order - 1.0).abs() < 0.2, "{order}");
}

/// A constant disturbance, an unknown drift and a b₀ a third off leave nothing of e at rest: f̂ is all of it.
#[test]
fn a_constant_disturbance_leaves_no_error() {
    let plant = Uncertain::matched(pendulum(), |_: f64, _: &_, _: &_| -4.0);
    for share in [0.7, 1.0, 1.5] {
        let controller = on_pendulum(20.0, share);
        let samples = run(&plant, controller, |_| Reference::setpoint(0.3), [0.8, 0.0], 0.01, 25.0);
        let last = samples.last().unwrap();
        assert!((last.x - SVector::from([0.3, 0.0])).amax() < 1e-9, "{share}: {}", last.x);
        let drift = pendulum().drift(&last.x) - 4.0;
        let gain = pendulum().input_gain(&last.x);
        let disturbance = drift + (1.0 - share) * gain * last.u[0];
        approx::assert_abs_diff_eq!(last.command.f, disturbance, epsilon = 1e-6);
    }
}

/// Told what arrived, the observer keeps to f through a long saturation.
#[test]
fn a_saturated_actuator_is_no_disturbance() {
    let limit = Saturation::symmetric([1.0]).unwrap();
    let law = adrc::<2>(10.0);
    let plant = Uncertain::matched(Gain, |_: f64, _: &_, _: &_| 0.5);
    let samples = run(
        &plant,
        Limited::new(law, limit),
        |_| Reference::setpoint(0.0),
        [-20.0, 0.0],
        0.01,
        40.0,
    );
    assert!(samples.iter().filter(|sample| sample.command.is_limited()).count() > 300);
    let late = samples.iter().skip(300);
    assert!(late.clone().all(|sample| (sample.command.asked.f - 0.5).abs() < 1e-6));
    assert!(samples.last().unwrap().x.amax() < 1e-6);
}

/// ẍ = b₀·u.
struct Gain;

impl FeedbackLinearizable<2> for Gain {
    type Scalar = f64;

    fn drift(&self, _: &SVector<f64, 2>) -> f64 {
        0.0
    }

    fn input_gain(&self, _: &SVector<f64, 2>) -> f64 {
        B0
    }
}

fn shares_in_any_precision<T: Scalar>() {
    let gains = Gains::<T, 2>::from_lambda(num(3.0)).unwrap();
    let mut controller = ActiveDisturbanceRejection::new(gains, num(6.0), num(2.0)).unwrap();
    let reference = Reference::new([1.0, 0.5].map(num::<T>), num(0.25));
    let state = Measurement::new([0.5, 7.0].map(num::<T>));
    let first = controller.update(&state, &reference, num(0.125)).unwrap();
    // z = (0.5, 0): u_b = 9·0.5 + 6·0.5 and u = (0.25 + 7.5)/2.
    assert_eq!(first.z, SVector::from([num(0.5), T::zero()]));
    assert_eq!((first.u_b, first.f, first.u), (num(7.5), T::zero(), num(3.875)));
    // That is b₀·u = 7.75 for 1/8 s: ½·7.75/64 of y and 7.75/8 of ẏ, just as predicted.
    let state = Measurement::new([0.5 + 7.75 / 128.0, 0.0].map(num::<T>));
    let second = controller.update(&state, &reference, num(0.125)).unwrap();
    let rounding = 100.0 * real(T::default_epsilon());
    approx::assert_abs_diff_eq!(real(second.z[1]), 7.75 / 8.0, epsilon = rounding);
    approx::assert_abs_diff_eq!(real(second.f), 0.0, epsilon = 10.0 * rounding);
}

at_f32_and_f64! {
    the_shares_are_those_of_the_law => shares_in_any_precision,
}

#[test]
fn a_bad_parameter_or_call_is_named_and_leaves_no_trace() {
    let gains = Gains::<f64, 1>::from_lambda(1.0).unwrap();
    let refused =
        |bandwidth, b0| ActiveDisturbanceRejection::new(gains, bandwidth, b0).unwrap_err();
    assert_eq!(refused(0.0, 1.0), Error::NotPositive { name: "bandwidth", value: 0.0 });
    assert_eq!(refused(1.0, 0.0), Error::Singular { name: "b0", value: 0.0 });
    assert!(matches!(refused(1.0, f64::NAN), Error::NonFinite { name: "b0", .. }));

    let mut controller = adrc::<1>(5.0);
    let reference = Reference::setpoint(0.0);
    controller.update(&Measurement::new([0.3]), &reference, 0.1).unwrap();
    let before = controller;
    for (x, dt, name) in [(f64::NAN, 0.1, "x"), (0.3, 0.0, "dt"), (1e307, 0.1, "y/dt^n")] {
        let error = controller.update(&Measurement::new([x]), &reference, dt).unwrap_err();
        assert!(error.to_string().starts_with(name), "{error}");
        assert_eq!(controller, before);
    }
    assert!(controller.disturbance_error(-1.0, 0.1).is_err());
    assert!(controller.output_error(1.0, 0.0).is_err());
    controller.reset();
    assert_eq!(controller, adrc::<1>(5.0));
}
