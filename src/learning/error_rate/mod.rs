mod backward_difference;
mod filtered_difference;
mod measured;
mod model_aided;

pub use backward_difference::BackwardDifference;
pub use filtered_difference::FilteredDifference;
pub use measured::Measured;
pub use model_aided::ModelAided;

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
/// The differences multiply noise on x_n by 1/dt; the filter trades that against delay. A difference looks back at the period
/// before the sample, the feedback u_b at the sample itself, so in a fast transient they make s differ from −(u_n + Δ) by the
/// motion of u_b over half a period; [`ModelAided`] removes that.
pub trait ErrorRate<T, const N: usize> {
    /// ė_n at this sample, where `u_n` is the learned term as it stands and `dt > 0` the time since the sample before.
    ///
    /// # Errors
    /// [`Error::Missing`] if the source needs a measurement that was not given.
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error>;
}
