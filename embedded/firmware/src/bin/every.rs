//! Every controller, every rule and every source of ė_n, under calls of any kind with numbers of any bits. That it links is the proof that no
//! path leads to a panic, see [`firmware`]; that it ends is a test.
#![no_std]
#![no_main]

use core::hint::black_box;

use brunovsky::{
    Error,
    channel::{RateLimit, Saturation},
    controller::{
        ActiveDisturbanceRejection, InputOnly, Leakage, Padded, Projection, StateRegressor,
        lqr::Weights,
        sliding_mode::{
            IntegralSlidingMode, SlidingModeControl, SlidingSurface, Stepping, SuperTwisting,
            SuperTwistingGains,
        },
        unicycle::{Direction, Standstill, UnicycleController},
    },
    differentiator::{HighGain, RobustExact, Tracking},
    fuzzy::{IntervalNetwork, TriangularNetwork, TypeReduction},
    learning::{
        AdaptiveSlidingMode, Bounded, Conditional, FeedbackError, Fixed, OfState,
        RecursiveLeastSquares, Redundant,
    },
    plant::{IntegratorChain, Jacobians, Link, TwoLinkArm},
    prelude::*,
};
use cortex_m_rt::entry;
use firmware::{
    by_hand::ByHand,
    exit,
    hostile::{Noise, agree, stand},
};
use replay::{Real, chain, feedback, trained};

#[entry]
fn main() -> ! {
    exit(every())
}

fn every() -> Result<(), Error> {
    let noise = &mut Noise::new(0x9e37_79b9_7f4a_7c15);
    rules(noise)?;
    networks(noise)?;
    sources(noise)?;
    for switching in [Switching::SetValued, Switching::Implicit { delta: 2.0 }] {
        let rule = SlidingMode::new(5.0)?.with_switching(switching)?;
        agree(ByHand::new(rule)?, chain::<_, _, 2, 3>(ModelAided::new(), rule)?, noise);
    }
    stand(feedback::<1>()?, noise);
    stand(feedback::<6>()?, noise);
    stand(Clelc::new(feedback::<2>()?, NullCompensator::new(Measured)), noise);
    classical(noise)?;
    adaptive(noise)?;
    robust(noise)?;
    plants(noise)?;
    wrappers(noise)
}

fn rules(noise: &mut Noise) -> Result<(), Error> {
    let difference = BackwardDifference::new();
    let sliding = SlidingMode::new(5.0)?;
    let fixed = sliding.with_antecedents(Fixed);
    let gradient = GradientDescent::new(5.0)?;
    stand(chain::<_, _, 1, 3>(difference, sliding)?, noise);
    stand(chain::<_, _, 2, 3>(difference, sliding)?, noise);
    stand(chain::<_, _, 3, 3>(difference, sliding)?, noise);
    stand(chain::<_, _, 4, 2>(difference, sliding)?, noise);
    for switching in [Switching::Explicit { delta: 0.05 }, Switching::Implicit { delta: 2.0 }] {
        stand(chain::<_, _, 2, 3>(difference, sliding.with_switching(switching)?)?, noise);
        stand(chain::<_, _, 2, 3>(difference, fixed.with_switching(switching)?)?, noise);
    }
    stand(chain::<_, _, 2, 3>(difference, gradient)?, noise);
    stand(chain::<_, _, 2, 3>(difference, Bounded::new(sliding, 1.0)?)?, noise);
    stand(chain::<_, _, 2, 3>(difference, Bounded::new(gradient, 1.0)?.with_rate(1.0)?)?, noise);
    let leaking = gradient.with_leakage(0.1)?.with_projection(2.0)?;
    stand(chain::<_, _, 2, 3>(difference, leaking)?, noise);
    let adaptive = AdaptiveSlidingMode::new(sliding, 1.0, 0.1)?;
    stand(chain::<_, _, 2, 3>(difference, adaptive)?, noise);
    stand(chain::<_, _, 2, 3>(difference, adaptive.with_ceiling(50.0)?)?, noise);
    let least_squares = RecursiveLeastSquares::new(10.0)?;
    stand(chain::<_, _, 2, 3>(difference, least_squares)?, noise);
    stand(chain::<_, _, 2, 3>(difference, least_squares.with_memory(2.0)?)?, noise);
    stand(chain::<_, _, 2, 3>(difference, NullRule)?, noise);
    Ok(())
}

fn networks(noise: &mut Noise) -> Result<(), Error> {
    let difference = BackwardDifference::new();
    let rule = SlidingMode::new(5.0)?.with_antecedents(Fixed);
    let triangular = TriangularNetwork::<Real, 2, 3>::evenly_spaced([2.0; 2])?;
    stand(trained(triangular, difference, rule)?, noise);
    for reduction in [TypeReduction::NieTan, TypeReduction::Bmm { m: 0.3 }] {
        let gaussian = IntervalNetwork::<_, Real, 2, 3>::gaussian([2.0; 2], 0.2, reduction)?;
        stand(trained(gaussian, difference, rule)?, noise);
        let elliptic = IntervalNetwork::<_, Real, 2, 3>::elliptic([2.0; 2], [0.6, 2.0], reduction)?;
        stand(trained(elliptic, difference, rule)?, noise);
    }
    Ok(())
}

