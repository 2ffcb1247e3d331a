use nalgebra::{SMatrix, SVector};

use super::{Weights, continuous, sampled};
use crate::{Error, Scalar, controller::Gains};

/// The pure chain eᵢ' = eᵢ₊₁, ė_n = −ν, as the gains see it.
fn chain<T: Scalar, const N: usize>() -> (SMatrix<T, N, N>, SMatrix<T, N, 1>) {
    let one_where = |on: bool| if on { T::one() } else { T::zero() };
    let shift = SMatrix::from_fn(|i, j| one_where(i + 1 == j));
    (shift, SMatrix::from_fn(|i, _| one_where(i + 1 == N)))
}

impl<T: Scalar, const N: usize> Gains<T, N> {
    /// The gains that minimize ∫ Σ qᵢ·eᵢ² + r·u_b² dt in the linearized loop, `q` = (q₁, …, q_n) with q₁ > 0 and the others ≥ 0, `r` > 0.
    ///
    /// For N = 2, k = (√(q₁/r), √(q₂/r + 2·√(q₁/r))).
    ///
    /// # Errors
    /// Those of [`Weights::diagonal`] and of [`lqr::continuous`](continuous); [`Error::NotHurwitz`] if rounding took a gain.
    pub fn lqr(q: impl Into<SVector<T, N>>, r: T) -> Result<Self, Error> {
        let (a, b) = chain();
        let weights = Weights::diagonal(q, [r])?;
        Self::new(continuous(&a, &b, &weights)?.gain.transpose())
    }

    /// The same among all u_b that are held over periods of `dt` in seconds, which the loop has to be run at.
    ///
    /// # Errors
    /// Those of [`lqr::sampled`](sampled); [`Error::NotHurwitz`] should they not stabilize the loop without sampling, too.
    pub fn sampled_lqr(q: impl Into<SVector<T, N>>, r: T, dt: T) -> Result<Self, Error> {
        let (a, b) = chain();
        let weights = Weights::diagonal(q, [r])?;
        Self::new(sampled(&a, &b, &weights, dt)?.gain.transpose())
    }
}
