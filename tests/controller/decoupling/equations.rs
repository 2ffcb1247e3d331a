//! Plants by their equations under the controllers for chains: as if they had been given in chain form.

use core::marker::PhantomData;

use brunovsky::{
    differentiation::Smooth,
    plant::{Linearized, SmoothPlant, Uncertain, Unicycle},
};
use num_dual::Dual64;

use super::*;
use crate::smooth_plants::{Arm, Cart, FlexibleJoint};

/// The largest difference of states and inputs between `plant` under its own law and under that of `model`, as `decoupled` controls them.
fn difference<P, A, B, C, const NX: usize>(
    plant: &P,
    models: (A, B),
    chains: C,
    x0: [f64; NX],
) -> f64
where
    P: Plant<NX, 2, Scalar = f64>,
    A: Decouplable<NX, 2, 2, Scalar = f64> + Clone,
    B: Decouplable<NX, 2, 2, Scalar = f64> + Clone,
    C: ChainControllers<f64, 2, 2> + Clone,
{
    let first = Decoupling::new(models.0, chains.clone());
    let second = Decoupling::new(models.1, chains);
    let first = Simulation::new(plant, first, waves, x0, 0.01).unwrap().until(3.0).unwrap();
    let second = Simulation::new(plant, second, waves, x0, 0.01).unwrap().until(3.0).unwrap();
    let largest = first.zip(second).map(|(a, b)| {
        let (a, b) = (a.unwrap(), b.unwrap());
        (a.x - b.x).amax().max((a.u - b.u).amax() / (1.0 + b.u.amax()))
    });
    largest.fold(0.0, f64::max)
}

#[test]
fn the_arm_under_its_derived_law_moves_as_under_the_one_written_by_hand() {
    let by_equations = Arm {
        links: [[2.0, 0.35, 0.15, 0.02], [1.5, 0.3, 0.2, 0.015]],
        friction: [0.1, 0.2],
        gravity: 9.81,
        payload: 0.0,
    };
    let x0 = [0.2, 0.1, 0.0, 1.0];
    let models = (by_equations.linearized::<2>(x0).unwrap(), arm::<f64>(0.0));
    // The payload of the plant is for the controllers to find out.
    let flc = difference(&arm::<f64>(1.0), models, [joint(5.0); 2], x0);
    assert!(flc < 1e-10, "{flc}");
    let clelc = difference(&arm::<f64>(1.0), models, [learner(ModelAided::new()); 2], x0);
    // The set-valued sign is continuous and not smooth; it amplifies roundings more.
    assert!(clelc < 1e-8, "{clelc}");
}

#[test]
fn the_unicycle_under_its_derived_law_moves_as_under_the_one_written_by_hand() {
    let x0 = [0.1, -0.1, 1.0, 2.0];
    let models = (Cart(PhantomData).linearized::<2>(x0).unwrap(), Unicycle::new());
    let flc = difference(&Unicycle::new(), models, [joint(2.0); 2], x0);
    assert!(flc < 1e-9, "{flc}");
    let clelc = difference(&Unicycle::new(), models, [learner(ModelAided::new()); 2], x0);
    assert!(clelc < 1e-8, "{clelc}");
}

const JOINT: FlexibleJoint<f64> =
    FlexibleJoint { link: 1.0, motor: 0.3, weight: 9.0, stiffness: 100.0 };

fn fourth_order<T: Scalar>(lambda: T) -> FeedbackLinearization<IntegratorChain<T, 4>, 4> {
    FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(lambda).unwrap())
}

/// e⁽⁴⁾ + k·e = 0 in the limit of short periods, although no chain was ever written down.
#[test]
fn the_flexible_joint_follows_the_error_dynamics_of_a_chain_of_four() {
    let deviation = |dt: f64| {
        let plant = JOINT.linearized::<4>([0.0; 4]).unwrap();
        let flc = fourth_order(3.0);
        let controller = Decoupling::new(&plant, [flc]);
        let reference = |_| [Reference::setpoint(0.5)];
        let run = Simulation::new(&plant, controller, reference, [0.0; 4], dt).unwrap();
        let e0 = SVector::from([0.5, 0.0, 0.0, 0.0]);
        let deviations = run.until(2.0).unwrap().map(|sample| {
            let sample = sample.unwrap();
            let e = sample.reference[0].r - plant.chains(&sample.x)[0];
            (e - error_dynamics(flc.gains().as_vector(), &e0, sample.t))[0].abs()
        });
        deviations.fold(0.0, f64::max)
    };
    let order = (deviation(0.002) / deviation(0.001)).log2();
    assert!((order - 1.0).abs() < 0.1, "order {order}");
}

