use nalgebra::SVector;

use super::{Accept, Command, Controller, Measurement};
use crate::{Error, channel::Channel, learning::LearningMode};

/// A controller behind whose command stands an actuator with limits, and which is told what arrived.
///
/// The input is what the actuator makes of the command. At the next sample the controller inside sees that as the applied input, unless
/// the measurement brings a report of its own: learning then knows what was really done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limited<C, A, T, const NU: usize> {
    controller: C,
    actuator: A,
    start: A,
    arrived: Option<SVector<T, NU>>,
}

/// An input of [`Limited`] and the command that it was made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitedCommand<D, T, const NU: usize> {
    /// The input that arrives.
    pub u: SVector<T, NU>,
    /// What the controller inside decided.
    pub asked: D,
}

impl<D: Copy, T: crate::Scalar, const NU: usize> Command<T, NU> for LimitedCommand<D, T, NU> {
    fn input(&self) -> SVector<T, NU> {
        self.u
    }
}

impl<D: Command<T, NU>, T: crate::Scalar, const NU: usize> LimitedCommand<D, T, NU> {
    /// Whether the actuator changed the command.
    pub fn is_limited(&self) -> bool {
        self.u != self.asked.input()
    }
}

impl<C, A: Clone, T, const NU: usize> Limited<C, A, T, NU> {
    /// `controller` with `actuator` behind it.
    pub fn new(controller: C, actuator: A) -> Self {
        Self { controller, start: actuator.clone(), actuator, arrived: None }
    }

    /// The controller inside.
    pub fn controller(&self) -> &C {
        &self.controller
    }

    /// The controller inside, to be changed.
    pub fn controller_mut(&mut self) -> &mut C {
        &mut self.controller
    }
}

impl<C, A, const NX: usize, const NU: usize> Controller<NX, NU> for Limited<C, A, C::Scalar, NU>
where
    C: Controller<NX, NU>,
    A: Channel<C::Scalar, NU>,
{
    type Scalar = C::Scalar;
    type Reference = C::Reference;
    type Command = LimitedCommand<C::Command, C::Scalar, NU>;

    /// # Errors
    /// Those of the controller inside.
    fn update_if(
        &mut self,
        measurement: &Measurement<C::Scalar, NX, NU>,
        reference: &C::Reference,
        dt: C::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let told = Measurement { applied: measurement.applied.or(self.arrived), ..*measurement };
        let mut u = SVector::zeros();
        let asked = self.controller.update_if(&told, reference, dt, &mut |asked| {
            let (actuator, arrived) = self.actuator.passed(&asked.input(), dt)?;
            accept(&LimitedCommand { u: arrived, asked: *asked })?;
            (self.actuator, self.arrived, u) = (actuator, Some(arrived), arrived);
            Ok(())
        })?;
        Ok(LimitedCommand { u, asked })
    }

    fn reset(&mut self) {
        self.controller.reset();
        self.actuator = self.start.clone();
        self.arrived = None;
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.controller.set_learning(mode);
    }
}

checked! {
    [C, A, T: crate::Scalar, const NU: usize] Limited<C, A, T, NU>, [C, A, T]
    { controller: C, actuator: A, start: A, arrived: Option<SVector<T, NU>> } =>
    known("last u", arrived.iter().flatten().copied())
        .map(|()| Self { controller, actuator, start, arrived })
}
