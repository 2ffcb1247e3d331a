use nalgebra::SVector;

use super::{Channel, validate};
use crate::{
    Error, Scalar,
    error::{below, finite_vector},
};

/// Limits on each signal: uᵢ ↦ min(max(uᵢ, leastᵢ), mostᵢ).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Saturation<T, const N: usize> {
    least: SVector<T, N>,
    most: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Saturation<T, N> {
    /// Limits `least` < `most` for each signal, in its units.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], or [`Error::NotBelow`] unless each `least` is below its `most`.
    pub fn new(
        least: impl Into<SVector<T, N>>,
        most: impl Into<SVector<T, N>>,
    ) -> Result<Self, Error> {
        let (least, most) = (least.into(), most.into());
        finite_vector("least", &least)?;
        finite_vector("most", &most)?;
        for (least, most) in least.iter().zip(most.iter()) {
            below("least", *least, *most)?;
        }
        Ok(Self { least, most })
    }

    /// Limits ±`size` for each signal.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], or [`Error::NotBelow`] unless each size is positive.
    pub fn symmetric(size: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let size = size.into();
        Self::new(-size, size)
    }
}

impl<T: Scalar, const N: usize> Channel<T, N> for Saturation<T, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let limits = self.least.zip_map(&self.most, |least, most| (least, most));
        Ok((*self, signal.zip_map(&limits, |value, (least, most)| value.max(least).min(most))))
    }
}

checked! {
    [T: Scalar, const N: usize] Saturation<T, N>, [T]
    { least: SVector<T, N>, most: SVector<T, N> } =>
    Self::new(least, most)
}
