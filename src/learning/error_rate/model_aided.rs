use super::ErrorRate;
use crate::{Error, Scalar, error::remembered, learning::ClosedLoop, scalar::constant};

/// ė_n from the nominal model and the applied input, corrected by what the last period showed of the uncertainty.
///
/// Over the last period, under the input u that the plant really received, the model predicts a mean ẋ_n of
/// ½·((a + b·u)(k−1) + (a + b·u)(k)); the difference (x_n(k) − x_n(k−1))/dt shows the true one. What is left over is Δ̂, the mean
/// uncertainty of that period up to O(dt²), and
///
/// ė_n = −u_b − u_n − Δ̂, hence s = −(u_n + Δ̂).
///
/// Without Δ̂ the model alone would give s = −u_n, which forgets and learns nothing. At the first sample Δ̂ = 0.
///
/// Neither a transient of the feedback nor a saturated actuator appears in s, provided that the applied input is reported.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ModelAided<T> {
    last: Option<Sample<T>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Sample<T> {
    x_n: T,
    drift: T,
    gain: T,
}

impl<T> ModelAided<T> {
    /// A source that has seen no sample yet.
    pub const fn new() -> Self {
        Self { last: None }
    }
}

impl<T: Scalar, const N: usize> ErrorRate<T, N> for ModelAided<T> {
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error> {
        let x_n = remembered("x_n/dt", at.x[N - 1], dt)?;
        let now = Sample { x_n, drift: at.drift, gain: at.gain };
        let uncertainty = match self.last.replace(now) {
            None => T::zero(),
            Some(last) => {
                // Halves first: a sum of two may leave the range where their mean does not.
                let mean = |a: T, b: T| a * constant(0.5) + b * constant(0.5);
                let predicted = mean(last.drift, now.drift) + mean(last.gain, now.gain) * at.u;
                (now.x_n - last.x_n) / dt - predicted
            }
        };
        Ok(-at.u_b - u_n - uncertainty)
    }
}
