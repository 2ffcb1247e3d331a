//! What is lost when the network is trained on the feedback alone.

use brunovsky::{
    controller::{ClelcCommand, Reference},
    learning::{ErrorRate, FeedbackError, Measured, SlidingMode, Switching},
    plant::{IntegratorChain, Uncertain},
    simulation::Sample,
};
use nalgebra::SVector;

use crate::support::{learning, run};

type Run<const N: usize> = Vec<Sample<f64, Reference<f64, N>, ClelcCommand<f64>, N, 1>>;

const SIZE: f64 = 0.7;

/// ẋ = u + Δ from rest, Δ = 0.7, u_b = κe, α beyond every reach: the set-valued sign asks for u_b at once.
fn on_the_chain<E: ErrorRate<f64, 1> + Clone>(error_rate: E, kappa: f64, dt: f64) -> Run<1> {
    let model = IntegratorChain::<f64, 1>::new();
    let plant = Uncertain::matched(model, |_: f64, _: &_, _: &_| SIZE);
    let rule = SlidingMode::new(1e6).unwrap();
    let clelc = learning(model, kappa, error_rate, rule);
    run(&plant, clelc, |_| Reference::setpoint(0.0), [0.0], dt, 200.0 * dt)
}

/// e⁺ = e − h·(κe + u_n + Δ) and u_n = u_n⁻ + κe, so e(k+2) = (2 − 2κh)·e(k+1) − (1 − κh)·e(k), a pair of poles ρ·e^{±iθ} with
/// ρ² = 1 − κh and cos θ = ρ; and one outside of the unit circle from κh = 4/3 on.
#[test]
fn the_set_valued_sign_makes_it_an_integral_gain_of_one_over_the_period() {
    let (kappa, dt) = (2.0, 0.05);
    let samples = on_the_chain(FeedbackError, kappa, dt);
    let e: Vec<f64> = samples.iter().map(|sample| -sample.x[0]).collect();
    let rho = (1.0 - kappa * dt).sqrt();
    let theta = rho.acos();
    for (k, e) in e.into_iter().enumerate() {
        let k = k as f64;
        // From e(0) = 0 and e(1) = −hΔ.
        let wanted = -dt * SIZE * rho.powf(k - 1.0) * (k * theta).sin() / theta.sin();
        approx::assert_abs_diff_eq!(e, wanted, epsilon = 1e-14);
    }
    let last = |share: f64| on_the_chain(FeedbackError, share * 4.0 / 3.0 / dt, dt)[200].x[0].abs();
    assert!(last(0.9) < 1e-6 && last(1.1) > 100.0, "{} {}", last(0.9), last(1.1));
}

/// With ė_n the network answers to Δ at the sample at which Δ sets in; without, e has to move first.
#[test]
fn what_the_rate_tells_at_once_the_feedback_tells_after_the_error() {
    let dt = 0.05;
    // At the first sample the sensor does not know yet what u will bring about; at the second it has seen Δ.
    let told = on_the_chain(Measured, 2.0, dt);
    approx::assert_abs_diff_eq!(told[1].command.u_n, -SIZE, epsilon = 1e-12);
    let untold = on_the_chain(FeedbackError, 2.0, dt);
    approx::assert_abs_diff_eq!(untold[1].command.u_n, -2.0 * SIZE * dt, epsilon = 1e-12);
    // −(u_n + Δ) is −0.7 there, and s = u_b a tenth of it.
    assert!((untold[1].command.s + SIZE).abs() > 0.5);
}

#[test]
fn a_constant_uncertainty_is_still_learned_completely() {
    let model = IntegratorChain::<f64, 2>::new();
    let plant = Uncertain::matched(model, |_: f64, _: &_, _: &_| SIZE);
    let layered = Switching::Implicit { delta: 5.0 };
    let rule = SlidingMode::new(5.0).unwrap().with_switching(layered).unwrap();
    let clelc = learning(model, 2.0, FeedbackError, rule);
    let samples = run(&plant, clelc, |_| Reference::setpoint(0.5), [0.0, 0.0], 0.01, 60.0);
    let last = samples.last().unwrap();
    approx::assert_abs_diff_eq!(last.command.u_n, -SIZE, epsilon = 1e-8);
    approx::assert_abs_diff_eq!(last.x, SVector::from([0.5, 0.0]), epsilon = 1e-8);
}
