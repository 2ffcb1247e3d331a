//! A copy of a controller is a snapshot: put back in mid-run, it goes on to the last bit as it did the first time.

use brunovsky::{
    channel::RateLimit,
    controller::{
        ActiveDisturbanceRejection, AntiWindup, Backstepping, Clelc, Compensated, Controller,
        Decoupling, Gains, Limited, Mode, ModelReferenceAdaptive, Pid, PidGains, Reference,
        StateRegressor, Supervised,
        sliding_mode::{
            IntegralSlidingMode, SlidingModeControl, SlidingSurface, SuperTwisting,
            SuperTwistingGains,
        },
        unicycle::{Direction, Standstill, UnicycleController},
    },
    fuzzy::FuzzyNetwork,
    learning::{
        BackwardDifference, Bounded, Compensator, Conditional, ErrorRate, FilteredDifference,
        Fixed, GradientDescent, Guarded, LearningMode, Measured, ModelAided, NeuroFuzzy,
        NullCompensator, Redundant, SlidingMode, Watchdog,
    },
    plant::{IntegratorChain, Link, Plant, TwoLinkArm, Uncertain, Unicycle},
    simulation::{Sample, Simulation},
    trajectory::{Circle, Trajectory},
};
use nalgebra::SVector;

use crate::support::flc;

const DT: f64 = 0.02;

/// Runs `controller`, takes a copy, runs on, puts the copy back and runs on again from the same state; and copies a whole simulation in
/// mid-run. `remembers`: whether going on without putting it back is something else.
fn continues<P, C, R, D, const NX: usize, const NU: usize>(
    plant: P,
    controller: C,
    reference: impl Fn(f64) -> R + Copy,
    x0: [f64; NX],
    remembers: bool,
) where
    P: Plant<NX, NU, Scalar = f64> + Clone,
    C: Controller<NX, NU, Scalar = f64, Reference = R, Command = D> + Clone,
    Sample<f64, R, D, NX, NU>: PartialEq + core::fmt::Debug,
{
    let run = |controller: &mut C, x: SVector<f64, NX>| {
        let mut run = Simulation::new(&plant, controller, reference, x, DT).unwrap();
        let samples: Vec<_> = run.by_ref().take(100).map(Result::unwrap).collect();
        (samples, *run.state())
    };
    let mut running = controller.clone();
    let (_, x) = run(&mut running, x0.into());
    let snapshot = running.clone();
    let first = run(&mut running, x);
    assert_eq!(run(&mut running, x) != first, remembers);
    running = snapshot;
    assert_eq!(run(&mut running, x), first);

    let mut whole = Simulation::new(&plant, controller, reference, x0, DT).unwrap();
    assert!(whole.by_ref().take(100).all(|sample| sample.is_ok()));
    let copy = whole.clone();
    let go_on = |simulation: Simulation<_, _, _, NX, NU>| -> Vec<_> {
        simulation.take(100).map(Result::unwrap).collect()
    };
    assert_eq!(go_on(whole), go_on(copy));
}

type Chain = IntegratorChain<f64, 2>;

fn on_the_chain<C>(controller: C, remembers: bool)
where
    C: Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>> + Clone,
    C::Command: PartialEq + core::fmt::Debug,
{
    let gusty = |t: f64, x: &SVector<f64, 2>, _: &_| (3.0 * t).sin() + 0.5 * x[1];
    let swing = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
    continues(Uncertain::matched(Chain::new(), gusty), controller, swing, [1.0, -1.0], remembers);
}

fn clelc<C: Compensator<f64, 2>>(compensator: C) -> Clelc<Chain, C, 2> {
    Clelc::new(flc(Chain::new(), 2.0), compensator)
}

fn network() -> FuzzyNetwork<f64, 2, 3> {
    FuzzyNetwork::evenly_spaced([1.0, 2.0]).unwrap()
}

fn rule() -> SlidingMode<f64> {
    SlidingMode::new(8.0).unwrap()
}

#[test]
fn feedback_linearization_has_nothing_to_forget() {
    on_the_chain(flc(Chain::new(), 2.0), false);
    on_the_chain(clelc(NullCompensator::new(Measured)), false);
}

fn with_every_source(error_rate: impl ErrorRate<f64, 2> + Clone) {
    let fixed = rule().with_antecedents(Fixed);
    on_the_chain(clelc(NeuroFuzzy::new(network(), error_rate.clone(), rule())), true);
    on_the_chain(clelc(NeuroFuzzy::new(network(), error_rate, fixed)), true);
}

