use super::{Differentiator, validated};
use crate::{Error, Scalar, error::finite};

/// ẏ ≈ (y(k) − y(k−1))/dt, and 0 at the first sample.
///
/// Exact for a signal that moves in a straight line; half a period late otherwise.
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

impl<T: Scalar> Differentiator for BackwardDifference<T> {
    type Scalar = T;

    fn update_beyond(&mut self, y: T, known: T, dt: T) -> Result<T, Error> {
        validated("y/dt", y, known, dt, dt)?;
        let last = self.last.map_or(y, |last| last + known);
        let rate = finite("rate of y", (y - last) / dt)?;
        self.last = Some(y);
        Ok(rate)
    }

    fn reset(&mut self) {
        self.last = None;
    }
}

checked! {
    [T: Scalar] BackwardDifference<T>, [T] { last: Option<T> } =>
    known("last y", last).map(|()| Self { last })
}
