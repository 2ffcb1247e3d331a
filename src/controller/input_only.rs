use nalgebra::SVector;

use super::{Accept, Command, Controller, Measurement};
use crate::{Error, learning::LearningMode};

/// A controller of whose command nothing but the input is told, so that controllers of all kinds are of one type behind a `dyn`:
///
/// ```
/// use brunovsky::{controller::InputOnly, plant::Pendulum, prelude::*};
///
/// type Any<'a> = &'a mut dyn Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>, Command = SVector<f64, 1>>;
///
/// let model = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
/// let mut pid = InputOnly(Pid::new(PidGains::new(20.0)?.with_derivative_time(0.2, 0.02)?, AntiWindup::None)?);
/// let mut flc = InputOnly(FeedbackLinearization::new(model, Gains::from_lambda(4.0)?));
/// let choice: [Any; 2] = [&mut pid, &mut flc];
/// for controller in choice {
///     let run = Simulation::new(&model, controller, |_| Reference::setpoint(0.1), [0.0, 0.0], 0.01)?;
///     let last = run.until(5.0)?.last().ok_or(Error::Missing { name: "sample" })??;
///     assert!((last.x[0] - 0.1).abs() < 0.05);
/// }
/// # Ok::<(), Error>(())
/// ```
///
/// The input is that of the controller inside, bit for bit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct InputOnly<C>(
    /// The controller inside.
    pub C,
);

impl<C: Controller<NX, NU>, const NX: usize, const NU: usize> Controller<NX, NU> for InputOnly<C> {
    type Scalar = C::Scalar;
    type Reference = C::Reference;
    type Command = SVector<C::Scalar, NU>;

    /// # Errors
    /// Those of the controller inside.
    fn update_if(
        &mut self,
        measurement: &Measurement<C::Scalar, NX, NU>,
        reference: &C::Reference,
        dt: C::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let accept = &mut |command: &C::Command| accept(&command.input());
        self.0.update_if(measurement, reference, dt, accept).map(|command| command.input())
    }

    fn reset(&mut self) {
        self.0.reset();
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.0.set_learning(mode);
    }
}
