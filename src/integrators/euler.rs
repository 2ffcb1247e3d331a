use nalgebra::SVector;

use super::Integrator;
use crate::Scalar;

/// The explicit Euler method: x⁺ = x + h·f(t, x).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Euler;

impl Integrator for Euler {
    const ORDER: i32 = 1;

    fn step<T: Scalar, const N: usize>(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        h: T,
    ) -> SVector<T, N> {
        x + f(t, x) * h
    }
}
