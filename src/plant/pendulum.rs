use nalgebra::SVector;

use super::{FeedbackLinearizable, SmoothPlant};
use crate::{
    Error, Scalar,
    differentiation::Smooth,
    elementary::cos,
    error::{not_negative, positive},
};

/// A point mass on a massless rod, driven by a torque at the pivot: m·l²·θ̈ = τ − d·θ̇ − m·g·l·sin θ.
///
/// State x = (θ, θ̇) in rad and rad/s, θ = 0 hanging down; input u = τ in N·m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pendulum<T> {
    mass: T,
    length: T,
    damping: T,
    gravity: T,
}

impl<T: Scalar> Pendulum<T> {
    /// A pendulum of `mass` m > 0 in kg, `length` l > 0 in m and viscous `damping` d ≥ 0 in N·m·s/rad, under `gravity` g ≥ 0
    /// in m/s².
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(mass: T, length: T, damping: T, gravity: T) -> Result<Self, Error> {
        Ok(Self {
            mass: positive("mass", mass)?,
            length: positive("length", length)?,
            damping: not_negative("damping", damping)?,
            gravity: not_negative("gravity", gravity)?,
        })
    }

    /// The moment of inertia m·l² about the pivot, in kg·m².
    pub fn inertia(&self) -> T {
        self.mass * self.length * self.length
    }

    /// The mechanical energy ½·m·l²·θ̇² + m·g·l·(1 − cos θ) in J, zero at rest hanging down.
    pub fn energy(&self, x: &SVector<T, 2>) -> T {
        let kinetic = self.inertia() * x[1] * x[1] * crate::scalar::constant(0.5);
        kinetic + self.mass * self.gravity * self.length * (T::one() - cos(x[0]))
    }

    #[inline]
    fn acceleration<S: Smooth<T>>(&self, [theta, theta_dot]: [S; 2]) -> S {
        let damping = theta_dot * (self.damping / self.inertia());
        -(theta.sin() * (self.gravity / self.length)) - damping
    }
}

impl<T: Scalar> FeedbackLinearizable<2> for Pendulum<T> {
    type Scalar = T;

    fn drift(&self, x: &SVector<T, 2>) -> T {
        self.acceleration((*x).into())
    }

    fn input_gain(&self, _x: &SVector<T, 2>) -> T {
        self.inertia().recip()
    }
}

impl<T: Scalar> SmoothPlant<2, 1> for Pendulum<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, x: [S; 2]) -> [S; 2] {
        [x[1], self.acceleration(x)]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 2]) -> [[S; 2]; 1] {
        [[S::zero(), S::from(self.inertia().recip())]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [theta, _]: [S; 2]) -> [S; 1] {
        [theta]
    }
}

checked! {
    [T: Scalar] Pendulum<T>, [T] { mass: T, length: T, damping: T, gravity: T } =>
    Self::new(mass, length, damping, gravity)
}
