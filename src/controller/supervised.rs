use nalgebra::SVector;

use super::{Accept, Command, Controller, Measurement};
use crate::{
    Error, Scalar,
    error::{finite_vector, positive, positive_vector},
    learning::LearningMode,
    scalar::faded,
};

/// Who decides the input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Mode {
    /// The operator. The controller goes on watching, and neither learns nor has a say.
    Manual,
    /// The controller: plain feedback, with what was learned so far, or learning.
    Automatic(LearningMode),
}

/// A controller and an operator, who takes over and hands back without a bump.
///
/// Whenever the mode has changed, u(k) = u(k−1) to rounding: the input stays where it was for a sample. From there on
///
/// u = u_controller + w, where w moves to zero at the rate R:  |wᵢ(k)| = max(|wᵢ(k−1)| − Rᵢ·h, 0)
///
/// so the loop is closed with its full gains at once, under a disturbance b·w of the input that ends after |w|/R. The controller is told
/// the input that it did not decide, as applied; [`ModelAided`](crate::learning::ModelAided) does not take w for an uncertainty, and a
/// difference learns and unlearns it, if α exceeds B + b·R.
///
/// In manual mode nothing can fail: the input is the operator's, whatever the sensors say. Taking over starts from the last input. Where
/// sensors have failed, wait for one good sample before handing back: a difference reaches back to the last one.
///
/// An actuator's limits go around it, as [`Limited`](super::Limited) of this: they then hold for the operator and the offset too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Supervised<C, T, const NU: usize> {
    controller: C,
    fade: SVector<T, NU>,
    mode: Mode,
    manual: SVector<T, NU>,
    offset: SVector<T, NU>,
    last: Option<(Mode, SVector<T, NU>)>,
}

/// An input of [`Supervised`] and how it came about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupervisedCommand<D, T, const NU: usize> {
    /// The input u.
    pub u: SVector<T, NU>,
    /// Who decided it.
    pub mode: Mode,
    /// The offset w that is left of the last transfer; 0 in manual mode.
    pub offset: SVector<T, NU>,
    /// What the controller decided, or in manual mode would have, and why not if it could not.
    pub asked: Result<D, Error>,
}

impl<D: Copy, T: Scalar, const NU: usize> Command<T, NU> for SupervisedCommand<D, T, NU> {
    fn input(&self) -> SVector<T, NU> {
        self.u
    }
}

impl<C, T: Scalar, const NU: usize> Supervised<C, T, NU> {
    /// `controller` with an operator beside it, who has the say first, with the input 0. After a transfer the offset of each input goes away at
    /// the rate `fade` > 0, in its units per second.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new<const NX: usize>(
        mut controller: C,
        fade: impl Into<SVector<T, NU>>,
    ) -> Result<Self, Error>
    where
        C: Controller<NX, NU, Scalar = T>,
    {
        let fade = fade.into();
        positive_vector("fade", &fade)?;
        controller.set_learning(LearningMode::Off);
        let zero = SVector::zeros();
        Ok(Self { controller, fade, mode: Mode::Manual, manual: zero, offset: zero, last: None })
    }

    /// Changes the mode, from the next sample on. To select the present one changes nothing.
    pub fn select<const NX: usize>(&mut self, mode: Mode)
    where
        C: Controller<NX, NU, Scalar = T>,
    {
        self.controller.set_learning(match mode {
            Mode::Manual => LearningMode::Off,
            Mode::Automatic(learning) => learning,
        });
        if let (Mode::Automatic(_), Mode::Manual, Some((Mode::Automatic(_), u))) =
            (self.mode, mode, self.last)
        {
            self.manual = u;
        }
        self.mode = mode;
    }

    /// The operator's input, from the next sample in manual mode on.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`]; the input is then as before.
    pub fn set_manual(&mut self, u: impl Into<SVector<T, NU>>) -> Result<(), Error> {
        let u = u.into();
        finite_vector("manual input", &u)?;
        self.manual = u;
        Ok(())
    }

    /// The present mode.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The controller inside.
    pub fn controller(&self) -> &C {
        &self.controller
    }

    /// The controller inside, to be changed. Its learning mode is that of [`select`](Self::select).
    pub fn controller_mut(&mut self) -> &mut C {
        &mut self.controller
    }
}

