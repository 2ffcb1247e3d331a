use core::array;

use nalgebra::{SMatrix, SVector};

use super::{SmoothPlant, linearized::finite_equations};
use crate::{
    Error,
    differentiation::Dual,
    error::{finite_slice, finite_vector},
};

/// A plant near an operating point: δẋ = A·δx + B·δu, δy = C·δx.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jacobians<T, const NX: usize, const M: usize> {
    /// A = ∂(f + g·u)/∂x.
    pub a: SMatrix<T, NX, NX>,
    /// B = g(x).
    pub b: SMatrix<T, NX, M>,
    /// C = ∂h/∂x.
    pub c: SMatrix<T, M, NX>,
}

/// The Jacobians of `plant` at the state `x` and the input `u`.
pub(super) fn jacobians<P, const NX: usize, const M: usize>(
    plant: &P,
    x: &SVector<P::Scalar, NX>,
    u: &SVector<P::Scalar, M>,
) -> Result<Jacobians<P::Scalar, NX, M>, Error>
where
    P: SmoothPlant<NX, M>,
{
    finite_vector("u", u)?;
    finite_equations(plant, x)?;
    let state: [Dual<P::Scalar, NX>; NX] = array::from_fn(|i| Dual::variable(x[i], i));
    let (drift, fields) = (plant.drift_field(state), plant.input_fields(state));
    let outputs = plant.outputs(state);
    let rate = |i: usize, j: usize| {
        let driven = fields.iter().zip(u).map(|(field, u)| field[i].slopes[j] * *u);
        driven.fold(drift[i].slopes[j], |sum, part| sum + part)
    };
    let jacobians: Jacobians<P::Scalar, NX, M> = Jacobians {
        a: SMatrix::from_fn(rate),
        b: SMatrix::from_fn(|i, j| fields[j][i].value),
        c: SMatrix::from_fn(|i, j| outputs[i].slopes[j]),
    };
    finite_slice("A", jacobians.a.as_slice())?;
    finite_slice("C", jacobians.c.as_slice())?;
    Ok(jacobians)
}
