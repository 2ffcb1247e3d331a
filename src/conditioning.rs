//! How close a matrix is to a singular one, in the maximum norm.

use nalgebra::SMatrix;

use crate::{Scalar, scalar::epsilon};

/// ‖B‖, the largest sum of absolute values in a row; NaNs are passed over.
pub(crate) fn norm<T: Scalar, const M: usize>(matrix: &SMatrix<T, M, M>) -> T {
    let sums = matrix.row_iter().map(|row| row.iter().fold(T::zero(), |sum, b| sum + b.abs()));
    sums.fold(T::zero(), T::max)
}

/// 1/√ε: at a condition number above it an inverse has lost half of its digits.
pub(crate) fn max_condition<T: Scalar>() -> T {
    epsilon::<T>().sqrt().recip()
}
