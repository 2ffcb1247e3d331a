use nalgebra::{SMatrix, SVector};

use crate::Scalar;

/// P·A = L·U with rows exchanged for the largest pivot; L below the diagonal, U on and above it.
pub(super) struct Lu<T, const N: usize> {
    factors: SMatrix<T, N, N>,
    /// The row that step k exchanged with row k.
    exchanged: [usize; N],
}

impl<T: Scalar, const N: usize> Lu<T, N> {
    /// The factors of `a`; `None` if a pivot is 0 or not finite.
    pub(super) fn new(mut a: SMatrix<T, N, N>) -> Option<Self> {
        let mut exchanged = [0; N];
        for k in 0..N {
            let mut pivot = k;
            for i in k + 1..N {
                if a[(i, k)].abs() > a[(pivot, k)].abs() {
                    pivot = i;
                }
            }
            exchanged[k] = pivot;
            a.swap_rows(k, pivot);
            let diagonal = a[(k, k)];
            if diagonal.is_zero() || !diagonal.is_finite() {
                return None;
            }
            for i in k + 1..N {
                let factor = a[(i, k)] / diagonal;
                a[(i, k)] = factor;
                for j in k + 1..N {
                    let above = a[(k, j)];
                    a[(i, j)] -= factor * above;
                }
            }
        }
        Some(Self { factors: a, exchanged })
    }

    /// A⁻¹·b.
    pub(super) fn solve(&self, mut b: SVector<T, N>) -> SVector<T, N> {
        for (k, &pivot) in self.exchanged.iter().enumerate() {
            b.swap_rows(k, pivot);
        }
        for i in 0..N {
            for j in 0..i {
                let known = b[j];
                b[i] -= self.factors[(i, j)] * known;
            }
        }
        for i in (0..N).rev() {
            for j in i + 1..N {
                let known = b[j];
                b[i] -= self.factors[(i, j)] * known;
            }
            b[i] /= self.factors[(i, i)];
        }
        b
    }
}
