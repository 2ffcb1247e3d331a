//! The plants, what happens on them, and what is recorded.

mod flexible_joint;
mod pendulum;
mod robot;
mod third_order;

pub use flexible_joint::FlexibleJointWorld;
pub use pendulum::PendulumWorld;
pub use robot::RobotWorld;
pub use third_order::ThirdOrderWorld;

use brunovsky::prelude::*;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::contestants::{Any, Contestant};

/// What happens from [`Story::switched`] on. Before, the plant is the model.
#[derive(Clone, Copy, PartialEq)]
pub enum Trial {
    /// A constant load on the input: what the search may see.
    Search,
    /// The uncertainty that nobody was told of.
    Test,
}

impl Trial {
    /// Its own random numbers, the same for every controller.
    fn random(self) -> ChaCha8Rng {
        ChaCha8Rng::seed_from_u64(self as u64)
    }
}

/// When things happen, in s.
#[derive(Clone, Copy)]
pub struct Story {
    /// From here on the nominal response counts as steady.
    pub settled: f64,
    /// From here on there is an uncertainty.
    pub switched: f64,
    /// From here on the response to it counts as steady.
    pub steady: f64,
    /// The end.
    pub end: f64,
}

/// A control sample.
#[derive(Clone, Copy)]
pub struct Row {
    pub t: f64,
    /// The signed error whose way to zero is the step response.
    pub step: f64,
    /// The size of the error.
    pub error: f64,
    /// The input.
    pub u: f64,
}

/// What there is to say of a plant.
#[derive(Clone, Copy)]
pub struct About {
    pub name: &'static str,
    /// What an error is, and its unit.
    pub error: &'static str,
    /// The period of the controllers in s.
    pub period: f64,
    pub story: Story,
}

/// A plant to be compared on, whose controllers are those of chains of order N.
pub trait World<const N: usize>: Sync {
    fn about(&self) -> About;

    fn contestants(&self) -> Result<Vec<Contestant<N>>, Error>;

    /// One run under controllers that `make` makes, as many as the plant has chains.
    fn run(
        &self,
        make: &dyn Fn() -> Result<Any<N>, Error>,
        sees_output: bool,
        trial: Trial,
    ) -> Result<Vec<Row>, Error>;
}

/// A plant by its law ẋ = F(t, x, u).
struct Law<F>(F);

impl<F, const NX: usize, const NU: usize> Plant<NX, NU> for Law<F>
where
    F: Fn(f64, &SVector<f64, NX>, &SVector<f64, NU>) -> SVector<f64, NX>,
{
    type Scalar = f64;

    fn derivative(&self, t: f64, x: &SVector<f64, NX>, u: &SVector<f64, NU>) -> SVector<f64, NX> {
        (self.0)(t, x, u)
    }
}

/// What is farther off than this many times its start has left.
const LOST: f64 = 100.0;

/// The rows of a run, which is over when the plant is lost.
fn recorded<S>(
    run: impl Iterator<Item = Result<S, Error>>,
    row: impl Fn(&S) -> Row,
) -> Result<Vec<Row>, Error> {
    let mut rows: Vec<Row> = Vec::new();
    for sample in run {
        let row = row(&sample?);
        let limit = LOST * rows.first().map_or(row.error, |first| first.error);
        if row.error > limit {
            return Err(Error::NotBelow { name: "error", value: row.error, limit });
        }
        rows.push(row);
    }
    Ok(rows)
}
