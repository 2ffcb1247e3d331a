use nalgebra::{SMatrix, SVector};

use super::{size, symmetric};
use crate::{
    Error, Scalar,
    error::{finite_slice, value},
    inverse::inverse,
    scalar::{constant, epsilon},
};

/// The weights of a quadratic cost xᵀQx + 2·xᵀNu + uᵀRu.
///
/// R is positive definite, and the whole positive semidefinite: Q − N·R⁻¹·Nᵀ ≥ 0. By Bryson's rule the diagonals are 1/(largest xᵢ that is
/// acceptable)² and 1/(largest uⱼ)².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights<T, const NX: usize, const NU: usize> {
    q: SMatrix<T, NX, NX>,
    r: SMatrix<T, NU, NU>,
    n: SMatrix<T, NX, NU>,
    /// R⁻¹.
    inverse: SMatrix<T, NU, NU>,
}

impl<T: Scalar, const NX: usize, const NU: usize> Weights<T, NX, NU> {
    /// Weights Q ≥ 0 of the state and R > 0 of the input.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`]; [`Error::Asymmetric`] if Q or R differs from its transpose by more than rounding; [`Error::NotPositive`] for
    /// a pivot of R, [`Error::Negative`] for one of Q, that shows a direction of no or negative weight; [`Error::IllConditioned`] for an R
    /// that has no inverse in the range of `T`.
    pub fn new(q: SMatrix<T, NX, NX>, r: SMatrix<T, NU, NU>) -> Result<Self, Error> {
        Self::with_cross(q, r, SMatrix::zeros())
    }

    /// The weights `q` = (q₁, …) ≥ 0 and `r` = (r₁, …) > 0 of the squares of each state and each input.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn diagonal(
        q: impl Into<SVector<T, NX>>,
        r: impl Into<SVector<T, NU>>,
    ) -> Result<Self, Error> {
        Self::new(SMatrix::from_diagonal(&q.into()), SMatrix::from_diagonal(&r.into()))
    }

    /// The same with a weight N of products of state and input, as sampling brings it.
    ///
    /// # Errors
    /// As [`new`](Self::new), with Q − N·R⁻¹·Nᵀ in place of Q.
    pub fn with_cross(
        q: SMatrix<T, NX, NX>,
        r: SMatrix<T, NU, NU>,
        n: SMatrix<T, NX, NU>,
    ) -> Result<Self, Error> {
        let weights = Self::unjudged(mirrored("Q", q)?, mirrored("R", r)?, n)?;
        // A pivot of 0 comes out of differences of entries of Q.
        let pivot = least_pivot(weights.reduced_q(), size(&q) * rounding::<T>(NX));
        if pivot < T::zero() {
            return Err(Error::Negative { name: "pivot of Q", value: value(pivot) });
        }
        Ok(weights)
    }

    /// The same for symmetric Q and R, without a look at Q − N·R⁻¹·Nᵀ: where it is semidefinite by itself, up to rounding.
    pub(super) fn unjudged(
        q: SMatrix<T, NX, NX>,
        r: SMatrix<T, NU, NU>,
        n: SMatrix<T, NX, NU>,
    ) -> Result<Self, Error> {
        finite_slice("Q", q.as_slice())?;
        finite_slice("R", r.as_slice())?;
        finite_slice("N", n.as_slice())?;
        let pivot = least_pivot(r, T::zero());
        if pivot <= T::zero() {
            return Err(Error::NotPositive { name: "pivot of R", value: value(pivot) });
        }
        let inverse = inverse(&r).filter(|inverse| size(inverse).is_finite());
        let singular =
            Error::IllConditioned { name: "R", condition: f64::INFINITY, limit: f64::MAX };
        let weights = Self { q, r, n, inverse: symmetric(inverse.ok_or(singular)?) };
        finite_slice("Q - N*R^-1*N^T", weights.reduced_q().as_slice())?;
        Ok(weights)
    }

    /// Q.
    pub fn q(&self) -> &SMatrix<T, NX, NX> {
        &self.q
    }

    /// R.
    pub fn r(&self) -> &SMatrix<T, NU, NU> {
        &self.r
    }

    /// N.
    pub fn n(&self) -> &SMatrix<T, NX, NU> {
        &self.n
    }

    /// Q − N·R⁻¹·Nᵀ: what the state costs under the input that is best for the moment.
    pub(super) fn reduced_q(&self) -> SMatrix<T, NX, NX> {
        symmetric(self.q - self.n * self.inverse * self.n.transpose())
    }

    /// A − B·R⁻¹·Nᵀ: the dynamics under that input.
    pub(super) fn reduced_a(
        &self,
        a: &SMatrix<T, NX, NX>,
        b: &SMatrix<T, NX, NU>,
    ) -> SMatrix<T, NX, NX> {
        a - b * self.inverse * self.n.transpose()
    }

    /// G = B·R⁻¹·Bᵀ: what an input can do at unit cost.
    pub(super) fn reach(&self, b: &SMatrix<T, NX, NU>) -> SMatrix<T, NX, NX> {
        symmetric(b * self.inverse * b.transpose())
    }

    /// R⁻¹.
    pub(super) fn inverse(&self) -> &SMatrix<T, NU, NU> {
        &self.inverse
    }
}

/// What a few roundings in each of n sums of n terms amount to, relative to the terms.
fn rounding<T: Scalar>(n: usize) -> T {
    epsilon::<T>() * constant((8 * n) as f64)
}

/// A matrix that is finite and equals its transpose to rounding; the mean of both.
pub(super) fn mirrored<T: Scalar, const N: usize>(
    name: &'static str,
    m: SMatrix<T, N, N>,
) -> Result<SMatrix<T, N, N>, Error> {
    finite_slice(name, m.as_slice())?;
    let tolerance = size(&m) * rounding::<T>(N);
    for row in 0..N {
        for column in 0..row {
            let (below, above) = (m[(row, column)], m[(column, row)]);
            if (below - above).abs() > tolerance {
                let (below, above) = (value(below), value(above));
                return Err(Error::Asymmetric { name, row, column, below, above });
            }
        }
    }
    Ok(symmetric(m))
}

/// The least pivot of symmetric elimination, always with the largest one left: positive for a positive definite matrix and negative for an
/// indefinite one. Where no more than `noise` is left it is 0.
fn least_pivot<T: Scalar, const N: usize>(mut m: SMatrix<T, N, N>, noise: T) -> T {
    let mut least = T::max_value().unwrap_or(T::one());
    for _ in 0..N {
        // Rows that were eliminated are 0, and come after all that is positive.
        let mut largest = 0;
        for i in 1..N {
            if diagonal(&m, i) > diagonal(&m, largest) {
                largest = i;
            }
        }
        let pivot = diagonal(&m, largest);
        if pivot <= noise {
            // No diagonal entry is positive, so any entry that is left belongs to a direction of negative weight.
            let left = size(&m);
            return if left > noise { -left } else { T::zero() };
        }
        least = least.min(pivot);
        let column: SVector<T, N> =
            SVector::from_fn(|i, _| m.get((i, largest)).copied().unwrap_or(T::zero()));
        m = SMatrix::from_fn(|i, j| {
            if i == largest || j == largest {
                T::zero()
            } else {
                m[(i, j)] - column[i] / pivot * column[j]
            }
        });
    }
    least
}

fn diagonal<T: Scalar, const N: usize>(m: &SMatrix<T, N, N>, i: usize) -> T {
    m.get((i, i)).copied().unwrap_or(T::zero())
}
