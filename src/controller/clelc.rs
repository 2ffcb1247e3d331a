use nalgebra::SVector;

use super::{
    Accept, Command, Controller, FeedbackLinearization, Measurement, Reference,
    feedback_linearization::linearizing,
};
use crate::{
    Error, Scalar,
    learning::{ClosedLoop, Compensation, Compensator, LearningMode},
    plant::FeedbackLinearizable,
};

/// Closed-loop error learning control: u = b(x)⁻¹·(−a(x) + u_f + u_b + u_n) (eq_new_controllaw).
///
/// [`FeedbackLinearization`] with a [`Compensator`] in parallel, whose u_n learns −Δ from s = ė_n + u_b and leaves the feedback
/// with nothing to do.
///
/// * Without uncertainty, from u_n = 0 and with the exact ė_n, s ≡ 0: the loop is that of feedback linearization, which learning
///   neither improves nor harms.
/// * With |Δ̇| ≤ B < α, s reaches zero in finite time (see [`Certificate`](crate::learning::Certificate)), and then
///   ė_n + u_b = 0 holds as if the model were right.
/// * With the [`NullCompensator`](crate::learning::NullCompensator) it is feedback linearization, bit for bit.
///
/// Assumes what feedback linearization assumes. Where the actuator may saturate, learn from
/// [`ModelAided`](crate::learning::ModelAided) and have the applied input reported, by the measurement or by
/// [`Limited`](super::Limited): a plain difference winds u_n up.
///
/// # References
/// E. Kayacan, "Closed-loop error learning control for uncertain nonlinear systems with experimental validation on a
/// mobile robot", IEEE/ASME Transactions on Mechatronics 24(5), 2019.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clelc<P: FeedbackLinearizable<N>, C, const N: usize> {
    base: FeedbackLinearization<P, N>,
    compensator: C,
    initial: C,
    last: P::Scalar,
    learning: LearningMode,
}

/// An input of [`Clelc`], its shares, and what was learned from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClelcCommand<T> {
    /// The input u, in the plant's units.
    pub u: T,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// The feedback u_b = k·e, in the units of ẋ_n.
    pub u_b: T,
    /// The learned term u_n, in the units of ẋ_n.
    pub u_n: T,
    /// The sliding variable s = ė_n + u_b, in the units of ẋ_n.
    pub s: T,
}

impl<T: Scalar> Command<T, 1> for ClelcCommand<T> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

impl<P: FeedbackLinearizable<N>, C: Compensator<P::Scalar, N>, const N: usize> Clelc<P, C, N> {
    /// `base` with `compensator` in parallel.
    pub fn new(base: FeedbackLinearization<P, N>, compensator: C) -> Self {
        Self {
            base,
            initial: compensator.clone(),
            compensator,
            last: nalgebra::zero(),
            learning: LearningMode::Active,
        }
    }

    /// The feedback linearization inside.
    pub fn base(&self) -> &FeedbackLinearization<P, N> {
        &self.base
    }

    /// The compensator as it stands.
    pub fn compensator(&self) -> &C {
        &self.compensator
    }

    /// The compensator as it stands, to be changed; [`reset`](Controller::reset) goes back to the one given to [`new`](Self::new).
    pub fn compensator_mut(&mut self) -> &mut C {
        &mut self.compensator
    }
}

impl<P: FeedbackLinearizable<N>, C: Compensator<P::Scalar, N>, const N: usize> Controller<N, 1>
    for Clelc<P, C, N>
{
    type Scalar = P::Scalar;
    type Reference = Reference<P::Scalar, N>;
    type Command = ClelcCommand<P::Scalar>;

    /// # Errors
    /// Those of [`FeedbackLinearization`], and those of the compensator: [`Error::Missing`] if ė_n cannot be had,
    /// [`Error::NonFinite`] if s or u_n would leave the range of the scalar.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let at = self.base.closed_loop(measurement, reference, dt, self.last, self.learning)?;
        let command = |u, Compensation { u_n, s }: Compensation<_>| {
            let ClosedLoop { u_f, u_b, .. } = at;
            ClelcCommand { u, u_f, u_b, u_n, s }
        };
        let mut u = nalgebra::zero();
        let compensation = self.compensator.advance_if(&at, dt, &mut |compensation| {
            u = linearizing(&at, at.u_f + at.u_b + compensation.u_n)?;
            accept(&command(u, *compensation))
        })?;
        self.last = u;
        Ok(command(u, compensation))
    }

    fn reset(&mut self) {
        self.compensator = self.initial.clone();
        self.last = nalgebra::zero();
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.learning = mode;
    }
}

checked! {
    [P: FeedbackLinearizable<N>, C, const N: usize] Clelc<P, C, N>, [P, C, P::Scalar]
    {
        base: FeedbackLinearization<P, N>,
        compensator: C,
        initial: C,
        last: P::Scalar,
        learning: LearningMode,
    } =>
    known("last u", [last]).map(|()| Self { base, compensator, initial, last, learning })
}
