//! Linear-quadratic regulators against closed forms, spectral factorization, and cost matrices from linear equations.

mod closed_forms;
mod failures;
mod lyapunov;
mod optimality;
mod sampled;

use brunovsky::{Scalar, controller::lqr::Weights};
use nalgebra::{DMatrix, DVector, SMatrix};
use proptest::prelude::*;

use crate::support::num;

/// The chain xᵢ' = xᵢ₊₁, ẋ_n = u.
fn chain<T: Scalar, const N: usize>() -> (SMatrix<T, N, N>, SMatrix<T, N, 1>) {
    let a = SMatrix::from_fn(|i, j| num(f64::from(u8::from(i + 1 == j))));
    (a, SMatrix::from_fn(|i, _| num(f64::from(u8::from(i + 1 == N)))))
}

/// A plant with any weights that are allowed: (Q N; Nᵀ R) = M·Mᵀ + something on the diagonal.
#[derive(Debug, Clone, Copy)]
struct Case<const NX: usize, const NU: usize> {
    a: SMatrix<f64, NX, NX>,
    b: SMatrix<f64, NX, NU>,
    weights: Weights<f64, NX, NU>,
}

/// Plants of which almost all are stabilizable, with entries within ±2.
fn any_case<const NX: usize, const NU: usize>() -> impl Strategy<Value = Case<NX, NU>> {
    let entries = NX * NX + NX * NU + (NX + NU) * (NX + NU);
    prop::collection::vec(-2.0..2.0_f64, entries).prop_map(|entries| {
        let mut entries = entries.into_iter();
        let a = SMatrix::from_fn(|_, _| entries.next().unwrap());
        let b = SMatrix::from_fn(|_, _| entries.next().unwrap());
        let m = DMatrix::from_fn(NX + NU, NX + NU, |_, _| entries.next().unwrap());
        let whole = &m * m.transpose() + DMatrix::identity(NX + NU, NX + NU) * 0.1;
        let q = SMatrix::from_fn(|i, j| whole[(i, j)]);
        let r = SMatrix::from_fn(|i, j| whole[(NX + i, NX + j)]);
        let n = SMatrix::from_fn(|i, j| whole[(i, NX + j)]);
        Case { a, b, weights: Weights::with_cross(q, r, n).unwrap() }
    })
}

impl<const NX: usize, const NU: usize> Case<NX, NU> {
    /// Q − NK − KᵀNᵀ + KᵀRK: what x costs a second under u = −K·x.
    fn rate(&self, k: &SMatrix<f64, NU, NX>) -> SMatrix<f64, NX, NX> {
        let cross = self.weights.n() * k;
        self.weights.q() - cross - cross.transpose() + k.transpose() * self.weights.r() * k
    }
}

/// P of AᵀP + PA + Q = 0, as N² linear equations: (I ⊗ Aᵀ + Aᵀ ⊗ I)·vec P = −vec Q.
fn by_linear_equations<const N: usize>(
    a: &SMatrix<f64, N, N>,
    q: &SMatrix<f64, N, N>,
) -> SMatrix<f64, N, N> {
    let (a, one) = (DMatrix::from_fn(N, N, |i, j| a[(j, i)]), DMatrix::identity(N, N));
    let equations = one.kronecker(&a) + a.kronecker(&one);
    let p = equations.lu().solve(&DVector::from_column_slice((-q).as_slice())).unwrap();
    SMatrix::from_column_slice(p.as_slice())
}

/// P of AᵀPA − P + Q = 0, as N² linear equations: (Aᵀ ⊗ Aᵀ − I)·vec P = −vec Q.
fn by_linear_equations_in_steps<const N: usize>(
    a: &SMatrix<f64, N, N>,
    q: &SMatrix<f64, N, N>,
) -> SMatrix<f64, N, N> {
    let a = DMatrix::from_fn(N, N, |i, j| a[(j, i)]);
    let equations = a.kronecker(&a) - DMatrix::identity(N * N, N * N);
    let p = equations.lu().solve(&DVector::from_column_slice((-q).as_slice())).unwrap();
    SMatrix::from_column_slice(p.as_slice())
}

fn eigenvalues<const N: usize>(m: &SMatrix<f64, N, N>) -> Vec<nalgebra::Complex<f64>> {
    let m = DMatrix::from_column_slice(N, N, m.as_slice());
    m.complex_eigenvalues().iter().copied().collect()
}
