use super::{Differentiator, validated};
use crate::{
    Error, Scalar,
    error::{finite, not_negative, positive},
};

/// ẏ through a first-order filter: the transfer function p/(τ·p + 1), discretized by the backward Euler method as
/// ẏ̂(k) = (τ·ẏ̂(k−1) + y(k) − y(k−1))/(τ + dt), and 0 at the first sample.
///
/// τ = 0 is the [`BackwardDifference`](super::BackwardDifference). White noise of variance V on y comes out with variance
/// 2V/((τ + dt)·(2τ + dt)); the delay for slow signals is τ + dt/2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilteredDifference<T> {
    time_constant: T,
    last: Option<T>,
    rate: T,
}

impl<T: Scalar> FilteredDifference<T> {
    /// A filter with time constant τ ≥ 0 in seconds.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn new(time_constant: T) -> Result<Self, Error> {
        Ok(Self {
            time_constant: not_negative("time constant", time_constant)?,
            last: None,
            rate: T::zero(),
        })
    }

    /// τ = √(σ/L) for white noise of standard deviation `noise` = σ > 0 and |ÿ| ≤ `bound` = L > 0: it makes the largest mean square error,
    /// (Lτ)² + σ²/τ² for dt ≪ τ, the least.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn for_noise(noise: T, bound: T) -> Result<Self, Error> {
        let (noise, bound) = (positive("noise", noise)?, positive("bound on the rate", bound)?);
        Self::new(noise.sqrt() / bound.sqrt())
    }

    /// The time constant τ in seconds.
    pub fn time_constant(&self) -> T {
        self.time_constant
    }
}

impl<T: Scalar> Differentiator for FilteredDifference<T> {
    type Scalar = T;

    fn update_beyond(&mut self, y: T, known: T, dt: T) -> Result<T, Error> {
        let span = self.time_constant + dt;
        validated("y/(tau + dt)", y, known, dt, span)?;
        let last = self.last.map_or(y, |last| last + known);
        // The quotients first: τ·ẏ may leave the range where ẏ does not.
        let rate = self.time_constant / span * self.rate + (y - last) / span;
        self.rate = finite("rate of y", rate)?;
        self.last = Some(y);
        Ok(rate)
    }

    fn reset(&mut self) {
        self.last = None;
        self.rate = T::zero();
    }
}

checked! {
    [T: Scalar] FilteredDifference<T>, [T] { time_constant: T, last: Option<T>, rate: T } =>
    Self::new(time_constant).and_then(|new| {
        known("last y", last)?;
        Ok(Self { last, rate: finite("rate of y", rate)?, ..new })
    })
}
