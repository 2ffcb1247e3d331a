use nalgebra::SVector;

use crate::{Error, Scalar, error::finite_vector};

/// What is known about a plant at a sample.
///
/// The state is always needed. The other two are for controllers that can use them: nobody has to have the sensors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement<T, const NX: usize, const NU: usize> {
    /// The state x.
    pub x: SVector<T, NX>,
    /// ẋ as a sensor sees it at the sample, still under the input of the period that ends there.
    pub x_dot: Option<SVector<T, NX>>,
    /// The input that the plant really received over that period, if the actuators report it. Without it a controller takes
    /// its own last command, and 0 before its first.
    pub applied: Option<SVector<T, NU>>,
}

impl<T: Scalar, const NX: usize, const NU: usize> Measurement<T, NX, NU> {
    /// A measurement of the state alone.
    pub fn new(x: impl Into<SVector<T, NX>>) -> Self {
        Self { x: x.into(), x_dot: None, applied: None }
    }

    /// The same with a measured derivative ẋ.
    pub fn with_rate(self, x_dot: impl Into<SVector<T, NX>>) -> Self {
        Self { x_dot: Some(x_dot.into()), ..self }
    }

    /// The same with the input that the actuators report for the last period.
    pub fn with_applied(self, u: impl Into<SVector<T, NU>>) -> Self {
        Self { applied: Some(u.into()), ..self }
    }

    /// Checks that everything given is finite.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], naming `x`, `x_dot` or `applied`.
    pub fn validate(&self) -> Result<(), Error> {
        finite_vector("x", &self.x)?;
        if let Some(x_dot) = &self.x_dot {
            finite_vector("x_dot", x_dot)?;
        }
        if let Some(applied) = &self.applied {
            finite_vector("applied", applied)?;
        }
        Ok(())
    }
}
