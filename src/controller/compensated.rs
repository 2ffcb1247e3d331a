use nalgebra::SVector;

use super::{
    Accept, Command, Controller, Measurement, Reference, feedback_linearization::closed_loop,
};
use crate::{
    Error, Scalar,
    error::{finite, value},
    learning::{ClosedLoop, Compensation, Compensator, LearningMode},
    plant::FeedbackLinearizable,
};

/// Any controller with any compensator on top: u = u_base + b(x)⁻¹·u_n.
///
/// To the compensator the base is the feedback, whatever its law: u_b = a(x) + b(x)·u_base − u_f, with u_f = ṙ_n, is what it asks of ẋ_n beyond the
/// feedforward. So ė_n = −u_b − u_n − Δ, and
///
/// s = ė_n + u_b = −(u_n + Δ)
///
/// as in [`Clelc`](super::Clelc): a PID, LQR or sliding-mode controller learns from the same s, with the same certificates. Once s = 0 the loop
/// is that of the base on the plant that the model describes. Around feedback linearization it is `Clelc`, to rounding.
///
/// * The model may be rough, as long as b has the right sign and size: what it lacks is Δ, and learned. The base need not know it.
/// * Where u_n = 0, in [`LearningMode::Off`] say, the input is that of the base, bit for bit, and b(x) = 0 does no harm.
/// * A base that integrates the error learns a steady Δ too, only slower; what u_n has taken over, its integral gives back.
///
/// # What the base is told
/// An applied input is reported to it less the share of u_n: u_base + (u_arrived − u). As long as all arrives, that is just what it asked for, to
/// the last bit, so its anti-windup does not take u_n for an actuator that disobeys. Of a saturated actuator it sees what u_n left for it, and
/// winds back by all that is missing; the compensator sees the whole input. ẋ is passed on as measured: with its own share of the input the base
/// sees u_n + Δ as the uncertainty, which is what is left for it to do.
///
/// Assumes b(x) ≠ 0 where there is something learned.
///
/// ```
/// use brunovsky::{controller::{Compensated, sliding_mode::{SlidingModeControl, SlidingSurface}}, plant::IntegratorChain, prelude::*};
///
/// let model = IntegratorChain::<f64, 2>::new();
/// let base = SlidingModeControl::new(model, SlidingSurface::from_lambda(2.0)?, 1.0)?;
/// let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([1.0, 1.0])?;
/// let learner = NeuroFuzzy::new(network, ModelAided::new(), SlidingMode::new(5.0)?);
/// let mut controller = Compensated::new(base, model, learner);
/// let command = controller.update(&Measurement::new([0.0, 0.0]), &Reference::setpoint(1.0), 0.01)?;
/// assert_eq!(command.u, command.base.u);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compensated<C, P: FeedbackLinearizable<N>, K, const N: usize> {
    base: C,
    model: P,
    compensator: K,
    initial: K,
    last: Option<Inputs<P::Scalar>>,
    learning: LearningMode,
}

/// The inputs of a sample: that of the base, and the whole.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Inputs<T> {
    base: T,
    u: T,
}

/// An input of [`Compensated`], its shares, and what was learned from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CompensatedCommand<D, T> {
    /// The input u, in the plant's units.
    pub u: T,
    /// What the base decided.
    pub base: D,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// What the base asks beyond it, u_b = a(x) + b(x)·u_base − u_f, in the units of ẋ_n.
    pub u_b: T,
    /// The learned term u_n, in the units of ẋ_n.
    pub u_n: T,
    /// The sliding variable s = ė_n + u_b, in the units of ẋ_n.
    pub s: T,
}

impl<D: Copy, T: Scalar> Command<T, 1> for CompensatedCommand<D, T> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

