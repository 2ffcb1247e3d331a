//! A flexible joint whose model is wrong: what of that learning removes, and where the loop comes to rest with what it cannot see.

use brunovsky::{
    controller::{Clelc, Controller, Decoupling, FeedbackLinearization, Gains, Reference},
    fuzzy::FuzzyNetwork,
    learning::{ModelAided, NeuroFuzzy, SlidingMode},
    plant::{Decouplable, FlexibleJoint, IntegratorChain, Linearized, SmoothPlant},
    simulation::Simulation,
};
use nalgebra::SVector;

const LINK: f64 = 1.0;
const MOTOR: f64 = 0.5;
const STIFFNESS: f64 = 500.0;
const WEIGHT: f64 = 10.0;
const LAMBDA: f64 = 20.0;
const GOAL: f64 = 0.8;

fn joint(link: f64, motor: f64, stiffness: f64, weight: f64) -> FlexibleJoint<f64> {
    FlexibleJoint::new(link, motor, stiffness, weight).unwrap()
}

fn model() -> Linearized<FlexibleJoint<f64>, 4, 4, 1> {
    joint(LINK, MOTOR, STIFFNESS, WEIGHT).linearized([0.0; 4]).unwrap()
}

/// The state after four seconds, e⁻⁸⁰ of the transient, from rest near the goal.
fn at_rest<C>(truth: &FlexibleJoint<f64>, controller: C) -> SVector<f64, 4>
where
    C: Controller<4, 1, Scalar = f64, Reference = [Reference<f64, 4>; 1]>,
{
    let (start, _) = truth.equilibrium(0.7);
    let reference = |_| [Reference::setpoint(GOAL)];
    let run = Simulation::new(truth, controller, reference, start, 0.001).unwrap();
    run.until(4.0).unwrap().last().unwrap().unwrap().x
}

fn flc() -> FeedbackLinearization<IntegratorChain<f64, 4>, 4> {
    FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(LAMBDA).unwrap())
}

fn under_flc(truth: &FlexibleJoint<f64>) -> SVector<f64, 4> {
    at_rest(truth, Decoupling::new(model(), [flc()]))
}

fn under_clelc(truth: &FlexibleJoint<f64>) -> SVector<f64, 4> {
    let network = FuzzyNetwork::<_, 4, 2>::evenly_spaced([0.1, 2.0, 40.0, 800.0]).unwrap();
    let learner = NeuroFuzzy::new(network, ModelAided::new(), SlidingMode::new(1e5).unwrap());
    at_rest(truth, Decoupling::new(model(), [Clelc::new(flc(), learner)]))
}

/// Joints with another motor, spring and payload, and with all of them.
fn truths() -> [FlexibleJoint<f64>; 4] {
    [
        joint(LINK, 1.4 * MOTOR, STIFFNESS, WEIGHT),
        joint(LINK, MOTOR, 0.8 * STIFFNESS, WEIGHT),
        joint(1.1 * LINK, MOTOR, STIFFNESS, 1.2 * WEIGHT),
        joint(1.1 * LINK, 1.2 * MOTOR, 1.3 * STIFFNESS, 1.2 * WEIGHT),
    ]
}

/// At rest the true spring carries the true weight, so the model with its own sees z₃ = ((k̂/k)·w − ŵ)·sin q/Î.
fn seen_acceleration(q: f64, stiffness: f64, weight: f64) -> f64 {
    (STIFFNESS / stiffness * weight - WEIGHT) * q.sin() / LINK
}

/// s = 0 and ė_n = 0 leave k·e = 0 for e = (r − q, 0, −z₃, 0), with k₃/k₁ = 6/λ².
#[test]
fn under_learning_it_rests_where_the_model_sees_no_error() {
    let parameters = [
        (STIFFNESS, WEIGHT),
        (0.8 * STIFFNESS, WEIGHT),
        (STIFFNESS, 1.2 * WEIGHT),
        (1.3 * STIFFNESS, 1.2 * WEIGHT),
    ];
    for (truth, (stiffness, weight)) in truths().iter().zip(parameters) {
        let x = under_clelc(truth);
        let expected = 6.0 / (LAMBDA * LAMBDA) * seen_acceleration(x[0], stiffness, weight);
        assert!((GOAL - x[0] - expected).abs() < 1e-8, "{} {expected}", GOAL - x[0]);
    }
}

/// At rest ν = a(x) + b(x)·u, with the u that holds the true joint there: k₁·(r − q) = k₃·z₃ + a(x) + b(x)·u.
#[test]
fn without_learning_the_matched_part_adds_to_that() {
    for truth in truths() {
        let x = under_flc(&truth);
        let (rest, torque) = truth.equilibrium(x[0]);
        assert!((x - rest).amax() < 1e-8, "{x} {rest}");
        let at = model().linearization(&rest).unwrap();
        let nu = at.drift[0] + at.matrix[0] * torque;
        let k = *Gains::<f64, 4>::from_lambda(LAMBDA).unwrap().as_vector();
        let expected = (k[2] * at.chains[0][2] + nu) / k[0];
        assert!((GOAL - x[0] - expected).abs() < 1e-8, "{} {expected}", GOAL - x[0]);
    }
}

/// J stands in the last equation alone, so z is right, and so is what is learned.
#[test]
fn a_wrong_motor_leaves_nothing_under_learning() {
    let x = under_clelc(&truths()[0]);
    assert!((GOAL - x[0]).abs() < 1e-9, "{x}");
}
