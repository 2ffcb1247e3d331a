//! Derivatives through the closed loop: a run on dual numbers against closed forms and central differences, and where there is no derivative.

use brunovsky::{
    Error, Scalar,
    controller::{Clelc, Decoupling, FeedbackLinearization, Gains, Reference},
    fuzzy::FuzzyNetwork,
    learning::{ModelAided, NeuroFuzzy, SlidingMode, Switching},
    plant::{FlexibleJoint, IntegratorChain, Pendulum, SmoothPlant},
    simulation::Simulation,
};
use nalgebra::SVector;
use num_dual::{Dual64, first_derivative};

use crate::num;

/// ∫(e² + ρ·τ̇²) dt of a pendulum with twice the mass that its controller believes, with the gains (ln λ, ln α).
fn learning<T: Scalar>(gains: SVector<T, 2>) -> Result<T, Error> {
    let [lambda, alpha] = gains.map(|gain| gain.exp()).into();
    let pendulum = |mass: f64| Pendulum::new(num(mass), num(0.5), num(0.1), num(9.81));
    let (believed, truth) = (pendulum(1.0)?, pendulum(2.0)?);
    let flc = FeedbackLinearization::new(believed, Gains::from_lambda(lambda)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([num(0.5), num(1.0)])?;
    let rule = SlidingMode::new(alpha)?.with_switching(Switching::Implicit { delta: num(1.0) })?;
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));
    let sine = |t: T| Reference::new([t.sin(), t.cos()], -t.sin());
    let run = Simulation::new(&truth, clelc, sine, [T::zero(); 2], num(0.01))?.substeps(1)?;
    let (mut cost, mut last) = (T::zero(), T::zero());
    for sample in run.until(num(3.0))? {
        let sample = sample?;
        let (e, torque) = (sample.reference.r[0] - sample.x[0], sample.u[0]);
        let rate = (torque - last) * num(100.0);
        cost += (e * e + rate * rate * num(1e-6)) * num(0.01);
        last = torque;
    }
    Ok(cost)
}

/// ∫e² dt of a flexible joint under feedback linearization, with ln λ and with what of the true stiffness the model knows.
fn linearized<T: Scalar>(parameters: SVector<T, 2>) -> Result<T, Error> {
    let [lambda, known] = parameters.into();
    let joint = |stiffness: T| FlexibleJoint::new(T::one(), num(0.5), stiffness, num(10.0));
    let truth = joint(num(500.0))?;
    let model = joint(known * num(500.0))?.linearized::<4>([T::zero(); 4])?;
    let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(lambda.exp())?);
    let reference = |_| [Reference::setpoint(T::one())];
    let controller = Decoupling::new(model, [flc]);
    let run = Simulation::new(&truth, controller, reference, [T::zero(); 4], num(0.002))?;
    let mut cost = T::zero();
    for sample in run.substeps(1)?.until(num(1.0))? {
        let sample = sample?;
        let e = sample.reference[0].r[0] - sample.x[0];
        cost += e * e * num(0.002);
    }
    Ok(cost)
}

/// A central difference is off by h²/6·f‴ and a fourth-order term: half the step, a quarter of the distance from the gradient.
///
/// The smoothed sign has a second derivative that jumps at s = 0, so `step` has to be so small that no sample's s changes its sign within it.
fn assert_second_order(
    cost: impl Fn(SVector<f64, 2>) -> f64,
    (value, gradient): (f64, SVector<f64, 2>),
    at: SVector<f64, 2>,
    step: f64,
) {
    // The loop compares values alone, so the run on dual numbers is the plain one.
    approx::assert_relative_eq!(value, cost(at), max_relative = 1e-11);
    for i in 0..2 {
        let off = |h: f64| {
            let along = SVector::from_fn(|j, _| if i == j { h } else { 0.0 });
            ((cost(at + along) - cost(at - along)) / (2.0 * h) - gradient[i]).abs()
        };
        let measured = (off(step) / off(step / 2.0)).log2();
        assert!((measured - 2.0).abs() < 0.01, "order {measured} in direction {i}");
        let relative = off(step / 16.0) / gradient[i].abs();
        assert!(relative < 1e-6, "{relative} in direction {i}");
    }
}

#[test]
fn the_gradient_by_learning_rate_and_poles_is_the_limit_of_central_differences() {
    let at = SVector::from([4.0_f64, 60.0]).map(f64::ln);
    let gradient = num_dual::gradient(learning, &at).unwrap();
    assert_second_order(|x| learning(x).unwrap(), gradient, at, 0.005);
}

/// Jets over dual numbers: what differentiation finds of the plant is itself differentiated.
#[test]
fn the_gradient_by_a_parameter_of_a_differentiated_model_is_the_limit_of_central_differences() {
    let at = SVector::from([10.0_f64.ln(), 0.9]);
    let gradient = num_dual::gradient(linearized, &at).unwrap();
    assert_second_order(|x| linearized(x).unwrap(), gradient, at, 0.005);
}

/// ẋ = u under u = λ·(r − x), held for dt: e_k = (1 − λ·dt)ᵏ·e₀, with the derivative −k·dt·(1 − λ·dt)ᵏ⁻¹·e₀ by λ.
#[test]
fn the_derivative_of_a_sampled_integrator_is_the_closed_form() {
    let (lambda, dt) = (1.7, 0.05);
    let plant = IntegratorChain::<Dual64, 1>::new();
    let gains = Gains::from_lambda(Dual64::new(lambda, 1.0)).unwrap();
    let flc = FeedbackLinearization::new(plant, gains);
    let reference = |_| Reference::setpoint(Dual64::from(1.0));
    let run = Simulation::new(&plant, flc, reference, [Dual64::from(0.0)], dt.into()).unwrap();
    for sample in run.until(3.0.into()).unwrap() {
        let sample = sample.unwrap();
        let (k, left) = (sample.k as f64, 1.0 - lambda * dt);
        let expected = k * dt * left.powf(k - 1.0);
        // 60 periods of ten steps, each of which rounds a few times.
        assert!((sample.x[0].eps - expected).abs() < 1e-13, "{} {expected}", sample.x[0]);
        assert!((sample.x[0].re - (1.0 - left.powf(k))).abs() < 1e-13);
    }
}

/// The slopes of ς by s on both sides of where s comes within reach.
fn slopes(switching: Switching<Dual64>) -> [f64; 2] {
    let reach = 0.5;
    [-1e-9, 1e-9].map(|beside| {
        let sign = |s: Dual64| switching.sign(s, Dual64::from(reach));
        first_derivative(sign, reach + beside).1
    })
}

/// The set-valued sign is a clamp; with a boundary layer the implicit sign has a derivative everywhere.
#[test]
fn only_the_set_valued_sign_has_a_kink() {
    assert_eq!(slopes(Switching::SetValued), [2.0, 0.0]);
    assert_eq!(slopes(Switching::Implicit { delta: 0.0.into() }), [2.0, 0.0]);
    let [below, above] = slopes(Switching::Implicit { delta: 0.1.into() });
    assert!((below - above).abs() < 1e-7 && below > 0.1, "{below} {above}");
}
