use nalgebra::SVector;

use crate::{
    Error, Scalar,
    differentiation::Smooth,
    error::positive,
    plant::{SmoothPlant, smooth::control_affine},
    scalar::constant,
};

/// The attitude of a quadrotor, or of any rigid body under torques: φ̇ = p + (q·sin φ + r·cos φ)·tan θ, θ̇ = q·cos φ − r·sin φ,
/// ψ̇ = (q·sin φ + r·cos φ)/cos θ, and Euler's J·ω̇ = −ω × J·ω + τ.
///
/// State (φ, θ, ψ, p, q, r) in rad and rad/s: roll, pitch and yaw of the rotation R = R_z(ψ)·R_y(θ)·R_x(φ) from the body to a world with z up,
/// and the angular velocity ω in the body's axes, x ahead, y left, z up. Input τ, the torques about these axes in N·m; output (φ, θ, ψ).
/// Each angle has relative degree 2: three chains, no zero dynamics. det B = 1/(cos θ·det J), so the angles have no rates that follow ω at
/// θ = ±π/2, the lock of the gimbal.
///
/// Assumes body axes that are principal axes of inertia, and rotors that carry no angular momentum of their own.
///
/// # References
/// R. M. Murray, Z. Li, S. S. Sastry, *A Mathematical Introduction to Robotic Manipulation*, 2.2 (Euler angles) and 4.2 (Newton–Euler
/// equations).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuadrotorAttitude<T> {
    inertia: [T; 3],
}

impl<T: Scalar> QuadrotorAttitude<T> {
    /// A body with the principal moments of `inertia` J_x, J_y, J_z > 0 in kg·m².
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(inertia: [T; 3]) -> Result<Self, Error> {
        Ok(Self {
            inertia: [
                positive("inertia about x", inertia[0])?,
                positive("inertia about y", inertia[1])?,
                positive("inertia about z", inertia[2])?,
            ],
        })
    }

    /// The energy ½·ωᵀ·J·ω of the rotation in J; it changes by the power of the torques, Ė = τᵀ·ω.
    pub fn energy(&self, x: &SVector<T, 6>) -> T {
        let [_, _, _, p, q, r] = (*x).into();
        let [jx, jy, jz] = self.inertia;
        (jx * p * p + jy * q * q + jz * r * r) * constant(0.5)
    }

    /// The rates of (φ, θ, ψ) at the angular velocity (p, q, r).
    #[inline]
    pub(super) fn angle_rates<S: Smooth<T>>([phi, theta, _]: [S; 3], [p, q, r]: [S; 3]) -> [S; 3] {
        let (sin, cos) = phi.sin_cos();
        let (sin_theta, cos_theta) = theta.sin_cos();
        let yaw = (q * sin + r * cos) / cos_theta;
        [p + yaw * sin_theta, q * cos - r * sin, yaw]
    }

    /// ω̇ without torques.
    #[inline]
    pub(super) fn gyration<S: Smooth<T>>(&self, [p, q, r]: [S; 3]) -> [S; 3] {
        let [jx, jy, jz] = self.inertia;
        [q * r * ((jy - jz) / jx), r * p * ((jz - jx) / jy), p * q * ((jx - jy) / jz)]
    }

    /// 1/J.
    #[inline]
    pub(super) fn mobility(&self) -> [T; 3] {
        self.inertia.map(T::recip)
    }
}

impl<T: Scalar> SmoothPlant<6, 3> for QuadrotorAttitude<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [phi, theta, psi, p, q, r]: [S; 6]) -> [S; 6] {
        let [roll, pitch, yaw] = Self::angle_rates([phi, theta, psi], [p, q, r]);
        let [p, q, r] = self.gyration([p, q, r]);
        [roll, pitch, yaw, p, q, r]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 6]) -> [[S; 6]; 3] {
        let zero = S::zero();
        let [x, y, z] = self.mobility().map(S::from);
        [
            [zero, zero, zero, x, zero, zero],
            [zero, zero, zero, zero, y, zero],
            [zero, zero, zero, zero, zero, z],
        ]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [phi, theta, psi, ..]: [S; 6]) -> [S; 3] {
        [phi, theta, psi]
    }
}

control_affine!(QuadrotorAttitude, 6, 3);

checked! { [T: Scalar] QuadrotorAttitude<T>, [T] { inertia: [T; 3] } => Self::new(inertia) }
