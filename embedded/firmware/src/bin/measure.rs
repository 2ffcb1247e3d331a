//! What one controller takes. Which one is said when the program is built, by the environment variable SUBJECT, so that the size of the
//! program tells what it takes of the flash.
#![no_std]
#![no_main]

use core::hint::black_box;

use brunovsky::{
    Error,
    controller::{
        ActiveDisturbanceRejection, StateRegressor,
        lqr::Weights,
        sliding_mode::{
            IntegralSlidingMode, SlidingModeControl, SlidingSurface, SuperTwisting,
            SuperTwistingGains,
        },
    },
    fuzzy::{IntervalNetwork, TriangularNetwork, TypeReduction, UncertainGaussian},
    learning::{AdaptiveSlidingMode, Fixed, RecursiveLeastSquares},
    plant::{IntegratorChain, Jacobians},
    prelude::*,
};
use cortex_m_rt::entry;
use firmware::{
    by_hand::ByHand,
    exit,
    measure::{behind_dyn, by_hand, holding, nothing, study, waves},
    recordings,
};
use replay::{Real, Robot, ThirdOrderLoop, chain, feedback, trained};

#[entry]
fn main() -> ! {
    exit(subject())
}

macro_rules! subjects {
    ($($name:literal => $measured:expr,)+) => {
        fn subject() -> Result<(), Error> {
            $(if const { same(env!("SUBJECT"), $name) } { return $measured; })+
            Err(Error::Missing { name: "subject" })
        }
    };
}

subjects! {
    "nothing" => nothing(),
    "feedback linearization, N = 2" => waves::<_, 2>(feedback()?),
    "feedback linearization, N = 3" => waves::<_, 3>(feedback()?),
    "PID with filtered derivative and anti-windup" => waves::<_, 2>(pid()?),
    "state feedback, N = 2" => holding::<_, 2>(StateFeedback::new([[10.0], [5.0]].into(), [0.0])?, SVector::zeros()),
    "state feedback, N = 2, LQR gain computed on the board" => holding::<_, 2>(regulator()?, SVector::zeros()),
    "model reference adaptive control, N = 2" => waves::<_, 2>(adaptive()?),
    "backstepping, N = 2" => waves::<_, 2>(Backstepping::new(IntegratorChain::new(), [2.0; 2])?),
    "sliding mode control, N = 2" => waves::<_, 2>(SlidingModeControl::new(IntegratorChain::new(), SlidingSurface::from_lambda(2.0)?, 3.0)?),
    "super-twisting, N = 2" => waves::<_, 2>(super_twisting()?),
    "integral sliding mode, N = 2" => waves::<_, 2>(Clelc::new(feedback()?, IntegralSlidingMode::new(3.0)?)),
    "active disturbance rejection, N = 2" => waves::<_, 2>(ActiveDisturbanceRejection::new(Gains::from_lambda(2.0)?, 20.0, 1.0)?),
    "CLELC, N = 2, K = 3" => waves(chain::<_, _, 2, 3>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 2, K = 5" => waves(chain::<_, _, 2, 5>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 3, K = 3" => waves(chain::<_, _, 3, 3>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 3, K = 5" => waves(chain::<_, _, 3, 5>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 4, K = 3" => waves(chain::<_, _, 4, 3>(BackwardDifference::new(), set_valued()?)?),
    "model-aided, boundary layer, N = 2, K = 3" => waves(chain::<_, _, 2, 3>(ModelAided::new(), layered()?)?),
    "the same by hand, N = 2, K = 3" => by_hand(ByHand::new(layered()?)?),
    "the same behind dyn, N = 2, K = 3" => behind_dyn(chain::<_, _, 2, 3>(ModelAided::new(), layered()?)?),
    "model-aided, boundary layer, N = 3, K = 3" => waves(chain::<_, _, 3, 3>(ModelAided::new(), layered()?)?),
    "fixed antecedents, N = 2, K = 3" => waves(chain::<_, _, 2, 3>(BackwardDifference::new(), fixed()?)?),
    "fixed antecedents, N = 3, K = 3" => waves(chain::<_, _, 3, 3>(BackwardDifference::new(), fixed()?)?),
    "PID and a model-aided network, 9 rules" => waves(Compensated::new(pid()?, IntegratorChain::new(), learner()?)),
    "adaptive sliding mode, 9 rules" => waves(chain::<_, _, 2, 3>(BackwardDifference::new(), AdaptiveSlidingMode::new(set_valued()?, 1.0, 0.1)?)?),
    "triangular memberships, 9 rules" => waves(trained(triangular()?, BackwardDifference::new(), fixed()?)?),
    "interval type 2, 9 rules" => waves(trained(interval()?, BackwardDifference::new(), fixed()?)?),
    "least squares, 9 rules" => waves(chain::<_, _, 2, 3>(BackwardDifference::new(), least_squares()?)?),
    "the third-order study" => study::<ThirdOrderLoop>(recordings::THIRD_ORDER),
    "the robot: two axes, unicycle, limits" => study::<Robot>(recordings::ROBOT),
}

fn pid() -> Result<Pid<Real, 2>, Error> {
    let gains = PidGains::new(4.0)?.with_integral_time(2.0)?.with_derivative_time(0.5, 0.05)?;
    Pid::new(gains, AntiWindup::BackCalculation { tracking_time: 1.0 })
}

fn regulator() -> Result<StateFeedback<Real, 2, 1>, Error> {
    let (a, b) = ([[0.0, 9.81], [1.0, -0.1]].into(), [[0.0, 2.0]].into());
    let at = black_box(Jacobians { a, b, c: [[1.0], [0.0]].into() });
    StateFeedback::lqr(&at, &black_box(Weights::diagonal([1.0, 0.1], [0.1])?), [0.0])
}

fn adaptive()
-> Result<ModelReferenceAdaptive<IntegratorChain<Real, 2>, StateRegressor, 2, 2>, Error> {
    ModelReferenceAdaptive::new(feedback()?, StateRegressor, 5.0, [1.0; 2])
}

fn super_twisting() -> Result<SuperTwisting<IntegratorChain<Real, 2>, 2>, Error> {
    let gains = SuperTwistingGains::for_rate(2.0)?;
    Ok(SuperTwisting::new(IntegratorChain::new(), SlidingSurface::from_lambda(2.0)?, gains))
}

fn learner()
-> Result<NeuroFuzzy<FuzzyNetwork<Real, 2, 3>, ModelAided<Real>, SlidingMode<Real>>, Error> {
    let network = FuzzyNetwork::evenly_spaced([2.0; 2])?;
    Ok(NeuroFuzzy::new(network, ModelAided::new(), layered()?))
}

fn set_valued() -> Result<SlidingMode<Real>, Error> {
    SlidingMode::new(5.0)
}

fn layered() -> Result<SlidingMode<Real>, Error> {
    set_valued()?.with_switching(Switching::Implicit { delta: 2.0 })
}

fn triangular() -> Result<TriangularNetwork<Real, 2, 3>, Error> {
    TriangularNetwork::evenly_spaced([2.0; 2])
}

fn interval() -> Result<IntervalNetwork<UncertainGaussian<Real>, Real, 2, 3>, Error> {
    IntervalNetwork::gaussian([2.0; 2], 0.2, TypeReduction::NieTan)
}

fn least_squares() -> Result<RecursiveLeastSquares<Real, 2, 3>, Error> {
    RecursiveLeastSquares::new(10.0)?.with_memory(2.0)
}

fn fixed() -> Result<SlidingMode<Real, Fixed>, Error> {
    Ok(set_valued()?.with_antecedents(Fixed))
}

const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}
