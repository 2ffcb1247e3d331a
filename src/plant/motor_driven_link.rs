use nalgebra::SVector;

use super::{SmoothPlant, smooth::control_affine};
use crate::{
    Error, Scalar,
    differentiation::Smooth,
    elementary::{cos, sin},
    error::{not_negative, positive},
    scalar::constant,
};

/// A link on the shaft of a direct-current motor, driven by its voltage: I·q̈ + d·q̇ + w·sin q = K·i, L·i̇ = v − R·i − K·q̇.
///
/// State (q, q̇, i) in rad, rad/s and A, q = 0 hanging down; input v, the voltage of the armature in V; output q. The voltage acts on q⃛
/// through the current: relative degree 3 everywhere, with b = K/(I·L).
///
/// # References
/// D. M. Dawson, J. Hu, T. C. Burg, *Nonlinear Control of Electric Machinery*, 2 (brushed DC motor with a position-dependent load).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotorDrivenLink<T> {
    inertia: T,
    friction: T,
    weight: T,
    motor: DcMotor<T>,
}

/// The motor of [`MotorDrivenLink`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct DcMotor<T> {
    /// K > 0 in N·m/A, at the same time the back-emf in V·s/rad.
    pub torque: T,
    /// L > 0 in H.
    pub inductance: T,
    /// R > 0 in Ω.
    pub resistance: T,
}

impl<T: Scalar> MotorDrivenLink<T> {
    /// A link of moment of `inertia` I > 0 in kg·m² (with the rotor), viscous `friction` d ≥ 0 in N·m·s/rad and `weight` w = m·g·l ≥ 0 in N·m,
    /// held out horizontally, on `motor`.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(inertia: T, friction: T, weight: T, motor: DcMotor<T>) -> Result<Self, Error> {
        positive("torque constant", motor.torque)?;
        positive("inductance", motor.inductance)?;
        positive("resistance", motor.resistance)?;
        Ok(Self {
            inertia: positive("inertia", inertia)?,
            friction: not_negative("friction", friction)?,
            weight: not_negative("weight", weight)?,
            motor,
        })
    }

    /// The state at rest with the link at `q`, and the voltage for it.
    pub fn equilibrium(&self, q: T) -> (SVector<T, 3>, T) {
        let current = self.weight * sin(q) / self.motor.torque;
        (SVector::from([q, T::zero(), current]), self.motor.resistance * current)
    }

    /// The energy ½·I·q̇² + w·(1 − cos q) + ½·L·i² in J; Ė = v·i − R·i² − d·q̇².
    pub fn energy(&self, x: &SVector<T, 3>) -> T {
        let square = |x: T| x * x * constant(0.5);
        let mechanical = self.inertia * square(x[1]) + self.weight * (T::one() - cos(x[0]));
        mechanical + self.motor.inductance * square(x[2])
    }
}

impl<T: Scalar> SmoothPlant<3, 1> for MotorDrivenLink<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [q, q_dot, current]: [S; 3]) -> [S; 3] {
        let DcMotor { torque, inductance, resistance } = self.motor;
        let resistance_of_link = q_dot * self.friction + q.sin() * self.weight;
        let voltage = -(current * resistance + q_dot * torque);
        [q_dot, (current * torque - resistance_of_link) / self.inertia, voltage / inductance]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 3]) -> [[S; 3]; 1] {
        [[S::zero(), S::zero(), S::from(self.motor.inductance.recip())]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [q, ..]: [S; 3]) -> [S; 1] {
        [q]
    }
}

control_affine!(MotorDrivenLink, 3, 1);

checked! {
    [T: Scalar] MotorDrivenLink<T>, [T]
    { inertia: T, friction: T, weight: T, motor: DcMotor<T> } =>
    Self::new(inertia, friction, weight, motor)
}
