//! Between samples the plant moves under the held input.

use brunovsky::{
    Scalar,
    controller::{FeedbackLinearization, Gains, Reference},
    integrators::{Euler, Heun, Integrator, Rk4},
    plant::{ControlAffine, IntegratorChain, Pendulum, Plant, Uncertain},
    simulation::Simulation,
};
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;

use super::Scripted;
use crate::{at_f32_and_f64, num};

/// Kutta's 3/8 rule, a formula of order four that the library does not have, in 200 steps a period.
fn integrate_again<P: Plant<2, 1, Scalar = f64>>(
    plant: &P,
    t: f64,
    x: SVector<f64, 2>,
    u: &SVector<f64, 1>,
    dt: f64,
) -> SVector<f64, 2> {
    let h = dt / 200.0;
    (0..200).fold(x, |x, j| {
        let t = t + f64::from(j) * h;
        let f = |part: f64, x: SVector<f64, 2>| plant.derivative(t + part * h, &x, u);
        let k1 = f(0.0, x);
        let k2 = f(1.0 / 3.0, x + k1 * (h / 3.0));
        let k3 = f(2.0 / 3.0, x + (k2 - k1 / 3.0) * h);
        let k4 = f(1.0, x + (k1 - k2 + k3) * h);
        x + (k1 + (k2 + k3) * 3.0 + k4) * (h / 8.0)
    })
}

#[test]
fn the_recorded_input_integrated_again_gives_the_recorded_states() {
    let model = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    let plant = Uncertain::matched(model, |t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>| {
        (3.0 * t).sin() - 0.2 * x[0] * u[0]
    });
    let flc = FeedbackLinearization::new(model, Gains::from_lambda(3.0).unwrap());
    let simulation =
        Simulation::new(&plant, flc, |_| Reference::setpoint(1.0), [-0.5, 2.0], 0.02).unwrap();
    let simulation = simulation.substeps(100).unwrap().until(6.0).unwrap();
    let samples = simulation.collect::<Result<Vec<_>, _>>().unwrap();
    let mut x = samples[0].x;
    for pair in samples.windows(2) {
        x = integrate_again(&plant, pair[0].t, x, &pair[0].u, 0.02);
        // Steps of 0.2 ms at rates of some 10/s: (0.002)⁵/120 a step, 30000 steps, and their rounding.
        approx::assert_abs_diff_eq!(x, pair[1].x, epsilon = 1e-11);
    }
}

/// ZOH on two integrators: x₁⁺ = x₁ + x₂·h + u·h²/2, x₂⁺ = x₂ + u·h.
fn follows_the_held_input<T: Scalar>(inputs: &[f64], dt: f64) {
    let script = |k: usize| SVector::from([num::<T>(inputs[k % inputs.len()])]);
    let chain = IntegratorChain::<T, 2>::new();
    let start = [num::<T>(0.5), num(-1.0)];
    let simulation = Simulation::new(&chain, Scripted::new(script), |t| t, start, num(dt)).unwrap();
    let (mut x, h) = (SVector::from(start), num::<T>(dt));
    for (k, sample) in simulation.take(inputs.len()).enumerate() {
        let sample = sample.unwrap();
        // Rk4 is exact here; ten substeps a period round a dozen times each.
        let scale = x.amax().max(T::one()) * num(inputs.len() as f64);
        approx::assert_abs_diff_eq!(
            sample.x,
            x,
            epsilon = scale * T::default_epsilon() * num(120.0)
        );
        let u = script(k);
        assert_eq!((sample.u, sample.command), (u, u));
        x = SVector::from([x[0] + x[1] * h + u[0] * h * h * num(0.5), x[1] + u[0] * h]);
    }
}

proptest! {
    #[test]
    fn the_input_is_held_over_the_period(inputs in prop::collection::vec(-5.0..5.0_f64, 1..20), dt in 0.01..1.0_f64) {
        follows_the_held_input::<f32>(&inputs, dt);
        follows_the_held_input::<f64>(&inputs, dt);
    }
}

/// The state of a disturbed pendulum after 1 s of a scripted input.
fn end<I: Integrator>(integrator: I, substeps: u32) -> SVector<f64, 2> {
    let pendulum = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    let plant = Uncertain::matched(pendulum, |t: f64, _: &_, _: &_| (3.0 * t).sin());
    let script = Scripted::new(|k: usize| SVector::from([(k as f64).cos()]));
    let simulation = Simulation::new(&plant, script, |t| t, [-0.5, 2.0], 0.25).unwrap();
    let simulation = simulation.integrator(integrator).substeps(substeps).unwrap();
    simulation.until(1.0).unwrap().last().unwrap().unwrap().x
}

