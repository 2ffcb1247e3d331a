use nalgebra::SVector;

use super::{Accept, Command, Controller, Gains, Measurement, Reference};
use crate::{
    Error, Scalar,
    error::{finite, positive, value},
    learning::{ClosedLoop, LearningMode},
    plant::FeedbackLinearizable,
};

/// Feedback linearization control: u = b(x)⁻¹·(−a(x) + u_f + u_b) with u_b = k·e, u_f = ṙ_n (eq_ndi_controllaw, eq_fb, eq_ff).
///
/// If the plant is the model, the loop becomes ė_n + k_n·e_n + … + k₁·e₁ = 0. An uncertainty Δ appears on the right-hand side as −Δ
/// and leaves a steady error of −Δ/k₁ (eq_ndi_error).
///
/// Assumes b(x) ≠ 0 and a reference that is N times differentiable. It has no memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeedbackLinearization<P: FeedbackLinearizable<N>, const N: usize> {
    model: P,
    gains: Gains<P::Scalar, N>,
}

/// An input of [`FeedbackLinearization`] and its shares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeedbackLinearizationCommand<T> {
    /// The input u, in the plant's units.
    pub u: T,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// The feedback u_b = k·e, in the units of ẋ_n.
    pub u_b: T,
}

impl<T: Scalar> Command<T, 1> for FeedbackLinearizationCommand<T> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

impl<P: FeedbackLinearizable<N>, const N: usize> FeedbackLinearization<P, N> {
    /// A controller for the plant that `model` describes.
    pub const fn new(model: P, gains: Gains<P::Scalar, N>) -> Self {
        Self { model, gains }
    }

    /// The model that the law inverts.
    pub const fn model(&self) -> &P {
        &self.model
    }

    /// The feedback gains.
    pub const fn gains(&self) -> &Gains<P::Scalar, N> {
        &self.gains
    }

    /// The parts of the law at one sample, checked; `last` is the input of the period before, `learning` for a compensator.
    pub(super) fn closed_loop(
        &self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Reference<P::Scalar, N>,
        dt: P::Scalar,
        last: P::Scalar,
        learning: LearningMode,
    ) -> Result<ClosedLoop<P::Scalar, N>, Error> {
        let feedback = |e: &_| self.gains.feedback(e);
        closed_loop(&self.model, feedback, measurement, reference, dt, last, learning)
    }
}

/// The parts of a law with u_b = `feedback`(e) at one sample, checked.
pub(super) fn closed_loop<P: FeedbackLinearizable<N>, const N: usize>(
    model: &P,
    feedback: impl FnOnce(&SVector<P::Scalar, N>) -> P::Scalar,
    measurement: &Measurement<P::Scalar, N, 1>,
    reference: &Reference<P::Scalar, N>,
    dt: P::Scalar,
    last: P::Scalar,
    learning: LearningMode,
) -> Result<ClosedLoop<P::Scalar, N>, Error> {
    positive("dt", dt)?;
    measurement.validate()?;
    reference.validate()?;
    let x = measurement.x;
    let e = reference.r - x;
    Ok(ClosedLoop {
        x,
        e,
        u_f: reference.r_n_dot,
        u_b: finite("u_b", feedback(&e))?,
        drift: finite("a(x)", model.drift(&x))?,
        gain: finite("b(x)", model.input_gain(&x))?,
        u: measurement.applied.map_or(last, |applied| applied[0]),
        asked: last,
        rate: measurement.x_dot.map(|x_dot| x_dot[N - 1]),
        learning,
    })
}

/// u = b⁻¹·(−a + ν): the input for which the model's ẋ_n is ν.
pub(super) fn linearizing<T: Scalar, const N: usize>(
    at: &ClosedLoop<T, N>,
    nu: T,
) -> Result<T, Error> {
    let u = (nu - at.drift) / at.gain;
    if u.is_finite() {
        Ok(u)
    } else {
        // ν and a are finite: either they overflow on their own, or b is too small for them.
        finite("-a(x) + nu", nu - at.drift)?;
        Err(Error::Singular { name: "b(x)", value: value(at.gain) })
    }
}

impl<P: FeedbackLinearizable<N>, const N: usize> Controller<N, 1> for FeedbackLinearization<P, N> {
    type Scalar = P::Scalar;
    type Reference = Reference<P::Scalar, N>;
    type Command = FeedbackLinearizationCommand<P::Scalar>;

    /// # Errors
    /// [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] and [`Error::NonFiniteEntry`] for the measurement, the reference,
    /// a(x), b(x) and u_b; [`Error::Singular`] where b(x) is zero or so small that u is not finite.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let at =
            self.closed_loop(measurement, reference, dt, nalgebra::zero(), LearningMode::Off)?;
        let (u_f, u_b) = (at.u_f, at.u_b);
        let u = linearizing(&at, u_f + u_b)?;
        let command = FeedbackLinearizationCommand { u, u_f, u_b };
        accept(&command)?;
        Ok(command)
    }

    fn reset(&mut self) {}
}

checked! {
    [P: FeedbackLinearizable<N>, const N: usize] FeedbackLinearization<P, N>, [P, P::Scalar]
    { model: P, gains: Gains<P::Scalar, N> } =>
    Ok(Self { model, gains })
}
