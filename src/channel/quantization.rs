use nalgebra::SVector;

use super::{Channel, validate};
use crate::{Error, Scalar, error::positive_vector};

/// Quantization of each signal to the nearest multiple of a step, halves away from 0: of a converter, or of an encoder between its lines.
///
/// The error is at most half a step. A converter's range is a [`Saturation`](super::Saturation) before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantization<T, const N: usize> {
    step: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Quantization<T, N> {
    /// Quantization to multiples of `step` > 0 for each signal, in its units.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(step: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let step = step.into();
        positive_vector("step", &step)?;
        Ok(Self { step })
    }
}

impl<T: Scalar, const N: usize> Channel<T, N> for Quantization<T, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let quantized = |value: T, step: T| {
            let nearest = (value / step).round() * step;
            // So many steps that they have no number, or the last of them ends outside of the range: the value is a multiple but for its rounding.
            if nearest.is_finite() { nearest } else { value }
        };
        Ok((*self, signal.zip_map(&self.step, quantized)))
    }
}

checked! { [T: Scalar, const N: usize] Quantization<T, N>, [T] { step: SVector<T, N> } => Self::new(step) }
