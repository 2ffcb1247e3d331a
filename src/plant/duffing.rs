use nalgebra::SVector;

use super::{FeedbackLinearizable, SmoothPlant};
use crate::{
    Error, Scalar,
    differentiation::Smooth,
    error::{finite, not_negative},
    scalar::constant,
};

/// The forced Duffing oscillator: ẍ₁ = −d·ẋ₁ − α·x₁ − β·x₁³ + u. Dimensionless.
///
/// A spring that hardens for β > 0 and softens for β < 0; for α < 0 < β it has two wells, at ±√(−α/β), and the origin between them is unstable.
///
/// # References
/// J. Guckenheimer, P. Holmes, *Nonlinear Oscillations, Dynamical Systems, and Bifurcations of Vector Fields*, 2.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Duffing<T> {
    damping: T,
    linear: T,
    cubic: T,
}

impl<T: Scalar> Duffing<T> {
    /// An oscillator with `damping` d ≥ 0 and a spring of `linear` stiffness α and `cubic` stiffness β, of any sign.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(damping: T, linear: T, cubic: T) -> Result<Self, Error> {
        Ok(Self {
            damping: not_negative("damping", damping)?,
            linear: finite("linear", linear)?,
            cubic: finite("cubic", cubic)?,
        })
    }

    /// The energy ½·ẋ₁² + ½·α·x₁² + ¼·β·x₁⁴; it changes by u·ẋ₁ − d·ẋ₁².
    pub fn energy(&self, x: &SVector<T, 2>) -> T {
        let square = x[0] * x[0];
        let spring = self.linear + self.cubic * square * constant(0.5);
        (x[1] * x[1] + spring * square) * constant(0.5)
    }

    #[inline]
    fn acceleration<S: Smooth<T>>(&self, [x, x_dot]: [S; 2]) -> S {
        -(x_dot * self.damping + x * (x * x * self.cubic + self.linear))
    }
}

impl<T: Scalar> FeedbackLinearizable<2> for Duffing<T> {
    type Scalar = T;

    fn drift(&self, x: &SVector<T, 2>) -> T {
        self.acceleration((*x).into())
    }

    fn input_gain(&self, _x: &SVector<T, 2>) -> T {
        T::one()
    }
}

impl<T: Scalar> SmoothPlant<2, 1> for Duffing<T> {
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

checked! {
    [T: Scalar] Duffing<T>, [T] { damping: T, linear: T, cubic: T } =>
    Self::new(damping, linear, cubic)
}
