//! Decoupling control: the joints of an arm as separate chains, the uncertainty of an unknown payload, and failures without a trace.

use brunovsky::{
    Error, Scalar,
    controller::{
        ChainControllers, Clelc, ClelcCommand, Controller, Decoupling, FeedbackLinearization,
        Gains, Measurement, Reference,
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

/// The joints' errors after 30 s of holding the pose with a payload of 1 kg that the model does not know.
fn held<C: ChainControllers<f64, 2, 2>>(chains: C) -> SVector<f64, 2> {
    let (plant, model) = (arm::<f64>(1.0), arm::<f64>(0.0));
    let x0 = [POSE[0], POSE[1], 0.0, 0.0];
    let simulation =
        Simulation::new(&plant, Decoupling::new(model, chains), pose, x0, 0.005).unwrap();
    let x = simulation.until(30.0).unwrap().last().unwrap().unwrap().x;
    SVector::from([POSE[0] - x[0], POSE[1] - x[1]])
}

/// At rest at q the torque M̂·(k₁·e) + Ĝ of the model is the G of the loaded arm: k₁·e = M̂(q)⁻¹·(G(q) − Ĝ(q)), at q = r − e.
#[test]
fn an_unknown_payload_leaves_the_steady_error_of_both_arms_gravity() {
    let e = held([joint(4.0); 2]);
    let q = SVector::from(POSE) - e;
    let missing = arm::<f64>(1.0).gravity_torque(&q) - arm::<f64>(0.0).gravity_torque(&q);
    let expected = arm::<f64>(0.0).mass_matrix(&q).try_inverse().unwrap() * missing / 16.0;
    assert!(e.amax() > 0.1);
    approx::assert_abs_diff_eq!(e, expected, epsilon = 1e-9);
}

#[test]
fn learning_chains_leave_no_steady_error() {
    // The loop rests where s = 0 to rounding, and with ė₂ = 0 there u_b = 16·e₁.
    assert!(held([learner(ModelAided::new()); 2]).amax() < 1e-6);
    assert!(held([learner(Measured); 2]).amax() < 1e-6);
    assert!(held([learner(BackwardDifference::new()); 2]).amax() < 1e-6);
}

fn sliding_is_minus_what_is_not_learned<T: Scalar>() {
    let (plant, model) = (arm::<T>(1.0), arm::<T>(0.0));
    let mut controller = Decoupling::new(model, [learner::<T, _>(Measured); 2]);
    let mut learned = SVector::<T, 2>::zeros();
    let tolerance = T::default_epsilon() * num(4000.0);
    for k in 0..20 {
        let at = f64::from(k) * 0.1;
        let x = SVector::from([at.sin(), 0.5 - at, 1.0 - at, at.cos()].map(num::<T>));
        let u = SVector::from([2.0 + at, at.sin()].map(num::<T>));
        let x_dot = plant.derivative(T::zero(), &x, &u);
        let delta = (x_dot - model.derivative(T::zero(), &x, &u)).fixed_rows::<2>(2).into_owned();
        let measurement = Measurement::new(x).with_rate(x_dot).with_applied(u);
        let reference = [Reference::setpoint(num(0.3)), Reference::setpoint(num(-0.2))];
        let command = controller.update(&measurement, &reference, num(0.01)).unwrap();
        for i in 0..2 {
            let ClelcCommand { s, u_n, .. } = command.chains[i];
            // The antecedents flow with the error, so before it learns the network's output is still the u_n of the sample before. Accelerations
            // of up to 500 rad/s² cancel.
            assert!((s + learned[i] + delta[i]).abs() <= tolerance, "{s} at {k}");
            learned[i] = u_n;
        }
    }
    assert!(learned.amin() != T::zero());
}

/// With the null compensator u_n = 0, so s is −Δ at every sample.
fn measured_sliding_is_minus_the_uncertainty<T: Scalar>() {
    let (plant, model) = (arm::<T>(1.0), arm::<T>(0.0));
    let null = Clelc::new(joint::<T>(4.0), NullCompensator::new(Measured));
    let mut controller = Decoupling::new(model, [null; 2]);
    for k in 0..20 {
        let at = f64::from(k) * 0.1;
        let x = SVector::from([at.sin(), 0.5 - at, 1.0 - at, at.cos()].map(num::<T>));
        let u = SVector::from([2.0 + at, at.sin()].map(num::<T>));
        let x_dot = plant.derivative(T::zero(), &x, &u);
        let modelled = model.derivative(T::zero(), &x, &u);
        let measurement = Measurement::new(x).with_rate(x_dot).with_applied(u);
        let command = controller
            .update(&measurement, &[Reference::setpoint(T::zero()); 2], num(0.01))
            .unwrap();
        for i in 0..2 {
            let s = command.chains[i].s;
            // Accelerations of up to 500 rad/s² cancel.
            let tolerance = 4000.0 * real(T::default_epsilon());
            approx::assert_abs_diff_eq!(
                real(s),
                real(modelled[2 + i] - x_dot[2 + i]),
                epsilon = tolerance
            );
        }
    }
}

/// s of ModelAided is −Δ̂: what the last period showed under the *reported* input, whatever was commanded.
fn a_reported_saturation_leaves_s_untouched<T: Scalar>() {
    let model = arm::<T>(0.0);
    let null = Clelc::new(joint::<T>(4.0), NullCompensator::new(ModelAided::new()));
    let mut controller = Decoupling::new(model, [null; 2]);
    let far = [Reference::setpoint(num(30.0)), Reference::setpoint(num(-30.0))];
    let dt = num::<T>(0.01);
    let delta = SVector::from([3.0, -2.0].map(num::<T>));
    let x = SVector::from([0.3, 0.4, 0.5, -0.6].map(num::<T>));
    controller.update(&Measurement::new(x), &far, dt).unwrap();
    let u = SVector::from([4.0, 1.0].map(num::<T>));
    // A period at whose end the rates have changed by dt times the mean of (a + B·u) at both ends, and Δ. The rates at the end appear in the
    // mean, so they are found by iteration, which contracts with dt.
    let mut end = x;
    for _ in 0..40 {
        let mean = (model.derivative(dt, &x, &u) + model.derivative(dt, &end, &u)) * num::<T>(0.5);
        for i in 0..2 {
            end[2 + i] = x[2 + i] + dt * (mean[2 + i] + delta[i]);
        }
    }
    let command = controller.update(&Measurement::new(end).with_applied(u), &far, dt).unwrap();
    assert!((command.u - u).amin() > num(10.0), "the command is far from what arrived");
    for i in 0..2 {
        // Rates near 1 round, and are divided by dt.
        let tolerance = 64.0 * 100.0 * real(T::default_epsilon());
        approx::assert_abs_diff_eq!(
            real(command.chains[i].s),
            -real(delta[i]),
            epsilon = tolerance
        );
    }
}

at_f32_and_f64! {
    s_of_a_learning_chain_is_what_is_not_learned => sliding_is_minus_what_is_not_learned,
    s_of_a_measured_rate_is_minus_the_uncertainty => measured_sliding_is_minus_the_uncertainty,
    an_applied_input_that_is_reported_does_not_show_in_s => a_reported_saturation_leaves_s_untouched,
}

/// z̈ = a + B·u with a(x) = (e^x₁, 0) and a B that a test chooses.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Chosen {
    matrix: Matrix2<f64>,
}

impl Decouplable<4, 2, 2> for Chosen {
    type Scalar = f64;

    fn chains(&self, x: &SVector<f64, 4>) -> [SVector<f64, 2>; 2] {
        [SVector::from([x[0], x[2]]), SVector::from([x[1], x[3]])]
    }

    /// Overflows for x₁ = 1000.
    fn chain_drift(&self, x: &SVector<f64, 4>) -> SVector<f64, 2> {
        SVector::from([x[0].exp(), 0.0])
    }

    /// Singular for x₂ = 7.
    fn decoupling_matrix(&self, x: &SVector<f64, 4>) -> SMatrix<f64, 2, 2> {
        if x[1] == 7.0 { Matrix2::repeat(1.0) } else { self.matrix }
    }

    fn chain_rates(&self, _x: &SVector<f64, 4>, x_dot: &SVector<f64, 4>) -> SVector<f64, 2> {
        SVector::from([x_dot[2], x_dot[3]])
    }
}

const ORIGIN: [Reference<f64, 2>; 2] =
    [Reference { r: SVector::<f64, 2>::new(0.0, 0.0), r_n_dot: 0.0 }; 2];

#[test]
fn an_ill_conditioned_matrix_is_refused_with_its_condition_number() {
    let with = |matrix: Matrix2<f64>, limit: f64| {
        let controller = Decoupling::new(Chosen { matrix }, [joint::<f64>(2.0); 2]);
        let mut controller = controller.with_max_condition(limit).unwrap();
        controller.update(&Measurement::new([0.0; 4]), &ORIGIN, 0.1).map(|command| command.u)
    };
    let refused = |condition, limit| Error::IllConditioned { name: "B(x)", condition, limit };
    let near = 2.0_f64.powi(-20);
    let diagonal = Matrix2::new(1.0, 0.0, 0.0, near);
    // ‖diag(1, ε)‖·‖diag(1, 1/ε)‖ = 1/ε, a power of 2 and so without rounding; the limit itself is allowed.
    assert_eq!(with(diagonal, 1e6), Err(refused(1.0 / near, 1e6)));
    assert!(with(diagonal, 1.0 / near).is_ok());
    // (1 1; 0 1) and its inverse (1 −1; 0 1) both have the row sum 2.
    let shear = Matrix2::new(1.0, 1.0, 0.0, 1.0);
    assert_eq!(with(shear, 3.9), Err(refused(4.0, 3.9)));
    assert!(with(shear, 4.0).is_ok());
    assert_eq!(with(Matrix2::repeat(1.0), 1e6), Err(refused(f64::INFINITY, 1e6)));
    // Scaling B does not change how well its equations can be solved.
    assert!(with(Matrix2::identity() * 1e-100, 1.0).is_ok());
    let new = || Decoupling::new(Chosen { matrix: shear }, [joint::<f64>(2.0); 2]);
    for value in [0.0, -1.0] {
        let name = "condition number limit";
        assert_eq!(new().with_max_condition(value), Err(Error::NotPositive { name, value }));
    }
}

/// A maximum prefers numbers to NaN, so a norm alone would let such a matrix pass.
#[test]
fn a_matrix_that_is_not_finite_is_refused_by_its_name() {
    for bad in [f64::NAN, f64::INFINITY] {
        let model = Chosen { matrix: Matrix2::new(bad, 0.0, 0.0, 1.0) };
        let mut controller = Decoupling::new(model, [joint::<f64>(2.0); 2]);
        let error = controller.update(&Measurement::new([0.0; 4]), &ORIGIN, 0.1).unwrap_err();
        assert!(matches!(error, Error::IllConditioned { name: "B(x)", .. }), "{error}");
    }
}

#[test]
fn a_call_that_fails_leaves_no_trace_also_after_the_first_chain_was_updated() {
    let model = Chosen { matrix: Matrix2::new(0.5, 1.0, 0.0, 1.0) };
    let chains = (learner(ModelAided::new()), learner(BackwardDifference::new()));
    let mut tried = Decoupling::new(model, chains);
    let mut spared = tried;
    let good = Measurement::new([0.1, 0.2, 0.3, 0.4]);
    let nan = f64::NAN;
    let mut second = ORIGIN;
    second[1].r_n_dot = nan;
    let mut first = ORIGIN;
    first[0].r[1] = nan;
    // u = B⁻¹·(ν − a) overflows where each chain still has a finite νᵢ.
    let mut far = ORIGIN;
    (far[0].r_n_dot, far[1].r_n_dot) = (1.6e308, -1.6e308);
    let bad = [
        (good, ORIGIN, 0.0, "dt"),
        (good, ORIGIN, nan, "dt"),
        (Measurement::new([0.0, nan, 0.0, 0.0]), ORIGIN, 0.1, "x"),
        (good.with_rate([nan; 4]), ORIGIN, 0.1, "x_dot"),
        (good.with_applied([0.0, nan]), ORIGIN, 0.1, "applied"),
        (good, first, 0.1, "r"),
        (good, second, 0.1, "r_n_dot"),
        (good, far, 0.1, "u"),
        (Measurement::new([1000.0, 0.0, 0.0, 0.0]), ORIGIN, 0.1, "a(x)"),
        (Measurement::new([0.0, 7.0, 0.0, 0.0]), ORIGIN, 0.1, "B(x)"),
    ];
    for (measurement, reference, dt, expected) in bad {
        let name = match tried.update(&measurement, &reference, dt).unwrap_err() {
            Error::NonFinite { name, .. }
            | Error::NonFiniteEntry { name, .. }
            | Error::NotPositive { name, .. }
            | Error::IllConditioned { name, .. } => name,
            other => panic!("unexpected kind: {other}"),
        };
        assert_eq!(name, expected);
        assert_eq!(tried, spared);
        let update = |controller: &mut Decoupling<_, _, 4, 2, 2>| {
            controller.update(&good, &ORIGIN, 0.1).unwrap()
        };
        let before = spared;
        assert_eq!(update(&mut tried), update(&mut spared));
        assert_ne!(spared, before, "a good call is remembered");
    }
    tried.reset();
    assert_eq!(tried, Decoupling::new(model, chains));
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