impl<C, T: Scalar, const NU: usize> Supervised<C, T, NU> {
    /// The operator's input, whatever the controller makes of the sample.
    fn watched<const NX: usize>(
        &mut self,
        told: &Measurement<T, NX, NU>,
        reference: &C::Reference,
        dt: T,
        accept: Accept<SupervisedCommand<C::Command, T, NU>>,
    ) -> Result<SupervisedCommand<C::Command, T, NU>, Error>
    where
        C: Controller<NX, NU, Scalar = T>,
    {
        let (mode, u) = (self.mode, self.manual);
        let command = |asked| SupervisedCommand { u, mode, offset: SVector::zeros(), asked };
        let mut refused = Ok(());
        let asked = self.controller.update_if(told, reference, dt, &mut |asked| {
            refused = accept(&command(Ok(*asked)));
            refused
        });
        refused?;
        if asked.is_err() {
            accept(&command(asked))?;
        }
        Ok(command(asked))
    }

    /// The controller's input, and what is left of the last transfer.
    fn decided<const NX: usize>(
        &mut self,
        told: &Measurement<T, NX, NU>,
        reference: &C::Reference,
        dt: T,
        accept: Accept<SupervisedCommand<C::Command, T, NU>>,
    ) -> Result<SupervisedCommand<C::Command, T, NU>, Error>
    where
        C: Controller<NX, NU, Scalar = T>,
    {
        positive("dt", dt)?;
        let (mode, last) = (self.mode, self.last);
        let left = self.offset.zip_map(&self.fade, |offset, fade| faded(offset, fade * dt));
        let command = |asked: C::Command| {
            let u = asked.input();
            let offset = match last {
                Some((before, last)) if before != mode => last - u,
                _ => left,
            };
            SupervisedCommand { u: u + offset, mode, offset, asked: Ok(asked) }
        };
        let asked = self.controller.update_if(told, reference, dt, &mut |asked| {
            let command = command(*asked);
            finite_vector("u", &command.u)?;
            accept(&command)
        })?;
        Ok(command(asked))
    }
}

impl<C, const NX: usize, const NU: usize> Controller<NX, NU> for Supervised<C, C::Scalar, NU>
where
    C: Controller<NX, NU>,
{
    type Scalar = C::Scalar;
    type Reference = C::Reference;
    type Command = SupervisedCommand<C::Command, C::Scalar, NU>;

    /// # Errors
    /// In automatic mode those of the controller inside; [`Error::NotPositive`] and [`Error::NonFinite`] for `dt`, and
    /// [`Error::NonFiniteEntry`] for an input beyond the range of the scalar.
    fn update_if(
        &mut self,
        measurement: &Measurement<C::Scalar, NX, NU>,
        reference: &C::Reference,
        dt: C::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let arrived = self.last.map(|(_, u)| u);
        let told = Measurement { applied: measurement.applied.or(arrived), ..*measurement };
        let command = match self.mode {
            Mode::Manual => self.watched(&told, reference, dt, accept)?,
            Mode::Automatic(_) => self.decided(&told, reference, dt, accept)?,
        };
        self.offset = command.offset;
        self.last = Some((self.mode, command.u));
        Ok(command)
    }

    /// The mode and the operator's input are kept.
    fn reset(&mut self) {
        self.controller.reset();
        self.offset = SVector::zeros();
        self.last = None;
    }

    /// In automatic mode; an operator who has the say keeps it.
    fn set_learning(&mut self, mode: LearningMode) {
        if let Mode::Automatic(_) = self.mode {
            self.select(Mode::Automatic(mode));
        }
    }
}

checked! {
    [C, T: Scalar, const NU: usize] Supervised<C, T, NU>, [C, T]
    {
        controller: C,
        fade: SVector<T, NU>,
        mode: Mode,
        manual: SVector<T, NU>,
        offset: SVector<T, NU>,
        last: Option<(Mode, SVector<T, NU>)>,
    } =>
    positive_vector("fade", &fade).and_then(|()| {
        known("manual input and offset", manual.iter().chain(offset.iter()).copied())?;
        known("last u", last.iter().flat_map(|(_, last)| last.iter()).copied())?;
        Ok(Self { controller, fade, mode, manual, offset, last })
    })
}
