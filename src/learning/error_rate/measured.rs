use super::ErrorRate;
use crate::{Error, Scalar, learning::ClosedLoop};

/// ė_n from a sensor for ẋ_n, such as an accelerometer.
///
/// A sensor sees ẋ_n = a + b·u + Δ under the input of the period that ends at the sample. What would follow if the loop learned
/// no further differs by the step of the input alone, which the model knows:
///
/// ė_n = u_f − (ẋ_n − (a + b·u) + u_f + u_b + u_n), hence s = −(u_n + Δ) to rounding.
///
/// The first sample is no exception: before it the input is the one reported as applied, or 0. Where the sensor may drop out, put [`Redundant`](super::Redundant) around it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Measured;

impl<T: Scalar, const N: usize> ErrorRate<T, N> for Measured {
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, _dt: T) -> Result<T, Error> {
        let rate = at.rate.ok_or(Error::Missing { name: "measured rate of x_n" })?;
        let uncertainty = rate - (at.drift + at.gain * at.u);
        Ok(-at.u_b - u_n - uncertainty)
    }
}
