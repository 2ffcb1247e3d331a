mod attitude;

pub use attitude::QuadrotorAttitude;

use nalgebra::SVector;

use super::{SmoothPlant, smooth::control_affine};
use crate::{
    Error, Scalar,
    differentiation::Smooth,
    error::{not_negative, positive},
};

/// A quadrotor in space, whose thrust F goes through two integrators (dynamic extension): m·p̈ = F·R·e_z − m·g·e_z, F̈ = ξ, and the
/// [attitude](QuadrotorAttitude).
///
/// State (p_x, p_y, p_z, v_x, v_y, v_z, φ, θ, ψ, p, q, r, F, Ḟ) in m, m/s, rad, rad/s, N and N/s, in a world with z up, with the thrust along the
/// body's z axis; input (ξ, τ_x, τ_y, τ_z) in N/s² and N·m; output (p_x, p_y, p_z, ψ), which is flat.
///
/// The thrust itself acts on p̈ and cannot push sideways; behind two integrators all four inputs act on p⁗, where ψ̈ already sees the torques. The
/// relative degrees (4, 4, 4, 2) add up to the order 14, so there are no zero dynamics: [`Linearized::with_degrees`](super::Linearized::with_degrees) and
/// chains of length 4, the last one [`Padded`](crate::controller::Padded). Singular in free fall, F = 0, where the attitude does not matter; at
/// θ = ±π/2, the lock of the gimbal; and at φ = ±π/2, where no torque that leaves the thrust's direction turns ψ.
///
/// Assumes no drag.
///
/// # References
/// V. Mistler, A. Benallegue, N. K. M'Sirdi, "Exact linearization and noninteracting control of a 4 rotors helicopter via dynamic feedback",
/// IEEE International Workshop on Robot and Human Interactive Communication, 2001.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quadrotor<T> {
    mass: T,
    attitude: QuadrotorAttitude<T>,
    gravity: T,
}

impl<T: Scalar> Quadrotor<T> {
    /// The relative degrees of the outputs.
    pub const DEGREES: [usize; 4] = [4, 4, 4, 2];

    /// A quadrotor of `mass` m > 0 in kg that turns as `attitude` does, under `gravity` g ≥ 0 in m/s².
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(mass: T, attitude: QuadrotorAttitude<T>, gravity: T) -> Result<Self, Error> {
        Ok(Self {
            mass: positive("mass", mass)?,
            attitude,
            gravity: not_negative("gravity", gravity)?,
        })
    }

    /// The state in which it hovers at `position` with the yaw angle `psi`: F = m·g.
    pub fn hover(&self, position: [T; 3], psi: T) -> SVector<T, 14> {
        let mut x = SVector::zeros();
        (x[0], x[1], x[2]) = position.into();
        x[8] = psi;
        x[12] = self.mass * self.gravity;
        x
    }
}

impl<T: Scalar> SmoothPlant<14, 4> for Quadrotor<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, x: [S; 14]) -> [S; 14] {
        let [_, _, _, vx, vy, vz, phi, theta, psi, p, q, r, thrust, thrust_dot] = x;
        let (sin_phi, cos_phi) = phi.sin_cos();
        let (sin_theta, cos_theta) = theta.sin_cos();
        let (sin_psi, cos_psi) = psi.sin_cos();
        let lift = thrust / self.mass;
        let forward = lift * cos_phi * sin_theta;
        let aside = lift * sin_phi;
        let ax = forward * cos_psi + aside * sin_psi;
        let ay = forward * sin_psi - aside * cos_psi;
        let az = lift * cos_phi * cos_theta - self.gravity;
        let [roll, pitch, yaw] = QuadrotorAttitude::<T>::angle_rates([phi, theta, psi], [p, q, r]);
        let [dp, dq, dr] = self.attitude.gyration([p, q, r]);
        [vx, vy, vz, ax, ay, az, roll, pitch, yaw, dp, dq, dr, thrust_dot, S::zero()]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 14]) -> [[S; 14]; 4] {
        let [x, y, z] = self.attitude.mobility();
        let unit = |place: usize, size: T| {
            core::array::from_fn(|i| if i == place { S::from(size) } else { S::zero() })
        };
        [unit(13, T::one()), unit(9, x), unit(10, y), unit(11, z)]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, x: [S; 14]) -> [S; 4] {
        let [px, py, pz, _, _, _, _, _, psi, ..] = x;
        [px, py, pz, psi]
    }
}

control_affine!(Quadrotor, 14, 4);

checked! {
    [T: Scalar] Quadrotor<T>, [T] { mass: T, attitude: QuadrotorAttitude<T>, gravity: T } =>
    Self::new(mass, attitude, gravity)
}
