use super::ErrorRate;
use crate::{
    Error, Scalar,
    error::{finite, not_negative},
    learning::ClosedLoop,
};

/// Any source of ė_n, with learning stopped while the actuator is limited and learning would push further into the limit (conditional
/// integration).
///
/// What the input missed over the last period is d = b·(u − u_asked). If |d| exceeds the tolerance and s has the opposite sign, so that
/// u_n would grow the way that the actuator does not follow, then ė_n = −u_b, that is s = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditional<E, T> {
    source: E,
    tolerance: T,
}

impl<E, T: Scalar> Conditional<E, T> {
    /// `source`, stopped where more than `tolerance` ≥ 0 of the input is missing, in the units of ẋ_n.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn new(source: E, tolerance: T) -> Result<Self, Error> {
        Ok(Self { source, tolerance: not_negative("tolerance", tolerance)? })
    }
}

impl<T: Scalar, E: ErrorRate<T, N>, const N: usize> ErrorRate<T, N> for Conditional<E, T> {
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error> {
        // An infinite rate would be replaced, and stay in the memory of the source.
        let rate = finite("rate of e_n", self.source.error_rate(at, u_n, dt)?)?;
        let missing = at.gain * (at.u - at.asked);
        let s = rate + at.u_b;
        let pushing =
            (missing > T::zero() && s < T::zero()) || (missing < T::zero() && s > T::zero());
        Ok(if pushing && missing.abs() > self.tolerance { -at.u_b } else { rate })
    }
}

checked! {
    [E, T: Scalar] Conditional<E, T>, [E, T] { source: E, tolerance: T } =>
    Self::new(source, tolerance)
}
