use nalgebra::SVector;

use super::{Channel, validate};
use crate::{Error, Scalar, error::finite_vector};

/// A constant on top of each signal: uᵢ ↦ uᵢ + biasᵢ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bias<T, const N: usize> {
    bias: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Bias<T, N> {
    /// `bias` in the units of each signal.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn new(bias: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let bias = bias.into();
        finite_vector("bias", &bias)?;
        Ok(Self { bias })
    }
}

impl<T: Scalar, const N: usize> Channel<T, N> for Bias<T, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let arrived = signal + self.bias;
        finite_vector("signal + bias", &arrived)?;
        Ok((*self, arrived))
    }
}

checked! { [T: Scalar, const N: usize] Bias<T, N>, [T] { bias: SVector<T, N> } => Self::new(bias) }
