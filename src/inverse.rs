use core::mem::swap;

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

/// M⁻¹; `None` where a pivot is 0 or not finite.
///
/// Up to four rows nalgebra has closed forms. For more it eliminates, with checks of indices that a compiler cannot prove away: they never fail, but
/// leave a path to a panic in the program. Here a pivot is found without an index.
pub(crate) fn inverse<T: Scalar, const N: usize>(
    matrix: &SMatrix<T, N, N>,
) -> Option<SMatrix<T, N, N>> {
    if N < 5 { matrix.try_inverse() } else { eliminated(matrix) }
}

/// By Gauss–Jordan elimination of \[M I\] with the largest pivot of each column.
fn eliminated<T: Scalar, const N: usize>(matrix: &SMatrix<T, N, N>) -> Option<SMatrix<T, N, N>> {
    let unit = |on| if on { T::one() } else { T::zero() };
    let mut rows: [[SVector<T, N>; 2]; N] = core::array::from_fn(|i| {
        [SVector::from_fn(|j, _| matrix[(i, j)]), SVector::from_fn(|j, _| unit(i == j))]
    });
    for k in 0..N {
        let (above, rest) = rows.split_at_mut_checked(k)?;
        let (pivot, below) = rest.split_first_mut()?;
        for row in below.iter_mut() {
            if row[0][k].abs() > pivot[0][k].abs() {
                swap(row, pivot);
            }
        }
        let diagonal = pivot[0][k];
        if diagonal.is_zero() || !diagonal.is_finite() {
            return None;
        }
        *pivot = pivot.map(|half| half / diagonal);
        for row in above.iter_mut().chain(below) {
            let factor = row[0][k];
            for (half, of_pivot) in row.iter_mut().zip(pivot.iter()) {
                *half -= of_pivot * factor;
            }
        }
    }
    Some(SMatrix::from_fn(|i, j| rows[i][1][j]))
}
