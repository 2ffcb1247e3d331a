use nalgebra::SVector;

use super::Integrator;
use crate::{Scalar, scalar::constant};

/// The classical Runge–Kutta method of order four:
///
/// k₁ = f(t, x), k₂ = f(t + h/2, x + h/2·k₁), k₃ = f(t + h/2, x + h/2·k₂), k₄ = f(t + h, x + h·k₃),
/// x⁺ = x + h/6·(k₁ + 2k₂ + 2k₃ + k₄).
///
/// # References
/// W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", 1901.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rk4;

impl Integrator for Rk4 {
    const ORDER: i32 = 4;

    fn step<T: Scalar, const N: usize>(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        h: T,
    ) -> SVector<T, N> {
        let half = h * constant(0.5);
        let k1 = f(t, x);
        let k2 = f(t + half, &(x + k1 * half));
        let k3 = f(t + half, &(x + k2 * half));
        let k4 = f(t + h, &(x + k3 * h));
        let two = constant::<T>(2.0);
        x + (k1 + (k2 + k3) * two + k4) * (h / constant(6.0))
    }
}
