use nalgebra::SVector;

use super::{Channel, validate};
use crate::{Error, Scalar};

/// The channel through which everything arrives as it was sent.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ideal;

impl<T: Scalar, const N: usize> Channel<T, N> for Ideal {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        Ok((*self, *signal))
    }
}
