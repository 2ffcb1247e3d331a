use nalgebra::SVector;

use super::FeedbackLinearizable;
use crate::{Error, Scalar, error::finite};

/// The forced Van der Pol oscillator: ẍ₁ = μ·(1 − x₁²)·ẋ₁ − x₁ + u. Dimensionless.
///
/// For μ > 0 the origin is unstable and the free motion ends on a limit cycle of amplitude close to 2.
///
/// # References
/// B. van der Pol, "On relaxation-oscillations", Philosophical Magazine 2(11), 1926.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VanDerPol<T> {
    mu: T,
}

impl<T: Scalar> VanDerPol<T> {
    /// An oscillator with damping parameter μ, of any sign.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for a `mu` that is NaN or infinite.
    pub fn new(mu: T) -> Result<Self, Error> {
        Ok(Self { mu: finite("mu", mu)? })
    }
}

impl<T: Scalar> FeedbackLinearizable<2> for VanDerPol<T> {
    type Scalar = T;

    fn drift(&self, x: &SVector<T, 2>) -> T {
        self.mu * (T::one() - x[0] * x[0]) * x[1] - x[0]
    }

    fn input_gain(&self, _x: &SVector<T, 2>) -> T {
        T::one()
    }
}