#[test]
fn clelc_with_every_source_and_rule() {
    with_every_source(Measured);
    with_every_source(BackwardDifference::new());
    with_every_source(FilteredDifference::new(0.1).unwrap());
    with_every_source(ModelAided::new());
    with_every_source(Conditional::new(ModelAided::new(), 0.1).unwrap());
    with_every_source(Redundant::new(Measured, BackwardDifference::new()));
    let gradient = GradientDescent::new(5.0).unwrap();
    on_the_chain(clelc(NeuroFuzzy::new(network(), ModelAided::new(), gradient)), true);
    let bounded = Bounded::new(gradient, 1.0).unwrap().with_rate(2.0).unwrap();
    on_the_chain(clelc(NeuroFuzzy::new(network(), ModelAided::new(), bounded)), true);
}

/// The first watchdog has not tripped when the copy is taken, the second has, and fades.
#[test]
fn clelc_under_a_guard() {
    for (bound, fade) in [(4.0, 1.0), (0.1, 0.01)] {
        let watchdog = Watchdog::new(rule().certificate(DT, bound).unwrap(), 0.01, 0.1).unwrap();
        let learner = NeuroFuzzy::new(network(), ModelAided::new(), rule());
        on_the_chain(clelc(Guarded::new(learner, watchdog).with_fallback(fade).unwrap()), true);
    }
}

#[test]
fn a_controller_with_limits_or_an_operator() {
    let learner = clelc(NeuroFuzzy::new(network(), ModelAided::new(), rule()));
    on_the_chain(Limited::new(learner, RateLimit::new([5.0]).unwrap()), true);
    on_the_chain(Limited::new(flc(Chain::new(), 2.0), RateLimit::new([5.0]).unwrap()), true);
    let mut supervised = Supervised::new(learner, [0.1]).unwrap();
    on_the_chain(supervised, true);
    supervised.select(Mode::Automatic(LearningMode::Active));
    on_the_chain(supervised, true);
}

#[test]
fn the_classical_controllers() {
    on_the_chain(Backstepping::new(Chain::new(), [1.0, 2.0]).unwrap(), false);
    let gains = PidGains::parallel(4.0, 2.0, 3.0, 0.1).unwrap();
    on_the_chain(Pid::new(gains, AntiWindup::None).unwrap(), true);
    let base = flc(Chain::new(), 2.0);
    let adaptive = ModelReferenceAdaptive::new(base, StateRegressor, 5.0, [1.0, 1.0]).unwrap();
    on_the_chain(adaptive, true);
}

#[test]
fn the_robust_controllers() {
    let surface = SlidingSurface::from_lambda(2.0).unwrap();
    on_the_chain(SlidingModeControl::new(Chain::new(), surface, 3.0).unwrap(), false);
    let gains = SuperTwistingGains::for_rate(5.0).unwrap();
    let twisting = SuperTwisting::new(Chain::new(), surface, gains);
    on_the_chain(twisting, true);
    let integral = IntegralSlidingMode::new(3.0).unwrap();
    on_the_chain(clelc(integral), true);
    on_the_chain(Compensated::new(twisting, Chain::new(), integral), true);
    let gains = Gains::from_lambda(2.0).unwrap();
    on_the_chain(ActiveDisturbanceRejection::new(gains, 10.0, 1.0).unwrap(), true);
}

#[test]
fn the_chains_of_an_arm() {
    let link = Link { mass: 2.0, length: 0.35, centre: 0.15, inertia: 0.02 };
    let arm = TwoLinkArm::new([link; 2], [0.1, 0.2], 9.81).unwrap();
    let learner = clelc(NeuroFuzzy::new(network(), ModelAided::new(), rule()));
    let pose = |_| [Reference::setpoint(0.4), Reference::setpoint(0.7)];
    let loaded = arm.with_payload(0.5).unwrap();
    continues(loaded, Decoupling::new(arm, [learner; 2]), pose, [0.0, 0.1, 0.0, 0.0], true);
}

/// A unicycle whose drives get to the commanded speed within 0.1 s: v̇ = (u₁ − v)/0.1, θ̇ = 0.7·u₂.
#[derive(Clone)]
struct Lagging;

impl Plant<4, 2> for Lagging {
    type Scalar = f64;

    fn derivative(&self, t: f64, x: &SVector<f64, 4>, u: &SVector<f64, 2>) -> SVector<f64, 4> {
        let input = SVector::from([(u[0] - x[3]) / 0.1, 0.7 * u[1]]);
        Unicycle::new().derivative(t, x, &input)
    }
}

#[test]
fn the_axes_of_the_unicycle() {
    let circle = Circle::new([0.0, 0.0], 2.0, 0.5, 0.0).unwrap();
    let learner = clelc(NeuroFuzzy::new(network(), ModelAided::new(), rule()));
    let controller =
        UnicycleController::new([learner; 2], Direction::Forward, 0.1, Standstill::Hold).unwrap();
    let start = [2.0, 0.0, core::f64::consts::FRAC_PI_2, 1.0];
    continues(Lagging, controller, |t| circle.references(t), start, true);
}
