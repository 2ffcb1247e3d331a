//! Delays and lags in the loop, against recursions and against the plant with the actuator's state in it.

use brunovsky::{
    channel::{Channel, Delay, Ideal, Lag},
    controller::Measurement,
    plant::{IntegratorChain, Plant},
    simulation::{Hardware, Sensor, Sensors, Simulation},
};
use nalgebra::SVector;

use super::Recorded;

const PLANT: IntegratorChain<f64, 1> = IntegratorChain::new();

/// The states at every tick of ẋ = u under u = −x, from 1.
fn states<S, A>(hardware: Hardware<S, A>, dt: f64, ticks: usize) -> Vec<f64>
where
    S: Sensor<f64, 1, 1, Seen = Measurement<f64, 1, 1>>,
    A: Channel<f64, 1>,
{
    let law = Recorded::new(|x: &SVector<f64, 1>| -x[0]);
    let run = Simulation::with_hardware(&PLANT, hardware, law, |t| t, [1.0], dt).unwrap();
    run.ticks().take(ticks).map(|tick| tick.unwrap().x[0]).collect()
}

/// x⁺ = x + h·u with u = −x of `delay` ticks before, 0 before the first.
fn recursion(delay: usize, h: f64, ticks: usize) -> Vec<f64> {
    let mut x: Vec<f64> = vec![1.0];
    while x.len() < ticks {
        let k = x.len() - 1;
        let u = k.checked_sub(delay).map_or(0.0, |k| -x[k]);
        x.push(x[k] + h * u);
    }
    x
}

#[test]
fn a_computation_takes_its_ticks() {
    let late = states(Hardware::new(Ideal, Delay::<f64, 1, 3>::new()), 0.1, 200);
    let in_time = states(Hardware::default(), 0.1, 200);
    for (x, expected) in late.iter().zip(recursion(3, 0.1, 200)) {
        approx::assert_abs_diff_eq!(*x, expected, epsilon = 1e-13);
    }
    for (x, expected) in in_time.iter().zip(recursion(0, 0.1, 200)) {
        approx::assert_abs_diff_eq!(*x, expected, epsilon = 1e-13);
    }
}

/// For a linear loop it does not matter on which side of the controller the signal waits, but for what is in the line at first.
#[test]
fn a_delay_before_the_controller_is_one_behind_it() {
    let sensor = Sensors::of_state(Delay::<f64, 1, 3>::new());
    let before = states(Hardware::new(sensor, Ideal), 0.1, 100);
    let behind = states(Hardware::new(Ideal, Delay::<f64, 1, 3>::new()), 0.1, 100);
    for (before, behind) in before.iter().zip(behind) {
        approx::assert_abs_diff_eq!(*before, behind, epsilon = 1e-13);
    }
}

/// z^(d+1) − z^d + h = 0 has all roots within the unit circle up to h = 2·sin(π/(2·(2d + 1))), which is 2·sin(π/10) for d = 2.
#[test]
fn the_loop_becomes_unstable_at_the_delay_of_theory() {
    let limit = 2.0 * (core::f64::consts::PI / 10.0).sin();
    let grows = |h: f64| {
        let x = states(Hardware::new(Ideal, Delay::<f64, 1, 2>::new()), h, 2000);
        x[1900..].iter().fold(0.0_f64, |most, x| most.max(x.abs())) > 1.0
    };
    assert!(!grows(0.99 * limit));
    assert!(grows(1.01 * limit));
}

/// ẋ = y, τ·ẏ = u − y: the actuator's state in the plant.
struct Lagged;

impl Plant<2, 1> for Lagged {
    type Scalar = f64;

    fn derivative(&self, _t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>) -> SVector<f64, 2> {
        SVector::from([x[1], (u[0] - x[1]) / 0.2])
    }
}

/// ẋ = u − x.
struct Friction;

impl Plant<1, 1> for Friction {
    type Scalar = f64;

    fn derivative(&self, _t: f64, x: &SVector<f64, 1>, u: &SVector<f64, 1>) -> SVector<f64, 1> {
        u - x
    }
}

/// The same behind the lag: ẋ = y − x, τ·ẏ = u − y.
struct LaggedFriction;

impl Plant<2, 1> for LaggedFriction {
    type Scalar = f64;

    fn derivative(&self, _t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>) -> SVector<f64, 2> {
        SVector::from([x[1] - x[0], (u[0] - x[1]) / 0.2])
    }
}

/// The plant with the actuator's state in it is the truth; the error of the held mean is of second order in the actuators' period.
#[test]
fn a_lag_converges_to_the_actuator_in_the_plant() {
    // The controller's period is 0.4 s throughout.
    let end = |pieces: u32| {
        let lag = Lag::new([0.2]).unwrap();
        let hardware = Hardware::new(Ideal, lag).every(pieces, pieces, 1).unwrap();
        let law = Recorded::new(|x: &SVector<f64, 1>| 1.0 - x[0]);
        let dt = 0.4 / f64::from(pieces);
        let run = Simulation::with_hardware(&Friction, hardware, law, |t| t, [0.0], dt).unwrap();
        run.until(2.0).unwrap().last().unwrap().unwrap().x[0]
    };
    let law = Recorded::new(|x: &SVector<f64, 2>| 1.0 - x[0]);
    let truth = Simulation::new(&LaggedFriction, law, |t| t, [0.0, 0.0], 0.4).unwrap();
    let truth = truth.substeps(200).unwrap().until(2.0).unwrap().last().unwrap().unwrap().x[0];
    let errors = [4, 8, 16, 32].map(|pieces| (end(pieces) - truth).abs());
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "order {order} of {errors:?}");
    }
}

/// Without friction the held mean is exact.
#[test]
fn a_lag_before_an_integrator_is_exact() {
    let lag = Lag::new([0.2]).unwrap();
    let held = states(Hardware::new(Ideal, lag), 0.1, 100);
    let law = Recorded::new(|x: &SVector<f64, 2>| -x[0]);
    let truth =
        Simulation::new(&Lagged, law, |t| t, [1.0, 0.0], 0.1).unwrap().substeps(100).unwrap();
    for (held, truth) in held.iter().zip(truth) {
        approx::assert_abs_diff_eq!(*held, truth.unwrap().x[0], epsilon = 1e-10);
    }
}
