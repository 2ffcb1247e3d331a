use nalgebra::SVector;

use super::{Command, Controller, Measurement, Reference};
use crate::{Error, Scalar, learning::LearningMode};

/// M controllers of chains of order N, each for one output of a decoupled plant: an array of one kind, or a pair of two kinds.
///
/// Each takes the chain for its plant, so its input is the virtual input ν: give it an
/// [`IntegratorChain`](crate::plant::IntegratorChain) as model.
pub trait ChainControllers<T, const N: usize, const M: usize>: Clone {
    /// What all of them decided.
    type Commands;

    /// Updates every controller with its measurement and reference: the virtual inputs ν, and how they came about.
    ///
    /// # Errors
    /// That of the first controller to fail; the others may have been updated.
    fn update_all(
        &mut self,
        measurements: &[Measurement<T, N, 1>; M],
        references: &[Reference<T, N>; M],
        dt: T,
    ) -> Result<(SVector<T, M>, Self::Commands), Error>;

    /// Resets every controller.
    fn reset_all(&mut self);

    /// [`Controller::set_learning`] of every controller.
    fn set_learning_all(&mut self, mode: LearningMode);
}

impl<T, C, const N: usize, const M: usize> ChainControllers<T, N, M> for [C; M]
where
    T: Scalar,
    C: Controller<N, 1, Scalar = T, Reference = Reference<T, N>> + Clone,
    C::Command: Copy,
{
    type Commands = [C::Command; M];

    fn update_all(
        &mut self,
        measurements: &[Measurement<T, N, 1>; M],
        references: &[Reference<T, N>; M],
        dt: T,
    ) -> Result<(SVector<T, M>, Self::Commands), Error> {
        let mut nu = SVector::zeros();
        // There is no array of commands before the first of them; it fills the places of those to come.
        let mut commands: Option<Self::Commands> = None;
        let known = measurements.iter().zip(references);
        for (i, (controller, (measurement, reference))) in self.iter_mut().zip(known).enumerate() {
            let command = controller.update(measurement, reference, dt)?;
            nu[i] = command.input()[0];
            commands.get_or_insert([command; M])[i] = command;
        }
        Ok((nu, commands.ok_or(Error::Missing { name: "chain" })?))
    }

    fn reset_all(&mut self) {
        self.iter_mut().for_each(Controller::reset);
    }

    fn set_learning_all(&mut self, mode: LearningMode) {
        self.iter_mut().for_each(|controller| controller.set_learning(mode));
    }
}

impl<T, A, B, const N: usize> ChainControllers<T, N, 2> for (A, B)
where
    T: Scalar,
    A: Controller<N, 1, Scalar = T, Reference = Reference<T, N>> + Clone,
    B: Controller<N, 1, Scalar = T, Reference = Reference<T, N>> + Clone,
{
    type Commands = (A::Command, B::Command);

    fn update_all(
        &mut self,
        [first, second]: &[Measurement<T, N, 1>; 2],
        [to, and_to]: &[Reference<T, N>; 2],
        dt: T,
    ) -> Result<(SVector<T, 2>, Self::Commands), Error> {
        let commands = (self.0.update(first, to, dt)?, self.1.update(second, and_to, dt)?);
        Ok((SVector::from([commands.0.input()[0], commands.1.input()[0]]), commands))
    }

    fn reset_all(&mut self) {
        self.0.reset();
        self.1.reset();
    }

    fn set_learning_all(&mut self, mode: LearningMode) {
        self.0.set_learning(mode);
        self.1.set_learning(mode);
    }
}
