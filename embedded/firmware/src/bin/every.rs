//! Every controller, every rule and every source of ė_n, under calls of any kind with numbers of any bits. That it links is the proof that no
//! path leads to a panic, see [`firmware`]; that it ends is a test.
#![no_std]
#![no_main]

use brunovsky::{
    Error,
    channel::{RateLimit, Saturation},
    controller::unicycle::{Direction, Standstill, UnicycleController},
    fuzzy::{IntervalNetwork, TriangularNetwork, TypeReduction},
    learning::{
        AdaptiveSlidingMode, Bounded, Conditional, FeedbackError, Fixed, RecursiveLeastSquares,
        Redundant,
    },
    plant::{IntegratorChain, Link, TwoLinkArm},
    prelude::*,
};
use cortex_m_rt::entry;
use firmware::{
    exit,
    hostile::{Noise, stand},
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
    stand(feedback::<1>()?, noise);
    stand(feedback::<6>()?, noise);
    stand(Clelc::new(feedback::<2>()?, NullCompensator::new(Measured)), noise);
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
    stand(chain::<_, _, 2, 3>(Conditional::new(BackwardDifference::new(), 0.1)?, rule)?, noise);
    stand(chain::<_, _, 2, 3>(Redundant::new(Measured, ModelAided::new()), rule)?, noise);
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
    Ok(())
}
