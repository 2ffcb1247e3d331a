use nalgebra::{SMatrix, SVector};

use crate::{
    Scalar,
    integrators::{Point, adaptive::norm},
    scalar::{constant, epsilon},
};

/// f about one point: f(t + τ, x + ξ) ≈ f(t, x) + ∂f/∂x·ξ + ∂f/∂t·τ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linearization<T, const N: usize> {
    /// ∂f/∂x: row i is the gradient of fᵢ.
    pub x: SMatrix<T, N, N>,
    /// ∂f/∂t, zero for an f without time.
    pub t: SVector<T, N>,
}

/// Where the linearization of f comes from.
///
/// A closure `|t, x| Linearization { x: …, t: … }` is one, by hand or by automatic differentiation; [`FiniteDifferences`] needs f alone. In a
/// [`Simulation`](crate::simulation::Simulation) a closure does not see the input that is held, so there it fits plants whose ∂F/∂x and ∂F/∂t
/// do not depend on it; differences fit all.
pub trait Jacobian<T: Scalar, const N: usize> {
    /// The linearization about `at`, for steps of about `h` and a tolerance of `weights`.
    fn linearize(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        h: T,
        weights: &SVector<T, N>,
    ) -> Linearization<T, N>;
}

impl<J, T: Scalar, const N: usize> Jacobian<T, N> for J
where
    J: Fn(T, &SVector<T, N>) -> Linearization<T, N>,
{
    fn linearize(
        &self,
        _f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        _h: T,
        _weights: &SVector<T, N>,
    ) -> Linearization<T, N> {
        self(at.t, &at.x)
    }
}

/// One-sided differences: N evaluations of f, and one more for ∂f/∂t.
///
/// Component j moves by √ε·|xⱼ|, or by so much of the tolerance that rounding disturbs h·∂f/∂x by no more than 10⁻³, whichever is more, in
/// the direction of its motion; t moves by √ε·max(|t|, h), no further than h.
///
/// # References
/// A. C. Hindmarsh et al., *User Documentation for CVODE*, 2.1: the increments of its difference quotients.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct FiniteDifferences {
    autonomous: bool,
}

impl FiniteDifferences {
    /// Differences of f in x and t.
    pub fn new() -> Self {
        Self { autonomous: false }
    }

    /// For an f without time: it takes ∂f/∂t = 0 and saves that evaluation. If f does depend on time, the method loses its order.
    pub fn autonomous() -> Self {
        Self { autonomous: true }
    }
}

impl Default for FiniteDifferences {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Scalar, const N: usize> Jacobian<T, N> for FiniteDifferences {
    fn linearize(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        h: T,
        weights: &SVector<T, N>,
    ) -> Linearization<T, N> {
        let Point { t, x, rate } = at;
        let root = epsilon::<T>().sqrt();
        let noise = epsilon::<T>() * h * norm(rate, weights) * constant(1000.0 * N as f64);
        let mut jacobian = SMatrix::<T, N, N>::zeros();
        for (j, mut column) in jacobian.column_iter_mut().enumerate() {
            let mut moved = *x;
            let least = if noise > T::zero() { noise * weights[j] } else { root * weights[j] };
            let size = (root * x[j].abs()).max(least);
            moved[j] += if rate[j] < T::zero() { -size } else { size };
            // What was really added, after rounding.
            column.copy_from(&((f(*t, &moved) - rate) / (moved[j] - x[j])));
        }
        if self.autonomous {
            return Linearization { x: jacobian, t: SVector::zeros() };
        }
        let later = *t + (root * t.abs().max(h)).min(h);
        Linearization { x: jacobian, t: (f(later, x) - rate) / (later - *t) }
    }
}
