use nalgebra::SVector;

use crate::{Error, Scalar, error::finite_vector};

/// The solution within a step: x(t + θ·h) = x + θ·(d₁ + (1 − θ)·(d₂ + θ·(d₃ + (1 − θ)·d₄))), 0 ≤ θ ≤ 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dense<T, const N: usize> {
    pub(crate) t: T,
    pub(crate) h: T,
    pub(crate) x: SVector<T, N>,
    pub(crate) d: [SVector<T, N>; 4],
}

impl<T: Scalar, const N: usize> Dense<T, N> {
    /// # Errors
    /// [`Error::NonFiniteEntry`] for a state beyond the range of `T`, between two large ones.
    pub(crate) fn at(&self, t: T) -> Result<SVector<T, N>, Error> {
        let theta = (t - self.t) / self.h;
        let rest = T::one() - theta;
        let [d1, d2, d3, d4] = &self.d;
        let x = self.x + (d1 + (d2 + (d3 + d4 * rest) * theta) * rest) * theta;
        finite_vector("x(t)", &x)?;
        Ok(x)
    }
}
