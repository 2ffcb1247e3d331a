use nalgebra::SVector;

use super::Plant;
use crate::{
    Error, Scalar,
    elementary::sin_cos,
    error::{finite, positive},
};

/// What the ground leaves of the motion of a robot's tracks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traction<T> {
    /// μ ∈ (0, 1]: speed over ground per speed of the tracks (1 − longitudinal slip).
    pub longitudinal: T,
    /// κ ∈ (0, 1]: yaw rate of the body per yaw rate of the tracks (1 − yaw slip).
    pub yaw: T,
    /// x_ICR in m: how far ahead of the robot's centre the centre of rotation lies. In a turn the centre skids sideways with
    /// v_y = −x_ICR·θ̇.
    pub side: T,
}

/// A tracked robot on slipping ground, commanded by speed and yaw rate:
///
/// v̇_t = (v_c − v_t)/τ, ω̇_t = (ω_c − ω_t)/τ (drives), θ̇ = κ·ω_t, v = μ·v_t, v_y = −x_ICR·θ̇,
/// ṗ = v·(cos θ, sin θ) + v_y·(−sin θ, cos θ).
///
/// State (p_x, p_y, θ, v_t, ω_t) in m, m, rad, m/s, rad/s, with v_t and ω_t what the tracks do; input (v_c, ω_c) in m/s and rad/s. The
/// [`Traction`] is a function of the position, so that the ground can vary. With κ = μ = 1, x_ICR = 0 and fast drives it is the
/// unicycle.
///
/// # References
/// J. L. Martínez, A. Mandow, J. Morales, S. Pedraza, A. García-Cerezo, "Approximating kinematics for tracked mobile robots",
/// International Journal of Robotics Research 24(10), 2005 (slip as displaced centres of rotation).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackedRobot<T, F> {
    lag: T,
    ground: F,
}

impl<T: Scalar, F: Fn(T, T) -> Traction<T>> TrackedRobot<T, F> {
    /// A robot whose drives have the time constant `lag` = τ > 0 in s, on a `ground` with traction at (p_x, p_y).
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for the lag.
    pub fn new(lag: T, ground: F) -> Result<Self, Error> {
        Ok(Self { lag: positive("lag", lag)?, ground })
    }

    /// The velocity over ground at the state `x`, as (forward v, sideways v_y) in m/s, and the yaw rate θ̇ in rad/s.
    pub fn over_ground(&self, x: &SVector<T, 5>) -> [T; 3] {
        let traction = (self.ground)(x[0], x[1]);
        let yaw_rate = traction.yaw * x[4];
        [traction.longitudinal * x[3], -traction.side * yaw_rate, yaw_rate]
    }
}

impl<T: Scalar> Traction<T> {
    /// Checks that μ and κ are positive, and everything finite.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`], naming `mu`, `kappa` or `x_icr`.
    pub fn new(longitudinal: T, yaw: T, side: T) -> Result<Self, Error> {
        Ok(Self {
            longitudinal: positive("mu", longitudinal)?,
            yaw: positive("kappa", yaw)?,
            side: finite("x_icr", side)?,
        })
    }
}

impl<T: Scalar, F: Fn(T, T) -> Traction<T>> Plant<5, 2> for TrackedRobot<T, F> {
    type Scalar = T;

    fn derivative(&self, _t: T, x: &SVector<T, 5>, u: &SVector<T, 2>) -> SVector<T, 5> {
        let [forward, sideways, yaw_rate] = self.over_ground(x);
        let (sin, cos) = sin_cos(x[2]);
        SVector::from([
            forward * cos - sideways * sin,
            forward * sin + sideways * cos,
            yaw_rate,
            (u[0] - x[3]) / self.lag,
            (u[1] - x[4]) / self.lag,
        ])
    }
}

checked! {
    [T: Scalar] Traction<T>, [T] { longitudinal: T, yaw: T, side: T } =>
    Self::new(longitudinal, yaw, side)
}
