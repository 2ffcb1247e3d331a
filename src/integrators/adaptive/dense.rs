use nalgebra::SVector;

use crate::Scalar;

/// The solution within a step: x(t + θ·h) = x + θ·(d₁ + (1 − θ)·(d₂ + θ·(d₃ + (1 − θ)·d₄))), 0 ≤ θ ≤ 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dense<T, const N: usize> {
    pub(crate) t: T,
    pub(crate) h: T,
    pub(crate) x: SVector<T, N>,
    pub(crate) d: [SVector<T, N>; 4],
}

impl<T: Scalar, const N: usize> Dense<T, N> {
    pub(crate) fn at(&self, t: T) -> SVector<T, N> {
        let theta = (t - self.t) / self.h;
        let rest = T::one() - theta;
        let [d1, d2, d3, d4] = &self.d;
        self.x + (d1 + (d2 + (d3 + d4 * rest) * theta) * rest) * theta
    }
}