fn sources(noise: &mut Noise) -> Result<(), Error> {
    let rule = SlidingMode::new(5.0)?;
    stand(chain::<_, _, 2, 3>(Measured, rule)?, noise);
    stand(chain::<_, _, 2, 3>(FeedbackError, rule)?, noise);
    stand(chain::<_, _, 2, 3>(FilteredDifference::new(0.05)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(ModelAided::new(), rule)?, noise);
    stand(chain::<_, _, 2, 3>(RobustExact::first_order(5.0)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(RobustExact::second_order(5.0)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(RobustExact::third_order(5.0)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(HighGain::first_order(20.0)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(HighGain::second_order(20.0)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(Tracking::new(5.0, 0.05)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(OfState::new(FilteredDifference::new(0.05)?), rule)?, noise);
    stand(chain::<_, _, 2, 3>(Conditional::new(BackwardDifference::new(), 0.1)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(Redundant::new(Measured, ModelAided::new()), rule)?, noise);
    Ok(())
}

/// PID, state feedback with the gains of linear-quadratic regulators, backstepping.
fn classical(noise: &mut Noise) -> Result<(), Error> {
    let gains = PidGains::new(4.0)?.with_integral_time(2.0)?.with_derivative_time(0.5, 0.05)?;
    for anti_windup in [
        AntiWindup::None,
        AntiWindup::BackCalculation { tracking_time: 1.0 },
        AntiWindup::Conditional { tolerance: 0.1 },
    ] {
        let mut pid = Pid::<Real, 2>::new(gains.with_weights(0.5, 0.5)?, anti_windup)?;
        stand(&mut pid, noise);
        pid.set_gains(PidGains::parallel(4.0, 2.0, 2.0, 0.05)?)?;
        pid.start_at(1.0)?;
        stand(pid, noise);
    }

    // What is known when the program is built would be computed there, and a path to a panic with it.
    let weights = black_box(Weights::diagonal([1.0, 0.1], [0.1])?);
    let (a, b) = ([[0.0, 9.81], [1.0, -0.1]].into(), [[0.0, 2.0]].into());
    let at = black_box(Jacobians { a, b, c: [[1.0], [0.0]].into() });
    stand(StateFeedback::lqr(&at, &weights, [0.5])?, noise);
    stand(StateFeedback::sampled_lqr(&at, &weights, 0.01, [0.5])?, noise);
    let chain = IntegratorChain::<Real, 3>::new();
    let gains = Gains::lqr(black_box([1.0, 0.1, 0.0]), 0.1)?;
    stand(FeedbackLinearization::new(chain, gains), noise);
    let gains = Gains::sampled_lqr(black_box([1.0, 0.1, 0.0]), 0.1, 0.01)?;
    stand(FeedbackLinearization::new(chain, gains), noise);
    // From five states on matrices are inverted by elimination.
    let chain = IntegratorChain::<Real, 6>::new();
    stand(FeedbackLinearization::new(chain, Gains::lqr(black_box([1.0; 6]), 0.1)?), noise);

    stand(Backstepping::new(IntegratorChain::<Real, 1>::new(), [2.0])?, noise);
    stand(Backstepping::new(IntegratorChain::<Real, 3>::new(), [1.0, 2.0, 3.0])?, noise);
    Ok(())
}

fn adaptive(noise: &mut Noise) -> Result<(), Error> {
    let new = ModelReferenceAdaptive::new(feedback::<2>()?, StateRegressor, 5.0, [1.0; 2])?;
    stand(new, noise);
    let ball = Projection::Ball { radius: 2.0 };
    let effective = new.with_unknown_effectiveness(1.0, [0.5, 2.0])?.with_projection(ball)?;
    stand(effective.with_leakage(Leakage::Sigma { sigma: 0.1 })?, noise);
    let sides = Projection::Box { lower: [-1.0; 2].into(), upper: [1.0; 2].into() };
    let started = new.with_parameters([0.5; 2])?.with_model_at([0.1; 2])?.with_projection(sides)?;
    stand(started.with_leakage(Leakage::Error { sigma: 0.1 })?, noise);
    let waves = |x: &SVector<Real, 3>| SVector::from([1.0, x[0] * x[1]]);
    stand(ModelReferenceAdaptive::new(feedback::<3>()?, waves, 5.0, [1.0; 3])?, noise);
    Ok(())
}

/// Sliding modes, active disturbance rejection, and controllers with a compensator on top.
fn robust(noise: &mut Noise) -> Result<(), Error> {
    let (plain, double) = (IntegratorChain::<Real, 1>::new(), IntegratorChain::<Real, 2>::new());
    let surface = SlidingSurface::from_lambda(2.0)?;
    let first_order = SlidingModeControl::for_bound(double, surface, 2.0, 1.0)?;
    stand(SlidingModeControl::new(plain, SlidingSurface::from_lambda(2.0)?, 3.0)?, noise);
    stand(first_order, noise);
    stand(first_order.with_saturation(0.1)?, noise);
    for switching in [Switching::Explicit { delta: 0.05 }, Switching::Implicit { delta: 2.0 }] {
        stand(first_order.with_switching(switching)?, noise);
    }
    let second_order = SuperTwisting::new(double, surface, SuperTwistingGains::for_rate(2.0)?);
    stand(second_order, noise);
    stand(second_order.with_stepping(Stepping::Explicit), noise);
    let integral = IntegralSlidingMode::new(3.0)?;
    stand(Clelc::new(feedback::<2>()?, integral), noise);

    let gains = Gains::from_lambda(2.0)?;
    stand(ActiveDisturbanceRejection::<Real, 1>::new(Gains::from_lambda(2.0)?, 20.0, 1.0)?, noise);
    stand(ActiveDisturbanceRejection::<Real, 2>::new(gains, 20.0, 1.0)?, noise);
    stand(ActiveDisturbanceRejection::<Real, 4>::new(Gains::from_lambda(2.0)?, 20.0, 1.0)?, noise);

    let network = FuzzyNetwork::<Real, 2, 3>::evenly_spaced([2.0; 2])?;
    let learner = NeuroFuzzy::new(network, ModelAided::new(), SlidingMode::new(5.0)?);
    let pid = Pid::<Real, 2>::new(PidGains::new(4.0)?, AntiWindup::None)?;
    stand(Compensated::new(pid, double, learner), noise);
    stand(Compensated::new(feedback::<2>()?, double, integral), noise);
    stand(Compensated::new(second_order, double, learner), noise);
    Ok(())
}

/// Several chains: arrays and pairs of controllers, arm and robot.
fn plants(noise: &mut Noise) -> Result<(), Error> {
    let learning = chain::<_, _, 2, 3>(ModelAided::new(), SlidingMode::new(5.0)?)?;
    let link = Link { mass: 1.0, length: 0.5, centre: 0.25, inertia: 0.02 };
    let arm = TwoLinkArm::new([link; 2], [0.1; 2], 9.81)?;
    stand::<_, 4, 2>(Decoupling::new(arm, [learning; 2]), noise);
    stand::<_, 4, 2>(Decoupling::new(arm, (learning, feedback::<2>()?)), noise);
    for (direction, standstill) in
        [(Direction::Forward, Standstill::Hold), (Direction::Reverse, Standstill::Refuse)]
    {
        stand(UnicycleController::new([learning; 2], direction, 0.05, standstill)?, noise);
    }
    Ok(())
}

/// A controller that is chosen at run time.
type Any =
    dyn Controller<2, 1, Scalar = Real, Reference = Reference<Real, 2>, Command = SVector<Real, 1>>;

fn wrappers(noise: &mut Noise) -> Result<(), Error> {
    let learning = chain::<_, _, 2, 3>(ModelAided::new(), SlidingMode::new(5.0)?)?;
    let limits = (Saturation::<Real, 1>::symmetric([1.0])?, RateLimit::new([1.0])?);
    stand(Limited::new(learning, limits), noise);
    let mut supervised = Supervised::new(Limited::new(learning, limits), [1.0])?;
    for mode in [Mode::Manual, Mode::Automatic(LearningMode::Active), Mode::Manual] {
        supervised.select(mode);
        stand(&mut supervised, noise);
    }
    let rule = SlidingMode::new(5.0)?;
    let network = FuzzyNetwork::<Real, 2, 3>::evenly_spaced([2.0; 2])?;
    let watchdog = Watchdog::new(rule.certificate(0.01, 2.0)?, 0.1, 0.05)?;
    let guarded = Guarded::new(NeuroFuzzy::new(network, ModelAided::new(), rule), watchdog);
    stand(Clelc::new(feedback()?, guarded.with_fallback(1.0)?), noise);
    let plain: FeedbackLinearization<IntegratorChain<Real, 2>, 2> = feedback()?;
    stand::<_, 2, 1>(&mut Limited::new(plain, limits), noise);
    stand::<_, 3, 1>(Padded::<_, 2>(plain), noise);
    let (mut plain, mut learning) = (InputOnly(plain), InputOnly(learning));
    let choice: [&mut Any; 2] = [&mut plain, &mut learning];
    for controller in choice {
        stand(controller, noise);
    }
    Ok(())
}
