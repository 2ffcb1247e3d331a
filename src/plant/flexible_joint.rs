use nalgebra::SVector;

use super::{SmoothPlant, smooth::control_affine};
use crate::{
    Error, Scalar,
    differentiation::Smooth,
    elementary::{cos, sin},
    error::{not_negative, positive},
    scalar::constant,
};

/// A link driven through a spring, as by a harmonic drive: I·q̈ + w·sin q + k·(q − θ) = 0, J·θ̈ − k·(q − θ) = τ.
///
/// State (q, q̇, θ, θ̇) in rad and rad/s, with q the angle of the link, 0 hanging down, and θ that of the motor behind the gear; input τ, the
/// torque of the motor in N·m; output q. The torque acts on q⁗: relative degree 4 everywhere, with b = k/(I·J).
///
/// Assumes a motor that turns about an axis of symmetry, and a linear spring without damping. (A damped one passes the torque on to q⃛.)
///
/// # References
/// M. W. Spong, "Modeling and control of elastic joint robots", Journal of Dynamic Systems, Measurement, and Control 109(4), 1987.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlexibleJoint<T> {
    link: T,
    motor: T,
    stiffness: T,
    weight: T,
}

impl<T: Scalar> FlexibleJoint<T> {
    /// A `link` and a `motor` of moments of inertia I, J > 0 in kg·m², a spring of `stiffness` k > 0 in N·m/rad, and the `weight` w = m·g·l ≥ 0 of
    /// the link in N·m, held out horizontally.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(link: T, motor: T, stiffness: T, weight: T) -> Result<Self, Error> {
        Ok(Self {
            link: positive("link", link)?,
            motor: positive("motor", motor)?,
            stiffness: positive("stiffness", stiffness)?,
            weight: not_negative("weight", weight)?,
        })
    }

    /// The state at rest with the link at `q`, and the torque w·sin q that holds it there.
    pub fn equilibrium(&self, q: T) -> (SVector<T, 4>, T) {
        let torque = self.weight * sin(q);
        (SVector::from([q, T::zero(), q + torque / self.stiffness, T::zero()]), torque)
    }

    /// The energy ½·I·q̇² + ½·J·θ̇² + ½·k·(q − θ)² + w·(1 − cos q) in J; it changes by the power of the motor, Ė = τ·θ̇.
    pub fn energy(&self, x: &SVector<T, 4>) -> T {
        let square = |x: T| x * x * constant(0.5);
        let kinetic = self.link * square(x[1]) + self.motor * square(x[3]);
        kinetic + self.stiffness * square(x[0] - x[2]) + self.weight * (T::one() - cos(x[0]))
    }
}

impl<T: Scalar> SmoothPlant<4, 1> for FlexibleJoint<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [q, q_dot, theta, theta_dot]: [S; 4]) -> [S; 4] {
        let spring = (q - theta) * self.stiffness;
        let link = -(q.sin() * self.weight + spring) / self.link;
        [q_dot, link, theta_dot, spring / self.motor]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 4]) -> [[S; 4]; 1] {
        [[S::zero(), S::zero(), S::zero(), S::from(self.motor.recip())]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [q, ..]: [S; 4]) -> [S; 1] {
        [q]
    }
}

control_affine!(FlexibleJoint, 4, 1);

checked! {
    [T: Scalar] FlexibleJoint<T>, [T] { link: T, motor: T, stiffness: T, weight: T } =>
    Self::new(link, motor, stiffness, weight)
}
