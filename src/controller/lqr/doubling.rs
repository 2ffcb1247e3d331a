use nalgebra::SMatrix;

use super::{size, symmetric};
use crate::{
    Error, Scalar,
    error::value,
    inverse::inverse,
    scalar::{constant, epsilon},
};

/// The stabilizing solution P of P = Q + Aᵀ·P·(I + G·P)⁻¹·A, from `a` = A, `g` = G ≥ 0 and `q` = Q ≥ 0:
///
/// W = I + G_k·H_k,  A ← A·W⁻¹·A,  G ← G + A·W⁻¹·G·Aᵀ,  H ← H + Aᵀ·H·W⁻¹·A
///
/// H_k is the least cost of 2^k periods and A_k what is left of the state after them. If that vanishes H_k has converged.
pub(super) fn stabilizing<T: Scalar, const N: usize>(
    name: &'static str,
    mut a: SMatrix<T, N, N>,
    mut g: SMatrix<T, N, N>,
    mut q: SMatrix<T, N, N>,
) -> Result<SMatrix<T, N, N>, Error> {
    let mut horizon = T::one();
    // Beyond that horizon a state that neither grows nor fades would be moved by rounding alone.
    while horizon * epsilon() < constant(0.03125) {
        let w = SMatrix::identity() + g * q;
        let Some(inverse) = inverse(&w) else { break };
        let led = inverse * a;
        (a, g, q) = (
            a * led,
            symmetric(g + a * (inverse * g) * a.transpose()),
            symmetric(q + a.transpose() * q * led),
        );
        let left = size(&a);
        if !(left.is_finite() && size(&q).is_finite()) {
            break;
        }
        if left <= epsilon() {
            return Ok(q);
        }
        horizon += horizon;
    }
    Err(Error::NotStabilizable { name, left: value(size(&a)) })
}
