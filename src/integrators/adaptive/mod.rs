//! Steps whose length follows from a tolerance.

mod dense;
mod discontinuities;
mod embedded;
mod initial_step;
mod settings;
mod solver;
mod statistics;
mod step;
mod step_control;
mod tolerance;

pub(super) use dense::Dense;
pub(crate) use discontinuities::Discontinuities;
pub(super) use embedded::combination;
pub use embedded::{Attempt, Embedded, Point};
pub use settings::Adaptive;
pub use solver::Solver;
pub(super) use solver::at_most;
pub use statistics::Statistics;
pub use tolerance::Tolerance;
pub(super) use tolerance::norm;
