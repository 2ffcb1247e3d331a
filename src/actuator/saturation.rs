use nalgebra::SVector;

use super::Actuator;
use crate::{
    Error, Scalar,
    error::{below, finite_vector, positive},
};

/// Limits on each input: uᵢ ↦ min(max(uᵢ, leastᵢ), mostᵢ).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Saturation<T, const NU: usize> {
    least: SVector<T, NU>,
    most: SVector<T, NU>,
}

impl<T: Scalar, const NU: usize> Saturation<T, NU> {
    /// Limits `least` < `most` for each input, in its units.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], or [`Error::NotBelow`] unless each `least` is below its `most`.
    pub fn new(
        least: impl Into<SVector<T, NU>>,
        most: impl Into<SVector<T, NU>>,
    ) -> Result<Self, Error> {
        let (least, most) = (least.into(), most.into());
        finite_vector("least", &least)?;
        finite_vector("most", &most)?;
        for (least, most) in least.iter().zip(most.iter()) {
            below("least", *least, *most)?;
        }
        Ok(Self { least, most })
    }

    /// Limits ±`size` for each input.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], or [`Error::NotBelow`] unless each size is positive.
    pub fn symmetric(size: impl Into<SVector<T, NU>>) -> Result<Self, Error> {
        let size = size.into();
        Self::new(-size, size)
    }
}

impl<T: Scalar, const NU: usize> Actuator<T, NU> for Saturation<T, NU> {
    fn driven(&self, u: &SVector<T, NU>, dt: T) -> Result<(Self, SVector<T, NU>), Error> {
        positive("dt", dt)?;
        finite_vector("u", u)?;
        let limits = self.least.zip_map(&self.most, |least, most| (least, most));
        Ok((*self, u.zip_map(&limits, |u, (least, most)| u.max(least).min(most))))
    }
}

checked! {
    [T: Scalar, const NU: usize] Saturation<T, NU>, [T]
    { least: SVector<T, NU>, most: SVector<T, NU> } =>
    Self::new(least, most)
}
