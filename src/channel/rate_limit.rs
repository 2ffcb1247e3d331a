use nalgebra::SVector;

use super::{Channel, validate};
use crate::{
    Error, Scalar,
    error::{finite_vector, not_negative_vector},
};

/// A limit on the rate of each signal: uᵢ moves from where it was by at most rateᵢ·dt.
///
/// It steps at the start of the period and is held over it. Before the first sample it is 0, or where it is said to start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RateLimit<T, const N: usize> {
    rate: SVector<T, N>,
    u: SVector<T, N>,
}

impl<T: Scalar, const N: usize> RateLimit<T, N> {
    /// A channel at rest at 0 whose signals move by at most `rate` ≥ 0, in their units per second.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn new(rate: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let rate = rate.into();
        not_negative_vector("rate", &rate)?;
        Ok(Self { rate, u: SVector::zeros() })
    }

    /// The same channel, starting at `u`.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn starting_at(self, u: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let u = u.into();
        finite_vector("u", &u)?;
        Ok(Self { u, ..self })
    }
}

impl<T: Scalar, const N: usize> Channel<T, N> for RateLimit<T, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        // A reach beyond the range of T is no limit; what is within reach is taken as it is, without going there by a difference.
        let reach = self.rate * dt;
        let arrived =
            SVector::from_fn(|i, _| signal[i].max(self.u[i] - reach[i]).min(self.u[i] + reach[i]));
        Ok((Self { u: arrived, ..*self }, arrived))
    }
}

checked! {
    [T: Scalar, const N: usize] RateLimit<T, N>, [T]
    { rate: SVector<T, N>, u: SVector<T, N> } =>
    Self::new(rate).and_then(|limit| limit.starting_at(u))
}
