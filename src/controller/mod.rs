//! Controllers: from a measurement and a reference to an input, once a period.
//!
//! | controller | law | on |
//! |---|---|---|
//! | [`FeedbackLinearization`] | u = b⁻¹·(−a + u_f + u_b) (eq_ndi_controllaw) | a model in chain form |
//! | [`Clelc`] | u = b⁻¹·(−a + u_f + u_b + u_n) (eq_new_controllaw) | the same and a [compensator](crate::learning::Compensator) |
//! | [`Backstepping`] | the same with k·e from cᵢ > 0, and its Lyapunov function | a model in chain form |
//! | [`ModelReferenceAdaptive`] | u = b⁻¹·(−a + u_f + u_b + u_a), u_a learned from a reference model | a model in chain form, and φ(x) |
//! | [`SlidingModeControl`](sliding_mode::SlidingModeControl) | u = b⁻¹·(−a + u_f + u_b + k·sgn(σ)) | a model in chain form and a bound on \|Δ\| |
//! | [`SuperTwisting`](sliding_mode::SuperTwisting) | u = b⁻¹·(−a + u_f + u_b + k₁·\|σ\|^½·sgn(σ) + k₂·∫sgn(σ) dt) | the same and a bound on \|Δ̇\| |
//! | [`ActiveDisturbanceRejection`] | u = b₀⁻¹·(u_f + k·(r − z) − f̂), z and f̂ observed | x₁ and b₀, no model |
//! | [`Pid`] | u = K·(b·r − y) + I + D with anti-windup, bumpless | the output alone, no model |
//! | [`StateFeedback`] | u = u₀ + K·(r − x), K from an [LQR](lqr) or given | a linearization at an operating point |
//! | [`Compensated`] | u = u_base + b⁻¹·u_n | any of the above, a model and a compensator |
//! | [`Decoupling`] | u = B⁻¹·(−a + ν), νᵢ from one [controller a chain](ChainControllers) | several chains |
//! | [`Padded`] | any of them in a chain longer than its order | outputs of different relative degree |
//! | [`UnicycleController`](unicycle::UnicycleController) | the same with v̇ = ξ (eq_transformation) | the unicycle robot |
//! | [`Limited`] | any of them with an [actuator](crate::channel) behind it, told what arrived | any plant |
//! | [`InputOnly`] | any of them, telling its input alone, for a choice at run time | any plant |
//! | [`Supervised`] | any of them and an operator, who takes over and hands back without a bump | any plant |
//!
//! # Conventions
//! The error is **e = r − x**; gains are positive for negative feedback. A [`Controller`] is a state machine without a clock:
//! the same calls give the same outputs.
//!
//! `dt` is given at every call, in seconds, finite and > 0: the time since the call before (at the first call, the period that
//! the loop will run at). The output is meant to be held until the next call.
//!
//! Whatever a call returns as `Err`, it leaves the controller exactly as it was before. What a controller would remember and could not use at the
//! next sample without leaving the range of the scalar is refused at once: an outlier costs one call, not all that follow.
//!
//! A controller is a value: a copy of it is a snapshot, and assigning the copy restores it, to the last bit.
//!
//! This module depends on [`plant`](crate::plant) for models and on [`learning`](crate::learning) for compensators.

mod active_disturbance_rejection;
mod adaptive;
mod backstepping;
mod chain_controllers;
mod clelc;
mod compensated;
mod decoupling;
mod feedback_linearization;
mod gains;
mod input_only;
mod limited;
pub mod lqr;
mod measurement;
mod padded;
mod pid;
mod reference;
pub mod sliding_mode;
mod state_feedback;
mod supervised;
pub mod unicycle;

