use super::ErrorRate;
use crate::{Error, differentiator::Differentiator, learning::ClosedLoop};

/// ė_n = ṙ_n − ẋ̂_n, with ẋ̂_n from any [`Differentiator`].
///
/// The reference knows its own rate ṙ_n = u_f, so only x_n is differentiated: a reference that jumps or turns sharply, or one without noise
/// beside a noisy x_n, does not pass through the differentiator. In between, when both move together, e_n is the smaller of the two, and
/// the differentiator alone, which takes e_n, has less to be late for. At the first sample ė_n = u_f, as ẋ̂_n = 0.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct OfState<D>(D);

impl<D> OfState<D> {
    /// x_n through `differentiator`.
    pub const fn new(differentiator: D) -> Self {
        Self(differentiator)
    }
}

impl<D: Differentiator, const N: usize> ErrorRate<D::Scalar, N> for OfState<D> {
    fn error_rate(
        &mut self,
        at: &ClosedLoop<D::Scalar, N>,
        _u_n: D::Scalar,
        dt: D::Scalar,
    ) -> Result<D::Scalar, Error> {
        Ok(at.u_f - self.0.update(at.x[N - 1], dt)?)
    }
}
