use super::ErrorRate;
use crate::{
    Error, Scalar,
    error::{not_negative, remembered},
    learning::ClosedLoop,
};

/// ė_n through a first-order filter: the transfer function p/(τ·p + 1), discretized by the backward Euler method as
/// y(k) = (τ·y(k−1) + e_n(k) − e_n(k−1))/(τ + dt), and 0 at the first sample.
///
/// τ = 0 is the [`BackwardDifference`](super::BackwardDifference). White noise of variance V on e_n comes out with variance
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
}

impl<T: Scalar, const N: usize> ErrorRate<T, N> for FilteredDifference<T> {
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, _u_n: T, dt: T) -> Result<T, Error> {
        let span = self.time_constant + dt;
        let e_n = remembered("e_n/(tau + dt)", at.e[N - 1], span)?;
        let last = self.last.replace(e_n).unwrap_or(e_n);
        // The quotients first: τ·y may leave the range where y does not.
        self.rate = self.time_constant / span * self.rate + (e_n - last) / span;
        Ok(self.rate)
    }
}
