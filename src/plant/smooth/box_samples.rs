use core::iter::FusedIterator;

use nalgebra::SVector;

use crate::{Error, Scalar, error::finite_vector, scalar::constant};

/// States that fill a box evenly, without end: a Kronecker sequence, xᵢ = lowᵢ + (highᵢ − lowᵢ)·frac(½ + k·φ⁻ⁱ⁻¹), φᴺ⁺¹ = φ + 1.
///
/// The same box gives the same states. φ is the golden ratio for N = 1, and the plastic number for N = 2.
///
/// ```
/// use brunovsky::plant::BoxSamples;
///
/// let states: Vec<_> = BoxSamples::new([-1.0_f64, 0.0], [1.0, 5.0])?.take(100).collect();
/// assert!(states.iter().all(|x| x[0].abs() <= 1.0 && (0.0..=5.0).contains(&x[1])));
/// # Ok::<(), brunovsky::Error>(())
/// ```
///
/// # References
/// H. Niederreiter, *Random Number Generation and Quasi-Monte Carlo Methods*, 3 (Kronecker sequences).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxSamples<T, const N: usize> {
    low: SVector<T, N>,
    size: SVector<T, N>,
    stride: SVector<T, N>,
    place: SVector<T, N>,
}

impl<T: Scalar, const N: usize> BoxSamples<T, N> {
    /// The states between the corners `low` and `high`.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] for a corner, or for the size of the box.
    pub fn new(
        low: impl Into<SVector<T, N>>,
        high: impl Into<SVector<T, N>>,
    ) -> Result<Self, Error> {
        let (low, high) = (low.into(), high.into());
        finite_vector("low", &low)?;
        finite_vector("high", &high)?;
        let size = high - low;
        finite_vector("high - low", &size)?;
        let exponent = constant::<T>((N + 1) as f64).recip();
        // The fixed point attracts with a factor below 1/(N + 1) ≤ 1/2.
        let ratio = (0..60).fold(T::one(), |ratio, _| (T::one() + ratio).powf(exponent)).recip();
        let stride = SVector::from_fn(|i, _| (0..=i).fold(T::one(), |power, _| power * ratio));
        Ok(Self { low, size, stride, place: SVector::repeat(constant(0.5)) })
    }
}

impl<T: Scalar, const N: usize> Iterator for BoxSamples<T, N> {
    type Item = SVector<T, N>;

    fn next(&mut self) -> Option<SVector<T, N>> {
        let state = self.low + self.size.component_mul(&self.place);
        // Both are below 1; dual numbers have no floor.
        let inside = |place: T| if place < T::one() { place } else { place - T::one() };
        self.place = (self.place + self.stride).map(inside);
        Some(state)
    }
}

impl<T: Scalar, const N: usize> FusedIterator for BoxSamples<T, N> {}
