mod conditional;
mod differentiated;
mod feedback_error;
mod measured;
mod model_aided;
mod of_state;
mod redundant;

pub use conditional::Conditional;
pub use feedback_error::FeedbackError;
pub use measured::Measured;
pub use model_aided::ModelAided;
pub use of_state::OfState;
pub use redundant::Redundant;

use super::ClosedLoop;
use crate::Error;
#[cfg(doc)]
use crate::differentiator::{BackwardDifference, Differentiator};

/// The source of ė_n, the rate of the last error: what makes s = ė_n + u_b known.
///
/// ė_n is meant just after the sample, under the input that the loop would apply without learning any further. The sources
/// differ in what they need, in how late they are, and in what they say at the first sample:
///
/// | source | needs | ė_n at sample k | delay | first sample |
/// |---|---|---|---|---|
/// | [`Measured`] | a sensor for ẋ_n | exact | 0 | exact |
/// | any [`Differentiator`], such as [`BackwardDifference`] | nothing | its rate of e_n | its own, dt/2 | 0 |
/// | [`OfState`] around one | ṙ_n | u_f − its rate of x_n | its own | u_f |
/// | [`ModelAided`] through one | the model | −u_b − u_n − Δ̂, Δ̂ its rate of what the model leaves of x_n | its own, dt/2 by default | −u_b − u_n |
/// | [`FeedbackError`] | nothing | 0, so that s = u_b | – | 0 |
///
/// Which differentiator at which noise is told, with numbers, in [`differentiator`](crate::differentiator).
///
/// [`Redundant`] takes a second source where the first lacks its measurement.
///
/// # Saturated actuators
/// A difference takes the input that did not arrive for uncertainty, and what is learned from it winds up. Three remedies: [`ModelAided`] counts
/// only the input that arrived; [`Conditional`] stops learning where it pushes into the limit; [`Bounded`](super::Bounded) limits u_n. The
/// `paper` example prints a table of them on its robot, over slack to infeasible limits and three noise levels. `ModelAided` and
/// `Bounded` never diverge there, and match the plain difference where that one works. `ModelAided` with a boundary layer of δ = 2 m/s² is
/// the recommendation: it has no bound to choose, and stays better than feedback alone everywhere in the table.
///
/// A difference multiplies noise on x_n by 1/dt; filters trade that against delay. A differentiator of e_n looks back over its delay, the
/// feedback u_b at the sample itself, so in a fast transient they make s differ from −(u_n + Δ) by the motion of u_b over that time;
/// [`ModelAided`] removes that.
pub trait ErrorRate<T, const N: usize> {
    /// ė_n at this sample, where `u_n` is the learned term as it stands and `dt > 0` the time since the sample before.
    ///
    /// # Errors
    /// [`Error::Missing`] if the source needs a measurement that was not given, and those of a [`Differentiator`]: [`Error::NonFinite`] for a sample so
    /// large that the next difference with it would leave the range of `T`, too.
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error>;
}
