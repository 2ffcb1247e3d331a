use super::ErrorRate;
use crate::{Error, Scalar, error::remembered, learning::ClosedLoop};

/// ė_n ≈ (e_n(k) − e_n(k−1))/dt, and 0 at the first sample.
///
/// Exact for an error that moves in a straight line; half a period late otherwise.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct BackwardDifference<T> {
    last: Option<T>,
}

impl<T> BackwardDifference<T> {
    /// A difference that has seen no sample yet.
    pub const fn new() -> Self {
        Self { last: None }
    }
}

impl<T: Scalar, const N: usize> ErrorRate<T, N> for BackwardDifference<T> {
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, _u_n: T, dt: T) -> Result<T, Error> {
        let e_n = remembered("e_n/dt", at.e[N - 1], dt)?;
        let last = self.last.replace(e_n).unwrap_or(e_n);
        Ok((e_n - last) / dt)
    }
}
