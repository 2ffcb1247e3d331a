use nalgebra::SVector;

use super::Actuator;
use crate::{
    Error, Scalar,
    error::{finite_vector, positive},
};

/// The actuator that does what it is told.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ideal;

impl<T: Scalar, const NU: usize> Actuator<T, NU> for Ideal {
    fn driven(&self, u: &SVector<T, NU>, dt: T) -> Result<(Self, SVector<T, NU>), Error> {
        positive("dt", dt)?;
        finite_vector("u", u)?;
        Ok((*self, *u))
    }
}
