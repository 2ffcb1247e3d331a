//! Decoupling control: the joints of an arm as separate chains, the uncertainty of an unknown payload, and failures without a trace.

mod equations;
mod failures;
mod learning;

use brunovsky::{
    Error, Scalar,
    controller::{
        ChainControllers, Clelc, ClelcCommand, Controller, Decoupling, FeedbackLinearization,
        Gains, Measurement, Padded, Reference,
    },
    fuzzy::FuzzyNetwork,
    learning::{
        BackwardDifference, ErrorRate, Measured, ModelAided, NeuroFuzzy, NullCompensator,
        SlidingMode,
    },
    plant::{
        Decouplable, FeedbackLinearizable, IntegratorChain, Link, Pendulum, Plant, TwoLinkArm,
    },
    simulation::Simulation,
};
use nalgebra::{Matrix2, SMatrix, SVector};

use crate::{
    at_f32_and_f64,
    support::{Learning, error_dynamics, flc, num, real, run},
};

type Chain<T> = IntegratorChain<T, 2>;
type Joint<T> = FeedbackLinearization<Chain<T>, 2>;

fn joint<T: Scalar>(lambda: f64) -> Joint<T> {
    flc(Chain::new(), lambda)
}

fn learner<T: Scalar, E: ErrorRate<T, 2> + Clone>(error_rate: E) -> Learning<Chain<T>, E, T, 2> {
    let network = FuzzyNetwork::evenly_spaced([num(0.5), num(2.0)]).unwrap();
    Clelc::new(
        joint(4.0),
        NeuroFuzzy::new(network, error_rate, SlidingMode::new(num(200.0)).unwrap()),
    )
}

fn arm<T: Scalar>(payload: f64) -> TwoLinkArm<T> {
    let link = |values: [f64; 4]| {
        let [mass, length, centre, inertia] = values.map(num::<T>);
        Link { mass, length, centre, inertia }
    };
    let links = [link([2.0, 0.35, 0.15, 0.02]), link([1.5, 0.3, 0.2, 0.015])];
    let arm = TwoLinkArm::new(links, [num(0.1), num(0.2)], num(9.81)).unwrap();
    arm.with_payload(num(payload)).unwrap()
}

const POSE: [f64; 2] = [0.4, 0.7];

fn pose(_t: f64) -> [Reference<f64, 2>; 2] {
    POSE.map(Reference::setpoint)
}

/// Two sines, each with its derivatives.
fn waves(t: f64) -> [Reference<f64, 2>; 2] {
    [1.0, 1.7].map(|w| {
        let (sin, cos) = (w * t).sin_cos();
        Reference::new([sin, w * cos], -w * w * sin)
    })
}

/// The largest deviation of the joints' errors from the matrix exponential, each with its own poles, over 2 s.
fn deviation(e0: [[f64; 2]; 2], dt: f64) -> f64 {
    let plant = arm(0.5);
    let joints = [joint::<f64>(3.0), joint(5.0)];
    let start = waves(0.0);
    let x0: [f64; 4] = core::array::from_fn(|i| start[i % 2].r[i / 2] - e0[i % 2][i / 2]);
    let simulation =
        Simulation::new(&plant, Decoupling::new(plant, joints), waves, x0, dt).unwrap();
    let errors = simulation.until(2.0).unwrap().map(|sample| {
        let sample = sample.unwrap();
        let chains = plant.chains(&sample.x);
        (0..2)
            .map(|i| {
                let e = sample.reference[i].r - chains[i];
                let k = joints[i].gains().as_vector();
                (e - error_dynamics(k, &e0[i].into(), sample.t)).norm()
            })
            .fold(0.0, f64::max)
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn the_joints_follow_their_own_error_dynamics_to_first_order_in_the_period() {
    // With e₀ = 0 in one of them, its error dynamics stay at 0: the other's motion does not disturb it.
    for e0 in [[[0.5, -0.3], [-0.4, 1.0]], [[0.0, 0.0], [0.8, 0.0]], [[0.8, 0.0], [0.0, 0.0]]] {
        let measured = (deviation(e0, 0.001) / deviation(e0, 0.0005)).log2();
        assert!((measured - 1.0).abs() < 0.1, "order {measured}");
    }
}

/// What both controllers decide in closed loop on the loaded arm, as (u, ν) of all samples.
fn inputs<C: ChainControllers<f64, 2, 2>>(chains: C) -> Vec<[SVector<f64, 2>; 2]> {
    let (plant, model) = (arm::<f64>(1.0), arm::<f64>(0.0));
    let x0 = [0.2, 0.1, 0.0, 1.0];
    let simulation =
        Simulation::new(&plant, Decoupling::new(model, chains), waves, x0, 0.005).unwrap();
    let samples = simulation.until(1.0).unwrap().map(|sample| sample.unwrap().command);
    samples.map(|command| [command.u, command.nu]).collect()
}

#[test]
fn a_pair_is_the_array_of_the_same_kinds_bit_for_bit() {
    assert_eq!(inputs((joint(3.0), joint(5.0))), inputs([joint(3.0), joint(5.0)]));
    let learning = learner(ModelAided::new());
    assert_eq!(inputs((learning, learning)), inputs([learning, learning]));
}

#[test]
fn the_null_compensator_is_feedback_linearization_bit_for_bit() {
    let null = Clelc::new(joint(4.0), NullCompensator::new(Measured));
    assert_eq!(inputs([null; 2]), inputs([joint(4.0); 2]));
    assert_eq!(inputs((null, joint(4.0))), inputs([joint(4.0); 2]));
}

/// A plant of one chain, seen as one of several inputs.
#[derive(Debug, Clone, Copy)]
struct Single(Pendulum<f64>);

impl Decouplable<2, 2, 1> for Single {
    type Scalar = f64;

    fn chains(&self, x: &SVector<f64, 2>) -> [SVector<f64, 2>; 1] {
        [*x]
    }

    fn chain_drift(&self, x: &SVector<f64, 2>) -> SVector<f64, 1> {
        SVector::from([self.0.drift(x)])
    }

    fn decoupling_matrix(&self, x: &SVector<f64, 2>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[self.0.input_gain(x)]])
    }

    fn chain_rates(&self, _x: &SVector<f64, 2>, x_dot: &SVector<f64, 2>) -> SVector<f64, 1> {
        SVector::from([x_dot[1]])
    }
}

#[test]
fn one_chain_is_feedback_linearization() {
    let pendulum = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    let gains = Gains::new([2.0, 3.0]).unwrap();
    let whole = FeedbackLinearization::new(pendulum, gains);
    let chain = FeedbackLinearization::new(Chain::new(), gains);
    let mut split = Decoupling::new(Single(pendulum), [chain]);
    let wave = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
    for sample in run(&pendulum, whole, wave, [0.5, -1.0], 0.01, 3.0) {
        let command = split.update(&Measurement::new(sample.x), &[sample.reference], 0.01).unwrap();
        // ν and a are below 40 and the inertia is 0.2.
        approx::assert_abs_diff_eq!(
            command.u[0],
            sample.command.u,
            epsilon = 8.0 * f64::EPSILON * 40.0
        );
        assert_eq!(command.nu[0], sample.command.u_f + sample.command.u_b);
    }
}