pub use active_disturbance_rejection::{
    ActiveDisturbanceRejection, ActiveDisturbanceRejectionCommand,
};
pub use adaptive::{
    Leakage, ModelReferenceAdaptive, ModelReferenceAdaptiveCommand, Projection, Regressor,
    StateRegressor,
};
pub use backstepping::{Backstepping, BacksteppingCommand};
pub use chain_controllers::{ChainControllers, Decided};
pub use clelc::{Clelc, ClelcCommand};
pub use compensated::{Compensated, CompensatedCommand};
pub use decoupling::{Decoupling, DecouplingCommand};
pub use feedback_linearization::{FeedbackLinearization, FeedbackLinearizationCommand};
pub use gains::Gains;
pub use input_only::InputOnly;
pub use limited::{Limited, LimitedCommand};
pub use measurement::Measurement;
pub use padded::Padded;
pub use pid::{AntiWindup, Pid, PidCommand, PidGains};
pub use reference::Reference;
pub use state_feedback::StateFeedback;
pub use supervised::{Mode, Supervised, SupervisedCommand};

use nalgebra::SVector;

use crate::{Error, Scalar, learning::LearningMode};

/// A sampled controller for plants with NX states and NU inputs.
pub trait Controller<const NX: usize, const NU: usize> {
    /// The number type of states and inputs.
    type Scalar: Scalar;
    /// What the plant is to follow, at one instant.
    type Reference;
    /// The input and how it came about.
    type Command: Command<Self::Scalar, NU>;

    /// The command for the coming period, from the measurement and the reference at its start, if `accept` has nothing against it. For `dt`
    /// see the [module](self).
    ///
    /// An implementation computes first, asks `accept` once when nothing else can fail, and changes itself last. So a wrapper can have the last
    /// word on a command without keeping a copy of the controller to go back to.
    ///
    /// # Errors
    /// For a bad `dt`, measurement or reference, where the law has no answer, and that of `accept`. The controller is then as before.
    fn update_if(
        &mut self,
        measurement: &Measurement<Self::Scalar, NX, NU>,
        reference: &Self::Reference,
        dt: Self::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error>;

    /// The command for the coming period: [`update_if`](Self::update_if) with nothing against it.
    ///
    /// # Errors
    /// Those of `update_if`. The controller is then as before.
    fn update(
        &mut self,
        measurement: &Measurement<Self::Scalar, NX, NU>,
        reference: &Self::Reference,
        dt: Self::Scalar,
    ) -> Result<Self::Command, Error> {
        self.update_if(measurement, reference, dt, &mut |_| Ok(()))
    }

    /// Back to the state after construction: memory and everything learned is forgotten, parameters are kept.
    fn reset(&mut self);

    /// Freezes or thaws what the controller learns, or takes it out of the input, from the next call on. A wrapper passes this on; a controller
    /// that learns nothing has nothing to do.
    fn set_learning(&mut self, mode: LearningMode) {
        let _ = mode;
    }
}

impl<C: Controller<NX, NU> + ?Sized, const NX: usize, const NU: usize> Controller<NX, NU>
    for &mut C
{
    type Scalar = C::Scalar;
    type Reference = C::Reference;
    type Command = C::Command;

    fn update_if(
        &mut self,
        measurement: &Measurement<C::Scalar, NX, NU>,
        reference: &C::Reference,
        dt: C::Scalar,
        accept: Accept<C::Command>,
    ) -> Result<C::Command, Error> {
        (**self).update_if(measurement, reference, dt, accept)
    }

    fn reset(&mut self) {
        (**self).reset();
    }

    fn set_learning(&mut self, mode: LearningMode) {
        (**self).set_learning(mode);
    }
}

/// The judgement of a caller on the command that a [controller](Controller::update_if) is about to give.
pub type Accept<'a, D> = &'a mut dyn FnMut(&D) -> Result<(), Error>;

/// What a controller decided: an input, and perhaps how it came about.
pub trait Command<T, const NU: usize>: Copy {
    /// The input u for the plant.
    fn input(&self) -> SVector<T, NU>;
}

/// The plain input, for a controller with nothing more to say.
impl<T: Scalar, const NU: usize> Command<T, NU> for SVector<T, NU> {
    fn input(&self) -> SVector<T, NU> {
        *self
    }
}
