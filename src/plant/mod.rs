//! Plants: what is controlled, as three rungs of one ladder.
//!
//! | rung | law | a plant on it gives |
//! |---|---|---|
//! | [`FeedbackLinearizable<N>`] | ẋᵢ = xᵢ₊₁, ẋ_n = a(x) + b(x)·u | drift a(x), input gain b(x) |
//! | [`ControlAffine<NX, NU>`] | ẋ = f(x) + g(x)·u | drift field f(x), input fields g(x) |
//! | [`Plant<NX, NU>`] | ẋ = F(t, x, u) | the derivative F |
//!
//! A plant implements the highest rung that fits and has the ones below it for free. A controller asks for the rung it
//! needs of its *model*; a [simulation](crate::simulation) asks only for a [`Plant`]. The true plant and the model may
//! differ: other parameters of the same type, or a plant wrapped in [`Uncertain`].
//!
//! Beside the ladder stands [`Decouplable<NX, N, M>`](Decouplable): several inputs, several chains. A plant that is not in chain form is a
//! [`SmoothPlant<NX, M>`](SmoothPlant): it gives its equations f, g and h, and [`Linearized`] is `Decouplable` with the derivatives of them.
//!
//! States are column vectors `SVector<T, NX>` counted from 0 (so x₁ of the literature is `x[0]`), inputs
//! `SVector<T, NU>`, time is in seconds. Each plant states its units.
//!
//! This module depends on nothing but [`Scalar`] and [`differentiation`](crate::differentiation).

mod ball_and_beam;
mod cart_pole;
mod decouplable;
mod duffing;
mod flexible_joint;
mod integrator_chain;
mod magnetic_levitation;
mod motor_driven_link;
mod pendulum;
mod quadrotor;
mod smooth;
mod third_order;
mod tracked_robot;
mod two_link_arm;
mod uncertain;
mod unicycle;
mod van_der_pol;

pub use ball_and_beam::BallAndBeam;
pub use cart_pole::{CartPole, CartPoleOutput};
pub use decouplable::{Decouplable, Linearization};
pub use duffing::Duffing;
pub use flexible_joint::FlexibleJoint;
pub use integrator_chain::IntegratorChain;
pub use magnetic_levitation::{Electromagnet, MagneticLevitation};
pub use motor_driven_link::{DcMotor, MotorDrivenLink};
pub use pendulum::Pendulum;
pub use quadrotor::{Quadrotor, QuadrotorAttitude};
pub use smooth::{
    Along, BoxSamples, Flow, Jacobians, LieDerivatives, Linearized, RelativeDegree, SmoothPlant,
};
pub use third_order::ThirdOrder;
pub use tracked_robot::{TrackedRobot, Traction};
pub use two_link_arm::{Link, TwoLinkArm};
pub use uncertain::{Matched, Uncertain, Uncertainty};
pub use unicycle::Unicycle;
pub use van_der_pol::VanDerPol;

use nalgebra::{SMatrix, SVector};
use num_traits::Zero;

use crate::Scalar;

/// A chain of `N` integrators driven by a(x) + b(x)·u: ẋᵢ = xᵢ₊₁ for i < N, ẋ_n = a(x) + b(x)·u (eq_nonlinearsystem, Δ = 0).
///
/// The input u = b(x)⁻¹·(−a(x) + ν) turns it into the pure chain x₁⁽ᴺ⁾ = ν, wherever b(x) ≠ 0.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a plant of the kind needed here",
    label = "not a feedback-linearizable plant of order {N}, nor a plant on a lower rung with these sizes",
    note = "implement the highest rung that fits, with the sizes asked for here:",
    note = "  `FeedbackLinearizable<N>`    x1' = x2, ..., xn' = a(x) + b(x) u: `drift` and `input_gain`",
    note = "  `ControlAffine<NX, NU>`      x' = f(x) + g(x) u: `drift_field` and `input_fields`",
    note = "  `Plant<NX, NU>`              x' = F(t, x, u): `derivative`",
    note = "a feedback-linearizing controller needs the first; a simulation accepts all three"
)]
pub trait FeedbackLinearizable<const N: usize> {
    /// The number type of states and inputs.
    type Scalar: Scalar;

    /// The drift a(x): ẋ_n without input.
    fn drift(&self, x: &SVector<Self::Scalar, N>) -> Self::Scalar;

    /// The input gain b(x) = ∂ẋ_n/∂u.
    fn input_gain(&self, x: &SVector<Self::Scalar, N>) -> Self::Scalar;
}

/// A plant whose input enters linearly: ẋ = f(x) + g(x)·u.
pub trait ControlAffine<const NX: usize, const NU: usize> {
    /// The number type of states and inputs.
    type Scalar: Scalar;

    /// The drift field f(x): ẋ without input.
    fn drift_field(&self, x: &SVector<Self::Scalar, NX>) -> SVector<Self::Scalar, NX>;

    /// The input fields g(x): column j is ∂ẋ/∂uⱼ.
    fn input_fields(&self, x: &SVector<Self::Scalar, NX>) -> SMatrix<Self::Scalar, NX, NU>;
}

/// A plant in its most general form: ẋ = F(t, x, u).
pub trait Plant<const NX: usize, const NU: usize> {
    /// The number type of states and inputs.
    type Scalar: Scalar;

    /// The derivative ẋ = F(t, x, u) at time `t` in seconds.
    fn derivative(
        &self,
        t: Self::Scalar,
        x: &SVector<Self::Scalar, NX>,
        u: &SVector<Self::Scalar, NU>,
    ) -> SVector<Self::Scalar, NX>;
}

impl<P: FeedbackLinearizable<N>, const N: usize> ControlAffine<N, 1> for P {
    type Scalar = P::Scalar;

    fn drift_field(&self, x: &SVector<P::Scalar, N>) -> SVector<P::Scalar, N> {
        let chain = SVector::from_fn(|i, _| x.get(i + 1).copied().unwrap_or(P::Scalar::zero()));
        chain + last_axis(self.drift(x))
    }

    fn input_fields(&self, x: &SVector<P::Scalar, N>) -> SMatrix<P::Scalar, N, 1> {
        last_axis(self.input_gain(x))
    }
}

impl<P: ControlAffine<NX, NU>, const NX: usize, const NU: usize> Plant<NX, NU> for P {
    type Scalar = P::Scalar;

    fn derivative(
        &self,
        _t: P::Scalar,
        x: &SVector<P::Scalar, NX>,
        u: &SVector<P::Scalar, NU>,
    ) -> SVector<P::Scalar, NX> {
        self.drift_field(x) + self.input_fields(x) * u
    }
}

impl<P: FeedbackLinearizable<N> + ?Sized, const N: usize> FeedbackLinearizable<N> for &P {
    type Scalar = P::Scalar;

    fn drift(&self, x: &SVector<P::Scalar, N>) -> P::Scalar {
        (**self).drift(x)
    }

    fn input_gain(&self, x: &SVector<P::Scalar, N>) -> P::Scalar {
        (**self).input_gain(x)
    }
}

/// (0, …, 0, `value`): what enters a chain at its end.
fn last_axis<T: Scalar, const N: usize>(value: T) -> SVector<T, N> {
    SVector::from_fn(|i, _| if i + 1 == N { value } else { T::zero() })
}
