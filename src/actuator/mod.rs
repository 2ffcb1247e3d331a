//! Actuators: what becomes of a commanded input on its way to the plant.
//!
//! | actuator | what arrives |
//! |---|---|
//! | [`Ideal`] | what was commanded |
//! | [`Saturation`] | each input within its limits |
//! | [`RateLimit`] | no input faster than its limit |
//! | a pair `(A, B)` | B of what A lets through |
//!
//! An [`Actuator`] is a state machine without a clock, called once a period. [`Limited`](crate::controller::Limited) puts one behind a
//! controller and tells the controller what arrived.
//!
//! This module depends on nothing but [`Scalar`] and [`Error`].

mod ideal;
mod rate_limit;
mod saturation;

pub use ideal::Ideal;
pub use rate_limit::RateLimit;
pub use saturation::Saturation;

use nalgebra::SVector;

use crate::{Error, Scalar};

/// A sampled actuator for NU inputs.
pub trait Actuator<T: Scalar, const NU: usize>: Clone {
    /// The actuator after a period of `dt` > 0 seconds, and the input that the plant receives over it when `u` is commanded. Both
    /// are finite if `u` is.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for a bad `dt`, [`Error::NonFiniteEntry`] for a bad `u`.
    fn driven(&self, u: &SVector<T, NU>, dt: T) -> Result<(Self, SVector<T, NU>), Error>;
}

/// One actuator behind another.
impl<T: Scalar, A: Actuator<T, NU>, B: Actuator<T, NU>, const NU: usize> Actuator<T, NU>
    for (A, B)
{
    fn driven(&self, u: &SVector<T, NU>, dt: T) -> Result<(Self, SVector<T, NU>), Error> {
        let (first, passed) = self.0.driven(u, dt)?;
        let (second, arrived) = self.1.driven(&passed, dt)?;
        Ok(((first, second), arrived))
    }
}
