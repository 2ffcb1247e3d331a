//! Off, frozen, thawed: in closed loop, through every wrapper that a learning controller can be in.

use brunovsky::{
    channel::Saturation,
    controller::{
        Command, Controller, Decoupling, Limited, Measurement, Mode, Reference, Supervised,
        unicycle::{Direction, Standstill, UnicycleController},
    },
    fuzzy::FuzzyNetwork,
    integrators::{Integrator, Rk4},
    learning::{
        Antecedents, BackwardDifference, Fixed, Flow, LearningMode, ModelAided, SlidingMode,
    },
    plant::{
        FeedbackLinearizable, IntegratorChain, Link, Pendulum, Plant, TwoLinkArm, Uncertain,
        Unicycle,
    },
    trajectory::{Circle, Trajectory},
};
use nalgebra::SVector;

use crate::support::{self, Learning, flc};
use LearningMode::{Active, Frozen, Off};

const DT: f64 = 0.02;
const LAMBDA: f64 = 2.0;

type Clelc<P, A> = Learning<P, ModelAided<f64>, f64, 2, A>;

/// What every law here asks of the antecedents.
trait Treatment: Antecedents<FuzzyNetwork<f64, 2, 3>> + Copy + PartialEq + core::fmt::Debug {}

impl Treatment for Fixed {}
impl Treatment for Flow<f64> {}

fn learner<P, A: Treatment>(model: P, antecedents: A) -> Clelc<P, A>
where
    P: FeedbackLinearizable<2, Scalar = f64>,
{
    let rule = SlidingMode::new(8.0).unwrap().with_antecedents(antecedents);
    support::learning(model, LAMBDA, ModelAided::new(), rule)
}

/// The bits of everything that was learned.
fn bits<P: FeedbackLinearizable<2, Scalar = f64>, A: Treatment>(clelc: &Clelc<P, A>) -> Vec<u64> {
    clelc.compensator().network().consequents().iter().map(|f| f.to_bits()).collect()
}

/// A loop that can be stopped and gone on with: what follows `reference` from `x`, and how `x` moves under an input.
struct Loop<C, R, S, const NX: usize, const NU: usize> {
    controller: C,
    reference: R,
    step: S,
    x: SVector<f64, NX>,
    u: Option<SVector<f64, NU>>,
    k: u32,
}

impl<C, R, S, const NX: usize, const NU: usize> Loop<C, R, S, NX, NU>
where
    C: Controller<NX, NU, Scalar = f64>,
    R: Fn(f64) -> C::Reference,
    S: Fn(f64, &SVector<f64, NX>, &SVector<f64, NU>) -> SVector<f64, NX>,
{
    fn new(controller: C, reference: R, step: S, x: [f64; NX]) -> Self {
        Self { controller, reference, step, x: x.into(), u: None, k: 0 }
    }

    /// A second of it: at how many samples the input is that of `plain`, which sees the same.
    fn agreeing_with(
        &mut self,
        plain: &mut impl Controller<NX, NU, Scalar = f64, Reference = C::Reference>,
    ) -> usize {
        let mut agrees = |_: &u32| {
            let t = f64::from(self.k) * DT;
            let (seen, reference) = (Measurement::new(self.x), (self.reference)(t));
            let seen = Measurement { applied: self.u, ..seen };
            let u = self.controller.update(&seen, &reference, DT).unwrap().input();
            self.x = (self.step)(t, &self.x, &u);
            self.u = Some(u);
            self.k += 1;
            plain.update(&seen, &reference, DT).unwrap().input() == u
        };
        (0..50).filter(&mut agrees).count()
    }

    /// Learns, freezes, goes without, freezes again, thaws: beside the controller that cannot learn. Off is that one to the last bit, but for
    /// the samples of a transfer.
    fn through_all_modes(
        mut self,
        mut plain: impl Controller<NX, NU, Scalar = f64, Reference = C::Reference>,
        learned: impl Fn(&C) -> Vec<u64>,
        transfer: usize,
    ) {
        let fresh = learned(&self.controller);
        self.agreeing_with(&mut plain);
        let known = learned(&self.controller);
        assert_ne!(known, fresh);
        for mode in [Frozen, Off, Frozen] {
            self.controller.set_learning(mode);
            let agreeing = self.agreeing_with(&mut plain);
            assert_eq!(learned(&self.controller), known);
            if mode == Off {
                assert_eq!(agreeing, 50 - transfer);
            } else {
                assert!(agreeing < 5);
            }
        }
        self.controller.set_learning(Active);
        self.agreeing_with(&mut plain);
        assert_ne!(learned(&self.controller), known);
    }
}

