//! What the controller is told at a sample, and in which order.

use brunovsky::{
    Scalar,
    controller::{Controller, FeedbackLinearization, Gains, Measurement, Reference},
    plant::{IntegratorChain, Plant, Uncertain},
    simulation::Simulation,
};
use nalgebra::SVector;

use super::{Scripted, idle};
use crate::{at_f32_and_f64, num};

/// x at the sample, ẋ under the input of the period before, that input (0 before the first), the time, and the period.
fn tells_the_controller_what_happened<T: Scalar>() {
    let plant =
        Uncertain::matched(IntegratorChain::<T, 2>::new(), |_: T, x: &SVector<T, 2>, _: &_| -x[0]);
    let script = |k: usize| SVector::from([num::<T>(k as f64 - 3.0)]);
    let mut controller = Scripted::new(script);
    let dt = num::<T>(0.125);
    let simulation =
        Simulation::new(&plant, &mut controller, |t| t, [1.0, 2.0].map(num), dt).unwrap();
    let samples = simulation.take(10).collect::<Result<Vec<_>, _>>().unwrap();
    let mut applied = SVector::zeros();
    for (sample, (measurement, time, period)) in samples.iter().zip(&controller.heard) {
        let x_dot = plant.derivative(sample.t, &sample.x, &applied);
        let expected = Measurement::new(sample.x).with_rate(x_dot).with_applied(applied);
        assert_eq!(*measurement, expected);
        assert_eq!((*time, *period), (sample.t, dt));
        assert_eq!(sample.reference, sample.t);
        applied = sample.u;
    }
    assert_eq!(controller.heard.len(), samples.len());
}

/// A sensor at the switch of a disturbance still sees the period before; at the start there is none, and it sees the start.
fn measures_the_rate_just_before<T: Scalar>() {
    let dt = num::<T>(0.1);
    for switch in [0, 1, 3, 17] {
        let from = num::<T>(f64::from(switch)) * dt;
        let plant = Uncertain::matched(IntegratorChain::<T, 1>::new(), |t: T, _: &_, _: &_| {
            if t >= from { T::one() } else { T::zero() }
        });
        let mut controller = idle();
        let simulation = Simulation::new(&plant, &mut controller, |t| t, [T::zero()], dt).unwrap();
        assert_eq!(simulation.take(20).filter(Result::is_err).count(), 0);
        for (k, (measurement, ..)) in controller.heard.iter().enumerate() {
            let on = k as i32 > switch || switch == 0;
            let expected = if on { T::one() } else { T::zero() };
            assert_eq!(
                measurement.x_dot,
                Some(SVector::from([expected])),
                "sample {k}, switch {switch}"
            );
        }
    }
}

at_f32_and_f64! {
    the_controller_is_told_state_rate_input_time_and_period => tells_the_controller_what_happened,
    the_rate_is_that_just_before_the_sample => measures_the_rate_just_before,
}

#[test]
fn the_state_is_that_of_the_last_sample() {
    let plant = IntegratorChain::<f64, 1>::new();
    let script = Scripted::new(|_: usize| SVector::from([1.0]));
    let mut simulation = Simulation::new(&plant, script, |t| t, [7.0], 0.5).unwrap();
    assert_eq!(*simulation.state(), SVector::from([7.0]));
    for k in 0..4 {
        let x = simulation.next().unwrap().unwrap().x;
        assert_eq!(*simulation.state(), x);
        // Halves and tenths of halves: the error is that of ten additions.
        approx::assert_abs_diff_eq!(x[0], 7.0 + 0.5 * f64::from(k), epsilon = 1e-13);
    }
}

#[test]
fn a_controller_passed_by_reference_comes_back_and_can_go_on() {
    let plant = IntegratorChain::<f64, 1>::new();
    let mut controller = Scripted::new(|k: usize| SVector::from([k as f64]));
    let first = Simulation::new(&plant, &mut controller, |t| t, [0.0], 1.0).unwrap();
    assert_eq!(first.take(3).map(|sample| sample.unwrap().u[0]).sum::<f64>(), 0.0 + 1.0 + 2.0);
    // A new simulation starts its own clock; the controller goes on counting.
    let second = Simulation::new(&plant, &mut controller, |t| t, [0.0], 1.0).unwrap();
    let samples = second.take(2).collect::<Result<Vec<_>, _>>().unwrap();
    assert_eq!([samples[0].u[0], samples[1].u[0]], [3.0, 4.0]);
    assert_eq!([samples[0].t, samples[1].t], [0.0, 1.0]);
    controller.reset();
    assert!(controller.heard.is_empty());
}

/// The reference is asked for once a sample, in order, and may keep a state.
#[test]
fn the_reference_is_taken_once_a_sample() {
    let plant = IntegratorChain::<f64, 1>::new();
    let flc = FeedbackLinearization::new(plant, Gains::new([1.0]).unwrap());
    let mut asked = Vec::new();
    let reference = |t| {
        asked.push(t);
        Reference::setpoint(t)
    };
    let simulation = Simulation::new(&plant, flc, reference, [0.0], 0.25).unwrap();
    let times: Vec<_> = simulation.take(5).map(|sample| sample.unwrap().t).collect();
    assert_eq!(times, [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(asked, times);
}