/// An unknown acceleration δ of the motor is Δ = k/I·δ in the chain: feedback alone leaves e = −Δ/k₁, learning nothing.
#[test]
fn learning_takes_over_what_the_motor_meets() {
    let (plant, delta) = (JOINT.linearized::<4>([0.0; 4]).unwrap(), 2.0);
    let disturbed = Uncertain::matched(plant, |_, _: &_, _: &_| delta);
    let reference = |_| [Reference::setpoint(1.0)];
    let flc = fourth_order(5.0);
    let run =
        Simulation::new(&disturbed, Decoupling::new(plant, [flc]), reference, [0.0; 4], 0.002);
    let left = 1.0 - run.unwrap().until(6.0).unwrap().last().unwrap().unwrap().x[0];
    let expected = -JOINT.stiffness / JOINT.link * delta / 5.0_f64.powi(4);
    // In 6 s e^(−5t) leaves 10⁻¹³, times t³.
    approx::assert_relative_eq!(left, expected, max_relative = 1e-6);

    let network = FuzzyNetwork::<f64, 4, 3>::evenly_spaced([0.5, 1.0, 5.0, 20.0]).unwrap();
    let rule = SlidingMode::new(2000.0).unwrap();
    let learning = NeuroFuzzy::new(network, ModelAided::new(), rule);
    let clelc = Decoupling::new(plant, [Clelc::new(flc, learning)]);
    let run = Simulation::new(&disturbed, clelc, reference, [0.0; 4], 0.002).unwrap();
    let left = 1.0 - run.until(6.0).unwrap().last().unwrap().unwrap().x[0];
    assert!(left.abs() < 1e-3 * expected.abs(), "{left}");
}

/// ẍ₁ = u₁ + ½·x₂·u₂, x₂⁽³⁾ = u₂ + sin x₁: chains of two and three. State (x₁, ẋ₁, x₂, ẋ₂, ẍ₂).
#[derive(Debug, Clone, Copy)]
struct Uneven;

impl SmoothPlant<5, 2> for Uneven {
    type Scalar = f64;

    fn drift_field<S: Smooth>(&self, [a, a_dot, _, b_dot, b_ddot]: [S; 5]) -> [S; 5] {
        [a_dot, S::zero(), b_dot, b_ddot, a.sin()]
    }

    fn input_fields<S: Smooth>(&self, [_, _, b, _, _]: [S; 5]) -> [[S; 5]; 2] {
        let (zero, one) = (S::zero(), S::one());
        [[zero, one, zero, zero, zero], [zero, b * 0.5, zero, zero, one]]
    }

    fn outputs<S: Smooth>(&self, [a, _, b, ..]: [S; 5]) -> [S; 2] {
        [a, b]
    }
}

/// Each chain obeys its own error dynamics; the shorter one as if it stood alone.
#[test]
fn chains_of_different_orders_follow_their_own_error_dynamics() {
    let plant = Linearized::<_, 5, 3, 2>::with_degrees(Uneven, [2, 3], [0.0; 5]).unwrap();
    let x = SVector::from([0.3, -0.2, 0.5, 0.7, -0.1]);
    let [short, long] = plant.chains(&x);
    assert_eq!((short, long), ([0.0, 0.3, -0.2].into(), [0.5, 0.7, -0.1].into()));
    assert_eq!(plant.chain_drift(&x), SVector::from([0.0, 0.3_f64.sin()]));
    assert_eq!(plant.decoupling_matrix(&x), SMatrix::from([[1.0, 0.0], [0.25, 1.0]]));
    assert!(Uneven.linearized::<3>([0.0; 5]).is_err(), "the degrees have to be stated");

    let two = FeedbackLinearization::new(
        IntegratorChain::<f64, 2>::new(),
        Gains::from_lambda(2.0).unwrap(),
    );
    let three =
        FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(3.0).unwrap());
    let deviation = |dt: f64| {
        let controller = Decoupling::new(plant, (Padded(two), three));
        let reference = |t: f64| {
            let wave = Reference::<f64, 2>::new([t.sin(), t.cos()], -t.sin());
            [wave.padded(), Reference::new([t.cos(), -t.sin(), -t.cos()], t.sin())]
        };
        let run = Simulation::new(&plant, controller, reference, [0.5, 1.0, 1.0, 0.3, -1.0], dt);
        let (first, second) = (SVector::from([-0.5, 0.0]), SVector::from([0.0, -0.3, 0.0]));
        let deviations = run.unwrap().until(3.0).unwrap().map(|sample| {
            let sample = sample.unwrap();
            let (sin, cos) = sample.t.sin_cos();
            let e = SVector::from([sin - sample.x[0], cos - sample.x[1]]);
            let off = (e - error_dynamics(two.gains().as_vector(), &first, sample.t)).norm();
            let e = SVector::from([cos - sample.x[2], -sin - sample.x[3], -cos - sample.x[4]]);
            off.max((e - error_dynamics(three.gains().as_vector(), &second, sample.t)).norm())
        });
        deviations.fold(0.0, f64::max)
    };
    let order = (deviation(0.004) / deviation(0.002)).log2();
    assert!((order - 1.0).abs() < 0.1, "order {order}");
}