/// How a plant moves over a period with its input held.
fn moved<const NX: usize, const NU: usize>(
    plant: &impl Plant<NX, NU, Scalar = f64>,
    t: f64,
    x: &SVector<f64, NX>,
    u: &SVector<f64, NU>,
) -> SVector<f64, NX> {
    Rk4.integrate(|s, x| plant.derivative(s, x, u), t, x, DT, 4).unwrap()
}

fn pendulum(length: f64) -> Pendulum<f64> {
    Pendulum::new(1.0, length, 0.1, 9.81).unwrap()
}

/// A longer pendulum than the model says, in a gusty wind.
fn gusty(t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>) -> SVector<f64, 2> {
    moved(&Uncertain::matched(pendulum(1.0), |t: f64, _: &_, _: &_| (3.0 * t).sin()), t, x, u)
}

fn swing(t: f64) -> Reference<f64, 2> {
    Reference::new([t.sin(), t.cos()], -t.sin())
}

fn on_the_pendulum<A: Treatment, C>(
    antecedents: A,
    wrapped: impl Fn(Clelc<Pendulum<f64>, A>) -> C,
    inside: impl Fn(&C) -> &Clelc<Pendulum<f64>, A>,
    transfer: usize,
) where
    C: Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>>,
{
    let controller = wrapped(learner(pendulum(0.8), antecedents));
    let plain = flc(pendulum(0.8), LAMBDA);
    Loop::new(controller, swing, gusty, [0.5, 0.0]).through_all_modes(
        plain,
        |controller| bits(inside(controller)),
        transfer,
    );
}

#[test]
fn of_clelc_itself() {
    on_the_pendulum(Fixed, |clelc| clelc, |clelc| clelc, 0);
    on_the_pendulum(Flow::default(), |clelc| clelc, |clelc| clelc, 0);
}

#[test]
fn behind_an_actuator() {
    let wide = Saturation::symmetric([1e6]).unwrap();
    on_the_pendulum(Fixed, |clelc| Limited::new(clelc, wide), Limited::controller, 0);
    on_the_pendulum(Flow::default(), |clelc| Limited::new(clelc, wide), Limited::controller, 0);
}

/// Its fade is over within a sample, so a transfer takes the one sample that it holds the input for.
#[test]
fn beside_an_operator() {
    fn wrapped<A: Treatment>(
        clelc: Clelc<Pendulum<f64>, A>,
    ) -> Supervised<Clelc<Pendulum<f64>, A>, f64, 1> {
        let mut supervised = Supervised::new(clelc, [1e9]).unwrap();
        supervised.select(Mode::Automatic(Active));
        supervised
    }
    on_the_pendulum(Fixed, wrapped, Supervised::controller, 1);
    on_the_pendulum(Flow::default(), wrapped, Supervised::controller, 1);
}

#[test]
fn in_the_chains_of_an_arm() {
    on_the_arm(Fixed);
    on_the_arm(Flow::default());
}

fn on_the_arm(antecedents: impl Treatment) {
    let arm = |payload| {
        let link = Link { mass: 2.0, length: 0.35, centre: 0.15, inertia: 0.02 };
        let arm = TwoLinkArm::new([link; 2], [0.1, 0.2], 9.81).unwrap();
        arm.with_payload(payload).unwrap()
    };
    let loaded = arm(0.5);
    let learner = learner(IntegratorChain::new(), antecedents);
    let plain = flc(IntegratorChain::new(), LAMBDA);
    let pose = |_| [Reference::setpoint(0.4), Reference::setpoint(0.7)];
    let step = |t: f64, x: &_, u: &_| moved(&loaded, t, x, u);
    let looped =
        Loop::new(Decoupling::new(arm(0.0), [learner; 2]), pose, step, [0.0, 0.1, 0.0, 0.0]);
    let learned = |arm: &Decoupling<_, [Clelc<_, _>; 2], 4, 2, 2>| {
        arm.chains().iter().flat_map(bits).collect()
    };
    looped.through_all_modes(Decoupling::new(arm(0.0), [plain; 2]), learned, 0);
}

