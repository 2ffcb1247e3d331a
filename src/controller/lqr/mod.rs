//! Linear-quadratic regulators: the gains that minimize a quadratic cost, from an algebraic Riccati equation.
//!
//! | function | plant | cost | equation |
//! |---|---|---|---|
//! | [`continuous`] | ẋ = A·x + B·u | ∫ xᵀQx + 2·xᵀNu + uᵀRu dt | AᵀP + PA − (PB + N)·R⁻¹·(BᵀP + Nᵀ) + Q = 0 |
//! | [`discrete`] | x⁺ = A·x + B·u | Σ xᵀQx + 2·xᵀNu + uᵀRu | AᵀPA − P − (AᵀPB + N)·(R + BᵀPB)⁻¹·(BᵀPA + Nᵀ) + Q = 0 |
//! | [`sampled`] | ẋ = A·x + B·u, u held over h | the integral, under the held input | the discrete one of [`held`] |
//!
//! The minimizing input is u = −K·x, the minimum x(0)ᵀ·P·x(0). [`StateFeedback`](super::StateFeedback) is the controller for plants that are
//! linearized at an operating point, and [`Gains::lqr`](super::Gains::lqr) gives feedback linearization and CLELC gains of this kind.
//!
//! # How it is solved
//! By structure-preserving doubling: after k steps the iterates describe the optimal control over 2^k periods, and converge quadratically to
//! that over all time. The continuous equation becomes a discrete one by a Cayley transform, after the state is scaled by powers of 2. All
//! matrices are on the stack and of the plant's sizes. What comes out is put into the equation, and refused if it does not fulfil it.
//!
//! # References
//! E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, "A structure-preserving doubling algorithm for continuous-time algebraic Riccati equations", *Linear
//! Algebra and its Applications* 396, 2005; with C.-S. Wang, "Structure-preserving algorithms for periodic discrete-time algebraic Riccati
//! equations", *International Journal of Control* 77(8), 2004; C. F. Van Loan, "Computing integrals involving the matrix exponential", *IEEE
//! Transactions on Automatic Control* 23(3), 1978 (the sampled cost).

mod balanced;
mod continuous;
mod discrete;
mod doubling;
mod gains;
mod hold;
mod lyapunov;
mod weights;

pub use continuous::continuous;
pub use discrete::{discrete, sampled};
pub use hold::{Held, held};
pub use lyapunov::lyapunov;
pub use weights::Weights;

use nalgebra::{SMatrix, SVector};

use crate::{
    Error, Scalar,
    error::value,
    scalar::{constant, epsilon},
};

/// A linear-quadratic regulator: the gain, the value function, and how exactly it solves its equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regulator<T, const NX: usize, const NU: usize> {
    /// The gain K of u = −K·x.
    pub gain: SMatrix<T, NU, NX>,
    /// P, symmetric: the least cost from x on is xᵀ·P·x.
    pub value: SMatrix<T, NX, NX>,
    /// The largest entry of what P leaves of its equation, as a share of the sizes of the terms.
    pub residual: T,
}

impl<T: Scalar, const NX: usize, const NU: usize> Regulator<T, NX, NU> {
    /// xᵀ·P·x, the least cost from the state `x` on.
    pub fn cost(&self, x: &SVector<T, NX>) -> T {
        x.dot(&(self.value * x))
    }
}

/// Steps of Newton's method after the doubling; the second is for what the first leaves of digits that were lost before.
const REFINEMENTS: u32 = 2;

/// ½·(M + Mᵀ).
fn symmetric<T: Scalar, const N: usize>(m: SMatrix<T, N, N>) -> SMatrix<T, N, N> {
    let half = constant::<T>(0.5);
    SMatrix::from_fn(|i, j| (m[(i, j)] + m[(j, i)]) * half)
}

fn sum<T: Scalar, const N: usize>(terms: &[SMatrix<T, N, N>]) -> SMatrix<T, N, N> {
    terms.iter().fold(SMatrix::zeros(), |sum, term| sum + term)
}

/// The largest absolute value; not finite if an entry is not.
fn size<T: Scalar, const M: usize, const N: usize>(m: &SMatrix<T, M, N>) -> T {
    let larger = |x: T, y: T| if x > y || !x.is_finite() { x } else { y };
    m.iter().fold(T::zero(), |largest, x| larger(largest, x.abs()))
}

/// What the `terms` of an equation leave as a share of their sizes, if that is small: half of the digits, at least.
fn checked<T: Scalar, const N: usize>(
    name: &'static str,
    terms: &[SMatrix<T, N, N>],
) -> Result<T, Error> {
    let whole = terms.iter().fold(T::zero(), |whole, term| whole + size(term));
    let residual = if whole.is_zero() { whole } else { size(&sum(terms)) / whole };
    let limit = epsilon::<T>().sqrt();
    // A NaN is not within it either.
    if residual <= limit {
        Ok(residual)
    } else {
        Err(Error::Unsolved { name, residual: value(residual), limit: value(limit) })
    }
}
