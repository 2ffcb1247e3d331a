use core::fmt;

use crate::{
    Error,
    error::{below, positive},
};

/// An estimated value and its confidence interval \[low, high\]; an end that the data say nothing about is infinite.
///
/// Prints as `value [low, high]`, each with the precision asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// The lower end of the interval.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
}

impl Estimate {
    /// Whether the interval contains `value`.
    pub fn covers(&self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }
}

impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Display::fmt(&self.value, f)?;
        f.write_str(" [")?;
        fmt::Display::fmt(&self.low, f)?;
        f.write_str(", ")?;
        fmt::Display::fmt(&self.high, f)?;
        f.write_str("]")
    }
}

/// A confidence level: a probability strictly between 0 and 1.
pub(super) fn level(level: f64) -> Result<f64, Error> {
    below("confidence level", positive("confidence level", level)?, 1.0)
}
