use nalgebra::SVector;

use super::{Accept, Controller, Measurement, Reference};
use crate::{Error, Scalar, learning::LearningMode};

/// A controller of order R for a chain that fills the last R entries of a longer one: the first entries are passed over.
///
/// [`Decoupling`](super::Decoupling) has one length N for all chains; outputs of different relative degree have chains of
/// different order in it (see [`Decouplable`](crate::plant::Decouplable)). [`Reference::padded`] makes the reference that fits.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Padded<C, const R: usize>(pub C);

/// The last R entries; zeros where there are fewer.
fn tail<T: Scalar, const N: usize, const R: usize>(vector: &SVector<T, N>) -> SVector<T, R> {
    SVector::from_fn(|i, _| (i + N).checked_sub(R).map_or(T::zero(), |i| vector[i]))
}

impl<T, C, const R: usize, const N: usize> Controller<N, 1> for Padded<C, R>
where
    T: Scalar,
    C: Controller<R, 1, Scalar = T, Reference = Reference<T, R>>,
{
    type Scalar = T;
    type Reference = Reference<T, N>;
    type Command = C::Command;

    /// # Errors
    /// Those of the controller inside.
    fn update_if(
        &mut self,
        measurement: &Measurement<T, N, 1>,
        reference: &Reference<T, N>,
        dt: T,
        accept: Accept<C::Command>,
    ) -> Result<C::Command, Error> {
        let short = Measurement {
            x: tail(&measurement.x),
            x_dot: measurement.x_dot.as_ref().map(tail),
            applied: measurement.applied,
        };
        let reference = Reference { r: tail(&reference.r), r_n_dot: reference.r_n_dot };
        self.0.update_if(&short, &reference, dt, accept)
    }

    fn reset(&mut self) {
        self.0.reset();
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.0.set_learning(mode);
    }
}