impl<C, P, K, const N: usize> Compensated<C, P, K, N>
where
    C: Controller<N, 1, Scalar = P::Scalar, Reference = Reference<P::Scalar, N>>,
    P: FeedbackLinearizable<N>,
    K: Compensator<P::Scalar, N>,
{
    /// `base` with `compensator` in parallel, which knows the plant as `model`.
    pub fn new(base: C, model: P, compensator: K) -> Self {
        let learning = LearningMode::Active;
        Self { base, model, initial: compensator.clone(), compensator, last: None, learning }
    }

    /// The controller inside.
    pub fn base(&self) -> &C {
        &self.base
    }

    /// The controller inside, to be changed. Its learning mode is that of this one.
    pub fn base_mut(&mut self) -> &mut C {
        &mut self.base
    }

    /// The model.
    pub fn model(&self) -> &P {
        &self.model
    }

    /// The compensator as it stands.
    pub fn compensator(&self) -> &K {
        &self.compensator
    }

    /// The compensator as it stands, to be changed; [`reset`](Controller::reset) goes back to the one given to [`new`](Self::new).
    pub fn compensator_mut(&mut self) -> &mut K {
        &mut self.compensator
    }
}

impl<C, P, K, const N: usize> Controller<N, 1> for Compensated<C, P, K, N>
where
    C: Controller<N, 1, Scalar = P::Scalar, Reference = Reference<P::Scalar, N>>,
    P: FeedbackLinearizable<N>,
    K: Compensator<P::Scalar, N>,
{
    type Scalar = P::Scalar;
    type Reference = Reference<P::Scalar, N>;
    type Command = CompensatedCommand<C::Command, P::Scalar>;

    /// # Errors
    /// Those of the base and of the compensator; [`Error::NonFinite`] for a(x), b(x), u_b and u; [`Error::Singular`] where b(x) is zero or so
    /// small that u_n has no finite input.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let (zero, learning) = (nalgebra::zero(), self.learning);
        let last = self.last.unwrap_or(Inputs { base: zero, u: zero });
        let at = closed_loop(&self.model, |_| zero, measurement, reference, dt, last.u, learning)?;
        let share = |u: SVector<P::Scalar, 1>| SVector::from([last.base + (u[0] - last.u)]);
        let told = Measurement { applied: measurement.applied.map(share), ..*measurement };
        let mut decided = Err(Error::Missing { name: "command of the base" });
        self.base.update_if(&told, reference, dt, &mut |base| {
            let u_base = base.input()[0];
            let at = ClosedLoop { u_b: finite("u_b", at.drift + at.gain * u_base - at.u_f)?, ..at };
            let mut command = None;
            self.compensator.advance_if(&at, dt, &mut |&Compensation { u_n, s }| {
                let u = added(u_base, u_n, at.gain)?;
                let whole = CompensatedCommand { u, base: *base, u_f: at.u_f, u_b: at.u_b, u_n, s };
                accept(&whole)?;
                command = Some(whole);
                Ok(())
            })?;
            decided = command.ok_or(Error::Missing { name: "term of the compensator" });
            Ok(())
        })?;
        let command = decided?;
        self.last = Some(Inputs { base: command.base.input()[0], u: command.u });
        Ok(command)
    }

    fn reset(&mut self) {
        self.base.reset();
        self.compensator = self.initial.clone();
        self.last = None;
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.learning = mode;
        self.base.set_learning(mode);
    }
}

/// u_base + u_n/b; just u_base, whatever b and the signs of zeros are, where nothing is to be added.
fn added<T: Scalar>(u_base: T, u_n: T, gain: T) -> Result<T, Error> {
    if u_n.is_zero() {
        return finite("u", u_base);
    }
    let share = u_n / gain;
    if !share.is_finite() {
        return Err(Error::Singular { name: "b(x)", value: value(gain) });
    }
    finite("u", u_base + share)
}

checked! {
    [T: Scalar] Inputs<T>, [T] { base: T, u: T } =>
    known("last u", [base, u]).map(|()| Self { base, u })
}

checked! {
    [C, P: FeedbackLinearizable<N>, K, const N: usize] Compensated<C, P, K, N>,
    [C, P, K, P::Scalar]
    {
        base: C,
        model: P,
        compensator: K,
        initial: K,
        last: Option<Inputs<P::Scalar>>,
        learning: LearningMode,
    } =>
    Ok(Self { base, model, compensator, initial, last, learning })
}