/// A padded controller sees what the bare one would see.
#[test]
fn padding_changes_nothing_but_the_length() {
    let flc = joint::<f64>(3.0);
    let (x, r) = ([0.4, -0.7], Reference::new([0.1, 0.3], 2.0));
    let bare = Measurement::new(x).with_rate([1.0, 2.0]).with_applied([0.5]);
    let long = Measurement::new([9.0, 9.0, x[0], x[1]])
        .with_rate([8.0, 8.0, 1.0, 2.0])
        .with_applied([0.5]);
    let mut learning = learner(Measured);
    let mut padded = Padded::<_, 2>(learning);
    for _ in 0..3 {
        let expected = learning.update(&bare, &r, 0.01).unwrap();
        assert_eq!(padded.update(&long, &r.padded::<4>(), 0.01).unwrap(), expected);
    }
    let r = r.padded::<4>();
    assert_eq!((r.r, r.r_n_dot), ([0.0, 0.0, 0.1, 0.3].into(), 2.0));
    Controller::<4, 1>::reset(&mut padded);
    assert_eq!(padded.0, learner(Measured));
    assert!(Padded::<_, 2>(flc).update(&long, &r, -1.0).is_err());
}

/// q after a second of the closed loop with poles at −λ and a joint of stiffness k under CLELC.
fn closed_loop<T: Scalar>(lambda: T, stiffness: T) -> T {
    let joint = FlexibleJoint {
        link: num(1.0),
        motor: num(0.3),
        weight: num(9.0),
        stiffness: num::<T>(100.0),
    };
    let start = [0.5, 0.0, 0.5, 0.0].map(num::<T>);
    let model = joint.linearized::<4>(start).unwrap();
    let truth = FlexibleJoint { stiffness, ..joint }.linearized::<4>(start).unwrap();
    let network = FuzzyNetwork::<T, 4, 3>::evenly_spaced([0.5, 1.0, 5.0, 20.0].map(num)).unwrap();
    let rule = SlidingMode::new(num(100.0)).unwrap();
    let rule =
        rule.with_switching(brunovsky::learning::Switching::Implicit { delta: num(5.0) }).unwrap();
    let learning = NeuroFuzzy::new(network, ModelAided::new(), rule);
    let controller = Decoupling::new(model, [Clelc::new(fourth_order(lambda), learning)]);
    let disturbed = Uncertain::new(truth, |t: T, _: &_, _: &_| {
        SVector::from([T::zero(), T::zero(), T::zero(), t.sin()])
    });
    let reference = |_| [Reference::setpoint(T::zero())];
    let run = Simulation::new(&disturbed, controller, reference, start, num(0.01)).unwrap();
    run.take(101).last().unwrap().unwrap().x[0]
}

/// The derivative of a whole run by num_dual is that of the central difference, extrapolated once.
#[test]
fn a_whole_run_on_derived_laws_is_differentiated_by_dual_numbers() {
    let agrees = |dual: &dyn Fn(Dual64) -> Dual64, real: &dyn Fn(f64) -> f64, at: f64| {
        let found = dual(Dual64::new(at, 1.0));
        approx::assert_relative_eq!(found.re, real(at), max_relative = 1e-9);
        let difference = |h: f64| (real(at + h) - real(at - h)) / (2.0 * h);
        let (coarse, fine) = (difference(2e-4 * at), difference(1e-4 * at));
        assert!(found.eps.abs() > 1e-7, "it does depend on it");
        approx::assert_relative_eq!(found.eps, fine + (fine - coarse) / 3.0, max_relative = 1e-5);
    };
    agrees(&|v| closed_loop(v, num(90.0)), &|v| closed_loop(v, 90.0), 4.0);
    agrees(&|v| closed_loop(num(4.0), v), &|v| closed_loop(4.0, v), 90.0);
}
