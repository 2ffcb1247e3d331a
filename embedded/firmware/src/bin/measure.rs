//! What one controller takes. Which one is said when the program is built, by the environment variable SUBJECT, so that the size of the
//! program tells what it takes of the flash.
#![no_std]
#![no_main]

use brunovsky::{
    Error,
    fuzzy::{IntervalNetwork, TriangularNetwork, TypeReduction, UncertainGaussian},
    learning::{Fixed, RecursiveLeastSquares},
    prelude::*,
};
use cortex_m_rt::entry;
use firmware::{
    exit,
    measure::{nothing, study, waves},
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
    "CLELC, N = 2, K = 3" => waves(chain::<_, _, 2, 3>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 2, K = 5" => waves(chain::<_, _, 2, 5>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 3, K = 3" => waves(chain::<_, _, 3, 3>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 3, K = 5" => waves(chain::<_, _, 3, 5>(BackwardDifference::new(), set_valued()?)?),
    "CLELC, N = 4, K = 3" => waves(chain::<_, _, 4, 3>(BackwardDifference::new(), set_valued()?)?),
    "model-aided, boundary layer, N = 2, K = 3" => waves(chain::<_, _, 2, 3>(ModelAided::new(), layered()?)?),
    "model-aided, boundary layer, N = 3, K = 3" => waves(chain::<_, _, 3, 3>(ModelAided::new(), layered()?)?),
    "fixed antecedents, N = 2, K = 3" => waves(chain::<_, _, 2, 3>(BackwardDifference::new(), fixed()?)?),
    "fixed antecedents, N = 3, K = 3" => waves(chain::<_, _, 3, 3>(BackwardDifference::new(), fixed()?)?),
    "triangular memberships, 9 rules" => waves(trained(triangular()?, BackwardDifference::new(), fixed()?)?),
    "interval type 2, 9 rules" => waves(trained(interval()?, BackwardDifference::new(), fixed()?)?),
    "least squares, 9 rules" => waves(chain::<_, _, 2, 3>(BackwardDifference::new(), least_squares()?)?),
    "the third-order study" => study::<ThirdOrderLoop>(recordings::THIRD_ORDER),
    "the robot: two axes, unicycle, limits" => study::<Robot>(recordings::ROBOT),
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
