use nalgebra::SVector;

use crate::{
    Error, Scalar,
    error::{not_negative, positive_vector},
    scalar::constant,
};

/// How far off a single step may be: component i by wᵢ = atolᵢ + rtol·|xᵢ|.
///
/// A step is accepted if √(1/N·Σᵢ (errorᵢ/wᵢ)²) ≤ 1. The error at the end of many steps is not bounded by this but falls with it, about
/// in proportion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance<T, const N: usize> {
    relative: T,
    absolute: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Tolerance<T, N> {
    /// The relative tolerance `rtol` ≥ 0, and the absolute tolerance `atol` > 0 for all components, in their units.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`] for `rtol`, [`Error::NotPositive`] or [`Error::NonFinite`] for `atol`.
    pub fn new(rtol: T, atol: T) -> Result<Self, Error> {
        Self::per_component(rtol, SVector::repeat(atol))
    }

    /// The same with an absolute tolerance for each component, where their sizes or units differ.
    ///
    /// # Errors
    /// As [`new`](Self::new), for the first component that is refused.
    pub fn per_component(rtol: T, atol: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let absolute = atol.into();
        positive_vector("atol", &absolute)?;
        Ok(Self { relative: not_negative("rtol", rtol)?, absolute })
    }

    /// w for a step from `x` to `y`: atolᵢ + rtol·max(|xᵢ|, |yᵢ|).
    pub(crate) fn weights(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.absolute + x.zip_map(y, |x, y| x.abs().max(y.abs())) * self.relative
    }
}

/// √(1/N·Σᵢ (vᵢ/wᵢ)²): at most 1 is within the tolerance.
pub(crate) fn norm<T: Scalar, const N: usize>(v: &SVector<T, N>, weights: &SVector<T, N>) -> T {
    let squares = v.component_div(weights).norm_squared();
    (squares / constant(N.max(1) as f64)).sqrt()
}

checked! {
    [T: Scalar, const N: usize] Tolerance<T, N>, [T] { relative: T, absolute: SVector<T, N> } =>
    Self::per_component(relative, absolute)
}