/// The hold makes the right-hand side jump only at samples, where steps end: each method keeps its order.
fn converges_with_its_order<I: Integrator + Copy>(integrator: I) {
    let exact = end(Rk4, 4000);
    let error = |substeps| (end(integrator, substeps) - exact).norm();
    let (measured, stated) = ((error(80) / error(160)).log2(), f64::from(I::ORDER));
    assert!((measured - stated).abs() < 0.1, "order {measured}, stated {stated}");
}

#[test]
fn every_integrator_converges_with_its_order_in_the_substeps() {
    converges_with_its_order(Euler);
    converges_with_its_order(Heun);
    converges_with_its_order(Rk4);
    assert_eq!(end(Rk4, 10), {
        let pendulum = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
        let plant = Uncertain::matched(pendulum, |t: f64, _: &_, _: &_| (3.0 * t).sin());
        let script = Scripted::new(|k: usize| SVector::from([(k as f64).cos()]));
        let by_default = Simulation::new(&plant, script, |t| t, [-0.5, 2.0], 0.25).unwrap();
        by_default.until(1.0).unwrap().last().unwrap().unwrap().x
    });
}

/// A constant Δ switched on at the time of sample k: from there x₂ = Δ·τ and x₁ = Δ·τ²/2, τ = t − t_k, and before it nothing moves,
/// in the last bit.
fn a_switch_is_not_smeared<T: Scalar, I: Integrator>(integrator: I, dt: f64, switch: usize) {
    let dt = num::<T>(dt);
    let from = num::<T>(switch as f64) * dt;
    let delta = num::<T>(3.0);
    let plant = Uncertain::matched(IntegratorChain::<T, 2>::new(), |t: T, _: &_, _: &_| {
        if t >= from { delta } else { T::zero() }
    });
    let simulation = Simulation::new(&plant, super::idle(), |t| t, [T::zero(); 2], dt).unwrap();
    let simulation = simulation.integrator(integrator);
    for (k, sample) in simulation.take(switch + 30).enumerate() {
        let x = sample.unwrap().x;
        let tau = num::<T>(k.saturating_sub(switch) as f64) * dt;
        let expected = SVector::from([delta * tau * tau * num(0.5), delta * tau]);
        if k <= switch {
            assert_eq!(x, SVector::<T, 2>::zeros());
        }
        // 30 periods of ten substeps, each a handful of roundings of states up to 3·30·dt.
        let scale = num::<T>(30.0 * 3.0).max(expected.amax());
        approx::assert_abs_diff_eq!(
            x,
            expected,
            epsilon = scale * T::default_epsilon() * num(300.0)
        );
    }
}

fn switches_are_sharp<T: Scalar>() {
    for dt in [0.01, 0.1, 0.3] {
        for switch in [0, 1, 3, 7, 100, 333] {
            a_switch_is_not_smeared::<T, _>(Rk4, dt, switch);
            a_switch_is_not_smeared::<T, _>(Heun, dt, switch);
        }
    }
}

at_f32_and_f64! {
    a_disturbance_that_switches_at_a_sample_acts_from_there_on => switches_are_sharp,
}

/// Speed and turn rate of a unicycle, two inputs that enter through the state.
struct Unicycle;

impl ControlAffine<3, 2> for Unicycle {
    type Scalar = f64;

    fn drift_field(&self, _x: &SVector<f64, 3>) -> SVector<f64, 3> {
        SVector::zeros()
    }

    fn input_fields(&self, x: &SVector<f64, 3>) -> SMatrix<f64, 3, 2> {
        let (sin, cos) = x[2].sin_cos();
        SMatrix::<f64, 3, 2>::new(cos, 0.0, sin, 0.0, 0.0, 1.0)
    }
}

/// Straight on for a metre, a quarter turn on the spot, and so on: a square, back at the start.
#[test]
fn a_plant_with_two_inputs_drives_a_square() {
    let script = |k: usize| match k % 20 {
        0..10 => SVector::from([1.0, 0.0]),
        _ => SVector::from([0.0, core::f64::consts::FRAC_PI_2]),
    };
    let simulation =
        Simulation::new(&Unicycle, Scripted::new(script), |t| t, [0.0, 0.0, 0.0], 0.1).unwrap();
    let samples = simulation.until(8.0).unwrap().collect::<Result<Vec<_>, _>>().unwrap();
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
    for (i, corner) in corners.into_iter().enumerate() {
        let x = samples[20 * i].x;
        let expected =
            SVector::from([corner[0], corner[1], i as f64 * core::f64::consts::FRAC_PI_2]);
        // On every piece x is linear in time, so only rounding is left of 800 substeps.
        approx::assert_abs_diff_eq!(x, expected, epsilon = 800.0 * f64::EPSILON * 4.0);
    }
}
