use nalgebra::SVector;

use super::Actuator;
use crate::{
    Error, Scalar,
    error::{finite_vector, not_negative, positive},
};

/// A limit on the rate of each input: uᵢ moves from where it was by at most rateᵢ·dt.
///
/// The input steps at the start of the period and is held over it. Before the first sample it is 0, or where the actuator is said to
/// start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RateLimit<T, const NU: usize> {
    rate: SVector<T, NU>,
    u: SVector<T, NU>,
}

impl<T: Scalar, const NU: usize> RateLimit<T, NU> {
    /// An actuator at rest at 0 whose inputs move by at most `rate` ≥ 0, in their units per second.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn new(rate: impl Into<SVector<T, NU>>) -> Result<Self, Error> {
        let rate = rate.into();
        for rate in rate.iter() {
            not_negative("rate", *rate)?;
        }
        Ok(Self { rate, u: SVector::zeros() })
    }

    /// The same actuator, starting at `u`.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn starting_at(self, u: impl Into<SVector<T, NU>>) -> Result<Self, Error> {
        let u = u.into();
        finite_vector("u", &u)?;
        Ok(Self { u, ..self })
    }
}

impl<T: Scalar, const NU: usize> Actuator<T, NU> for RateLimit<T, NU> {
    fn driven(&self, u: &SVector<T, NU>, dt: T) -> Result<(Self, SVector<T, NU>), Error> {
        positive("dt", dt)?;
        finite_vector("u", u)?;
        // A reach beyond the range of T is no limit; what is within reach is taken as it is, without going there by a difference.
        let reach = self.rate * dt;
        let arrived =
            SVector::from_fn(|i, _| u[i].max(self.u[i] - reach[i]).min(self.u[i] + reach[i]));
        Ok((Self { u: arrived, ..*self }, arrived))
    }
}

checked! {
    [T: Scalar, const NU: usize] RateLimit<T, NU>, [T]
    { rate: SVector<T, NU>, u: SVector<T, NU> } =>
    Self::new(rate).and_then(|limit| limit.starting_at(u))
}
