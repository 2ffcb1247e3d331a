use nalgebra::SMatrix;

use super::{continuous::solved, weights::mirrored};
use crate::{Error, Scalar, error::finite_slice};

/// The symmetric P of AᵀP + PA + Q = 0 for an A whose eigenvalues lie in the left half plane: V = xᵀPx has V̇ = −xᵀQx along ẋ = A·x.
///
/// P is the cost of a state without an input, the integral of xᵀQx.
///
/// # Errors
/// [`Error::NonFiniteEntry`]; [`Error::Asymmetric`] for Q; [`Error::NotStabilizable`] if A is not stable, to the precision of `T`; [`Error::Unsolved`] if the solution has lost
/// half of its digits.
pub fn lyapunov<T: Scalar, const N: usize>(
    a: &SMatrix<T, N, N>,
    q: &SMatrix<T, N, N>,
) -> Result<SMatrix<T, N, N>, Error> {
    finite_slice("A", a.as_slice())?;
    let q = mirrored("Q", *q)?;
    Ok(solved("Lyapunov equation", *a, SMatrix::zeros(), q)?.0)
}
