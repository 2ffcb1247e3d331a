use nalgebra::SVector;

use super::{SmoothPlant, smooth::control_affine};
use crate::{
    Error, Scalar,
    differentiation::Smooth,
    error::{not_negative, positive},
    scalar::constant,
};

/// An iron ball below an electromagnet: m·ÿ = m·g − c·ẏ − ½·L₀·a·i²/(a + y)², d(L(y)·i)/dt = v − R·i, with L(y) = L₁ + L₀·a/(a + y).
///
/// State (y, ẏ, i) in m, m/s and A, with y the distance of the ball below the magnet, so that gravity pulls towards larger y; input v, the
/// voltage in V; output y. The voltage acts on y⃛ through the current: relative degree 3 where i ≠ 0, and none at i = 0, where the pull has
/// no slope. A current and its opposite pull alike.
///
/// Assumes y > −a, and no saturation of the iron.
///
/// # References
/// H. K. Khalil, *Nonlinear Systems*, 3rd ed., exercise 1.18.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MagneticLevitation<T> {
    mass: T,
    friction: T,
    gravity: T,
    magnet: Electromagnet<T>,
}

/// The magnet of [`MagneticLevitation`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Electromagnet<T> {
    /// L₁ > 0 in H: the inductance with the ball far away.
    pub far: T,
    /// L₀ > 0 in H: what the ball adds to it at y = 0.
    pub near: T,
    /// a > 0 in m: at the distance y = a it adds half of that.
    pub range: T,
    /// R > 0 in Ω.
    pub resistance: T,
}

impl<T: Scalar> MagneticLevitation<T> {
    /// A ball of `mass` m > 0 in kg with viscous `friction` c ≥ 0 in N·s/m, under `gravity` g > 0 in m/s² and `magnet`.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(mass: T, friction: T, gravity: T, magnet: Electromagnet<T>) -> Result<Self, Error> {
        positive("far inductance", magnet.far)?;
        positive("near inductance", magnet.near)?;
        positive("range", magnet.range)?;
        positive("resistance", magnet.resistance)?;
        Ok(Self {
            mass: positive("mass", mass)?,
            friction: not_negative("friction", friction)?,
            gravity: positive("gravity", gravity)?,
            magnet,
        })
    }

    /// The state in which the ball floats at the distance `y` > −a under a positive current, and the voltage for it.
    pub fn equilibrium(&self, y: T) -> (SVector<T, 3>, T) {
        let Electromagnet { near, range, resistance, .. } = self.magnet;
        let weight = self.mass * self.gravity;
        let current = (range + y) * (weight * constant(2.0) / (near * range)).sqrt();
        (SVector::from([y, T::zero(), current]), resistance * current)
    }

    /// The energy ½·m·ẏ² − m·g·y + ½·L(y)·i² in J; Ė = v·i − R·i² − c·ẏ².
    pub fn energy(&self, x: &SVector<T, 3>) -> T {
        let square = |x: T| x * x * constant(0.5);
        let field = self.inductance(x[0]) * square(x[2]);
        self.mass * (square(x[1]) - self.gravity * x[0]) + field
    }

    /// L(y) in H.
    #[inline]
    fn inductance<S: Smooth<T>>(&self, y: S) -> S {
        let Electromagnet { far, near, range, .. } = self.magnet;
        (y + range).recip() * (near * range) + far
    }
}

impl<T: Scalar> SmoothPlant<3, 1> for MagneticLevitation<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [y, y_dot, current]: [S; 3]) -> [S; 3] {
        let Electromagnet { near, range, resistance, .. } = self.magnet;
        // −∂L/∂y·i.
        let linkage = current * (near * range) / (y + range).powi(2);
        let pull = linkage * current * constant::<T>(0.5);
        let fall = -(pull + y_dot * self.friction) / self.mass + self.gravity;
        let voltage = linkage * y_dot - current * resistance;
        [y_dot, fall, voltage / self.inductance(y)]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, [y, ..]: [S; 3]) -> [[S; 3]; 1] {
        [[S::zero(), S::zero(), self.inductance(y).recip()]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [y, ..]: [S; 3]) -> [S; 1] {
        [y]
    }
}

control_affine!(MagneticLevitation, 3, 1);

checked! {
    [T: Scalar] MagneticLevitation<T>, [T]
    { mass: T, friction: T, gravity: T, magnet: Electromagnet<T> } =>
    Self::new(mass, friction, gravity, magnet)
}
