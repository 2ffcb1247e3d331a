mod backward_difference;
mod conditional;
mod filtered_difference;
mod measured;
mod model_aided;
mod redundant;

pub use backward_difference::BackwardDifference;
pub use conditional::Conditional;
pub use filtered_difference::FilteredDifference;
pub use measured::Measured;
pub use model_aided::ModelAided;
pub use redundant::Redundant;

use super::ClosedLoop;
use crate::Error;

/// The source of ė_n, the rate of the last error: what makes s = ė_n + u_b known.
///
/// ė_n is meant just after the sample, under the input that the loop would apply without learning any further. The sources
/// differ in what they need, in how late they are, and in what they say at the first sample:
///
/// | source | needs | ė_n at sample k | delay | first sample |
/// |---|---|---|---|---|
/// | [`Measured`] | a sensor for ẋ_n | exact | 0 | exact |
/// | [`BackwardDifference`] | nothing | (e_n(k) − e_n(k−1))/dt | dt/2 | 0 |
/// | [`FilteredDifference`] | nothing | the same through 1/(τp + 1) | dt/2 + τ | 0 |
/// | [`ModelAided`] | the model | −u_b − u_n − Δ̂, Δ̂ the mean uncertainty of the last period | dt/2 | −u_b − u_n |
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
/// The differences multiply noise on x_n by 1/dt; the filter trades that against delay. A difference looks back at the period
/// before the sample, the feedback u_b at the sample itself, so in a fast transient they make s differ from −(u_n + Δ) by the
/// motion of u_b over half a period; [`ModelAided`] removes that.
pub trait ErrorRate<T, const N: usize> {
    /// ė_n at this sample, where `u_n` is the learned term as it stands and `dt > 0` the time since the sample before.
    ///
    /// # Errors
    /// [`Error::Missing`] if the source needs a measurement that was not given; [`Error::NonFinite`] for a sample so large that the next
    /// difference with it would leave the range of `T`.
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error>;
}
