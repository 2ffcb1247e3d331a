use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use super::{ControlAffine, Decouplable, SmoothPlant};
use crate::{Scalar, differentiation::Smooth, elementary::sin_cos};

/// The unicycle with its speed as a state: ṗ_x = v·cos θ, ṗ_y = v·sin θ, θ̇ = ω, v̇ = ξ (eq_mobilerobotmodel with the dynamic extension).
///
/// State (p_x, p_y, θ, v) in m, m, rad, m/s, θ counter-clockwise from the x axis; input (ξ, ω) in m/s² and rad/s, so that ω > 0 turns
/// left. v < 0 is driving in reverse.
///
/// The position obeys p̈ = B·(ξ, ω) with columns (cos θ, sin θ) and v·(−sin θ, cos θ); det B = v, so it is singular where the robot
/// stands.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Unicycle<T>(PhantomData<T>);

impl<T> Unicycle<T> {
    /// The unicycle; it has no parameters.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T> Default for Unicycle<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Scalar> ControlAffine<4, 2> for Unicycle<T> {
    type Scalar = T;

    fn drift_field(&self, x: &SVector<T, 4>) -> SVector<T, 4> {
        let (sin, cos) = sin_cos(x[2]);
        SVector::from([x[3] * cos, x[3] * sin, T::zero(), T::zero()])
    }

    fn input_fields(&self, _x: &SVector<T, 4>) -> SMatrix<T, 4, 2> {
        let (zero, one) = (T::zero(), T::one());
        SMatrix::from_columns(&[
            SVector::from([zero, zero, zero, one]),
            SVector::from([zero, zero, one, zero]),
        ])
    }
}

impl<T: Scalar> Decouplable<4, 2, 2> for Unicycle<T> {
    type Scalar = T;

    fn chains(&self, x: &SVector<T, 4>) -> [SVector<T, 2>; 2] {
        let (sin, cos) = sin_cos(x[2]);
        [SVector::from([x[0], x[3] * cos]), SVector::from([x[1], x[3] * sin])]
    }

    fn chain_drift(&self, _x: &SVector<T, 4>) -> SVector<T, 2> {
        SVector::zeros()
    }

    fn decoupling_matrix(&self, x: &SVector<T, 4>) -> SMatrix<T, 2, 2> {
        let (sin, cos) = sin_cos(x[2]);
        SMatrix::from_columns(&[
            SVector::from([cos, sin]),
            SVector::from([-x[3] * sin, x[3] * cos]),
        ])
    }

    fn chain_rates(&self, x: &SVector<T, 4>, x_dot: &SVector<T, 4>) -> SVector<T, 2> {
        self.decoupling_matrix(x) * SVector::from([x_dot[3], x_dot[2]])
    }
}

impl<T: Scalar> SmoothPlant<4, 2> for Unicycle<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [_, _, theta, v]: [S; 4]) -> [S; 4] {
        let (sin, cos) = theta.sin_cos();
        [v * cos, v * sin, S::zero(), S::zero()]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 4]) -> [[S; 4]; 2] {
        let (zero, one) = (S::zero(), S::one());
        [[zero, zero, zero, one], [zero, zero, one, zero]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [p_x, p_y, ..]: [S; 4]) -> [S; 2] {
        [p_x, p_y]
    }
}
