use nalgebra::SVector;

use super::Integrator;
use crate::{Scalar, scalar::constant};

/// Heun's method, the explicit trapezoidal rule: x⁺ = x + h/2·(k₁ + k₂), k₁ = f(t, x), k₂ = f(t + h, x + h·k₁).
///
/// # References
/// E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.1.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Heun;

impl Integrator for Heun {
    const ORDER: i32 = 2;

    fn step<T: Scalar, const N: usize>(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        h: T,
    ) -> SVector<T, N> {
        let k1 = f(t, x);
        let k2 = f(t + h, &(x + k1 * h));
        let half = h * constant(0.5);
        x + (k1 + k2) * half
    }
}
