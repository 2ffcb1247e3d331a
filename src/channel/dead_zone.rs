use nalgebra::SVector;

use super::{Channel, validate};
use crate::{Error, Scalar, error::not_negative_vector};

/// A dead zone about 0: uᵢ ↦ uᵢ − min(max(uᵢ, −widthᵢ), widthᵢ), as of a valve with overlap or a gear with play and a spring.
///
/// What is within ±widthᵢ is lost, and as much of everything else.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeadZone<T, const N: usize> {
    width: SVector<T, N>,
}

impl<T: Scalar, const N: usize> DeadZone<T, N> {
    /// Dead zones from −`width` to `width` ≥ 0 for each signal, in its units.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn new(width: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let width = width.into();
        not_negative_vector("width", &width)?;
        Ok(Self { width })
    }
}

impl<T: Scalar, const N: usize> Channel<T, N> for DeadZone<T, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        Ok((
            *self,
            signal.zip_map(&self.width, |value, width| value - value.max(-width).min(width)),
        ))
    }
}

checked! { [T: Scalar, const N: usize] DeadZone<T, N>, [T] { width: SVector<T, N> } => Self::new(width) }
