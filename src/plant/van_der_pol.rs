use nalgebra::SVector;

use super::{FeedbackLinearizable, SmoothPlant};
use crate::{Error, Scalar, differentiation::Smooth, error::finite};

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

    #[inline]
    fn acceleration<S: Smooth<T>>(&self, [x, x_dot]: [S; 2]) -> S {
        (-(x * x) + T::one()) * self.mu * x_dot - x
    }
}

impl<T: Scalar> FeedbackLinearizable<2> for VanDerPol<T> {
    type Scalar = T;

    fn drift(&self, x: &SVector<T, 2>) -> T {
        self.acceleration((*x).into())
    }

    fn input_gain(&self, _x: &SVector<T, 2>) -> T {
        T::one()
    }
}

impl<T: Scalar> SmoothPlant<2, 1> for VanDerPol<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, x: [S; 2]) -> [S; 2] {
        [x[1], self.acceleration(x)]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 2]) -> [[S; 2]; 1] {
        [[S::zero(), S::one()]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [x, _]: [S; 2]) -> [S; 1] {
        [x]
    }
}

checked! { [T: Scalar] VanDerPol<T>, [T] { mu: T } => Self::new(mu) }