#[test]
fn on_the_axes_of_the_unicycle() {
    on_the_unicycle(Fixed);
    on_the_unicycle(Flow::default());
}

/// An array of one kind and a pair of two, on ground on which the robot drives 0.8 and turns 0.7 of what it is told.
fn on_the_unicycle(antecedents: impl Treatment) {
    let circle = Circle::new([0.0, 0.0], 2.0, 0.5, 0.0).unwrap();
    let slipping = |_: f64, x: &SVector<f64, 4>, u: &SVector<f64, 2>| {
        moved(&Unicycle::new(), 0.0, x, &[(0.8 * u[0] - x[3]) / DT, 0.7 * u[1]].into())
    };
    let start = [2.0, 0.0, core::f64::consts::FRAC_PI_2, 1.0];
    let plain = flc(IntegratorChain::<f64, 2>::new(), LAMBDA);
    let (direction, standstill) = (Direction::Forward, Standstill::Hold);
    let references = |t| circle.references(t);
    let learner = learner(IntegratorChain::new(), antecedents);
    let rule = SlidingMode::new(8.0).unwrap();
    let other = support::learning(IntegratorChain::new(), LAMBDA, BackwardDifference::new(), rule);
    let plain = UnicycleController::new([plain; 2], direction, 0.01, standstill).unwrap();

    let two = UnicycleController::new([learner; 2], direction, 0.01, standstill).unwrap();
    let looped = Loop::new(two, references, slipping, start);
    looped.through_all_modes(plain, |two| two.axes().iter().flat_map(bits).collect(), 0);

    let pair = UnicycleController::new((learner, other), direction, 0.01, standstill).unwrap();
    let looped = Loop::new(pair, references, slipping, start);
    let second = |f: &f64| f.to_bits();
    let learned = |pair: &UnicycleController<f64, (Clelc<_, _>, Learning<_, _, _, 2>)>| {
        let (first, other) = pair.axes();
        let other = other.compensator().network().consequents();
        bits(first).into_iter().chain(other.iter().map(second)).collect()
    };
    looped.through_all_modes(plain, learned, 0);
}

#[test]
fn through_a_mutable_reference() {
    let mut clelc = learner(pendulum(0.8), Flow::default());
    let (mut twin, rest) = (clelc, Reference::setpoint(1.0));
    let x = Measurement::new([0.0, 0.0]);
    for mode in [Active, Off, Frozen, Active] {
        let mut borrowed = &mut clelc;
        Controller::set_learning(&mut borrowed, mode);
        twin.set_learning(mode);
        let command = borrowed.update(&x, &rest, DT).unwrap();
        assert_eq!(command, twin.update(&x, &rest, DT).unwrap());
    }
    assert_eq!(clelc, twin);
}

/// With flowing antecedents the network is an integrator: frozen, u_n is one number to the last bit wherever the error goes, and thawed it goes
/// on from there by clamp(s, ±αh).
#[test]
fn a_thawed_integrator_goes_on_from_the_number_that_was_frozen() {
    let clelc = learner(pendulum(0.8), Flow::default());
    let mut looped = Loop::new(clelc, swing, gusty, [0.5, 0.0]);
    let mut u_n = 0.0;
    for mode in [Active, Frozen, Active, Off, Active] {
        looped.controller.set_learning(mode);
        for _ in 0..40 {
            let t = f64::from(looped.k) * DT;
            let seen = Measurement::new(looped.x);
            let command = looped.controller.update(&seen, &swing(t), DT).unwrap();
            looped.x = gusty(t, &looped.x, &[command.u].into());
            looped.k += 1;
            match mode {
                Off => assert!(command.u_n == 0.0 && command.u_n.is_sign_negative()),
                Frozen => assert_eq!(command.u_n, u_n),
                Active => {
                    u_n += command.s.clamp(-8.0 * DT, 8.0 * DT);
                    // Nine products and their sum, at each of a hundred samples.
                    approx::assert_abs_diff_eq!(command.u_n, u_n, epsilon = 1e-13);
                    u_n = command.u_n;
                }
            }
        }
    }
    assert!(u_n != 0.0);
}
