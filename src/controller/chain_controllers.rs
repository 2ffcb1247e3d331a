use nalgebra::SVector;

use super::{Accept, Command, Controller, Measurement, Reference};
use crate::{Error, Scalar, learning::LearningMode};

/// M controllers of chains of order N, each for one output of a decoupled plant: an array of one kind, or a pair of two kinds.
///
/// Each takes the chain for its plant, so its input is the virtual input ν: give it an
/// [`IntegratorChain`](crate::plant::IntegratorChain) as model.
pub trait ChainControllers<T, const N: usize, const M: usize> {
    /// What all of them decided.
    type Commands: Copy;

    /// Updates every controller with its measurement and reference: the virtual inputs ν, and how they came about. None of them changes
    /// unless each has a command and `accept` has nothing against all of them.
    ///
    /// # Errors
    /// That of the first controller to fail, or that of `accept`.
    fn update_all(
        &mut self,
        measurements: &[Measurement<T, N, 1>; M],
        references: &[Reference<T, N>; M],
        dt: T,
        accept: Accept<Decided<T, Self::Commands, M>>,
    ) -> Result<Decided<T, Self::Commands, M>, Error>;

    /// Resets every controller.
    fn reset_all(&mut self);

    /// [`Controller::set_learning`] of every controller.
    fn set_learning_all(&mut self, mode: LearningMode);
}

/// The virtual inputs ν of all chains, and what each controller decided.
pub type Decided<T, D, const M: usize> = (SVector<T, M>, D);

/// Of a controller that said `Ok` without asking whether its command is accepted.
const NOT_ASKED: Error = Error::Missing { name: "command of a chain" };

impl<T, C, const N: usize, const M: usize> ChainControllers<T, N, M> for [C; M]
where
    T: Scalar,
    C: Controller<N, 1, Scalar = T, Reference = Reference<T, N>>,
{
    type Commands = [C::Command; M];

    fn update_all(
        &mut self,
        measurements: &[Measurement<T, N, 1>; M],
        references: &[Reference<T, N>; M],
        dt: T,
        accept: Accept<Decided<T, Self::Commands, M>>,
    ) -> Result<Decided<T, Self::Commands, M>, Error> {
        let mut decided = None;
        in_turn(self, measurements, references, dt, &mut decided, accept)?;
        decided.ok_or(NOT_ASKED)
    }

    fn reset_all(&mut self) {
        self.iter_mut().for_each(Controller::reset);
    }

    fn set_learning_all(&mut self, mode: LearningMode) {
        self.iter_mut().for_each(|controller| controller.set_learning(mode));
    }
}

/// Updates the last of the M `controllers`, each within the judgement of the one before it: the first changes only when the last has its
/// command and `accept` has agreed.
fn in_turn<T, C, const N: usize, const M: usize>(
    controllers: &mut [C],
    measurements: &[Measurement<T, N, 1>; M],
    references: &[Reference<T, N>; M],
    dt: T,
    decided: &mut Option<Decided<T, [C::Command; M], M>>,
    accept: Accept<Decided<T, [C::Command; M], M>>,
) -> Result<(), Error>
where
    T: Scalar,
    C: Controller<N, 1, Scalar = T, Reference = Reference<T, N>>,
{
    let place = M - controllers.len();
    let known = measurements.get(place).zip(references.get(place));
    let (Some((controller, others)), Some((measurement, reference))) =
        (controllers.split_first_mut(), known)
    else {
        return accept(decided.as_ref().ok_or(NOT_ASKED)?);
    };
    controller.update_if(measurement, reference, dt, &mut |command| {
        // There is no array of commands before the first of them; it fills the places of those to come.
        let (nu, commands) = decided.get_or_insert((SVector::zeros(), [*command; M]));
        for (nu, own) in nu.iter_mut().zip(commands).skip(place) {
            (*nu, *own) = (command.input()[0], *command);
        }
        in_turn(others, measurements, references, dt, decided, accept)
    })?;
    Ok(())
}

impl<T, A, B, const N: usize> ChainControllers<T, N, 2> for (A, B)
where
    T: Scalar,
    A: Controller<N, 1, Scalar = T, Reference = Reference<T, N>>,
    B: Controller<N, 1, Scalar = T, Reference = Reference<T, N>>,
{
    type Commands = (A::Command, B::Command);

    fn update_all(
        &mut self,
        [first, second]: &[Measurement<T, N, 1>; 2],
        [to, and_to]: &[Reference<T, N>; 2],
        dt: T,
        accept: Accept<Decided<T, Self::Commands, 2>>,
    ) -> Result<Decided<T, Self::Commands, 2>, Error> {
        let mut decided = Err(NOT_ASKED);
        self.0.update_if(first, to, dt, &mut |a| {
            self.1.update_if(second, and_to, dt, &mut |b| {
                let both = (SVector::from([a.input()[0], b.input()[0]]), (*a, *b));
                accept(&both)?;
                decided = Ok(both);
                Ok(())
            })?;
            Ok(())
        })?;
        decided
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
