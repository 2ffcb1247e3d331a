use nalgebra::SVector;

use crate::Scalar;

/// The L functions φ(x) of which an uncertainty θᵀφ(x) is made: the known shape of what is not known.
///
/// A closure `|x: &SVector<T, N>| SVector::from([…])` is one.
pub trait Regressor<T, const N: usize, const L: usize> {
    /// φ(x).
    fn regressor(&self, x: &SVector<T, N>) -> SVector<T, L>;
}

impl<T, F, const N: usize, const L: usize> Regressor<T, N, L> for F
where
    F: Fn(&SVector<T, N>) -> SVector<T, L>,
{
    fn regressor(&self, x: &SVector<T, N>) -> SVector<T, L> {
        self(x)
    }
}

/// φ(x) = x: a linear plant whose coefficients are not known.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StateRegressor;

impl<T: Scalar, const N: usize> Regressor<T, N, N> for StateRegressor {
    fn regressor(&self, x: &SVector<T, N>) -> SVector<T, N> {
        *x
    }
}
