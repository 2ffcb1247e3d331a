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
//! # From equations to a controller
//!
//! 1. **Write the equations**, or take a named plant. A [`SmoothPlant`] gives f, g and h once, over any number; nothing is derived by hand.
//! 2. **Ask for the relative degree**, the N for which the N-th derivative of the output is the first that the input acts on: at the operating
//!    point, and over the box of states that the plant will be in. Where it is not defined, feedback linearization has no law. What its sum
//!    lacks to NX are zero dynamics, which the controller neither sees nor stabilizes: they have to be stable by themselves.
//! 3. **Linearize**: [`SmoothPlant::linearized`], or [`Linearized::with_degrees`] for outputs of different degrees.
//! 4. **Control the chains** by [`Decoupling`](crate::controller::Decoupling), with feedback linearization or CLELC on each; the gains
//!    place the poles of each output.
//! 5. **Simulate on another plant** than the model: the same type with other parameters, or [`Uncertain`]. Errors of the last equation of z are
//!    learned. Others are not: z is computed from x by the model, so a wrong parameter that stands in z itself makes the loop follow
//!    another output than the true one (the sixth example shows how far).
//!
//! ```
//! use brunovsky::{
//!     controller::Decoupling,
//!     plant::{BoxSamples, Electromagnet, IntegratorChain, MagneticLevitation, SmoothPlant},
//!     prelude::*,
//! };
//!
//! let magnet = Electromagnet { far: 0.02, near: 0.01, range: 0.05, resistance: 1.0 };
//! let ball = MagneticLevitation::<f64>::new(0.1, 0.001, 9.81, magnet)?;
//! let (floating, _) = ball.equilibrium(0.05);
//!
//! let at = ball.relative_degree(floating)?;
//! assert_eq!((at.degrees, at.zero_dynamics()), ([3], 0));
//! let box_of_states = BoxSamples::new([0.01, -1.0, 0.5], [0.1, 1.0, 8.0])?;
//! assert!(ball.relative_degree_over(box_of_states.take(1000))?.is_uniform());
//!
//! let model = ball.linearized::<3>(floating)?;
//! let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(30.0)?);
//! let network = FuzzyNetwork::<_, 3, 2>::evenly_spaced([0.01, 0.3, 10.0])?;
//! let learner = NeuroFuzzy::new(network, ModelAided::new(), SlidingMode::new(1e5)?);
//! let controller = Decoupling::new(model, [Clelc::new(flc, learner)]);
//!
//! // A coil that has become warm, and with that a voltage that does not arrive: an error of the last equation.
//! let warm = Electromagnet { resistance: 1.3, ..magnet };
//! let truth = MagneticLevitation::new(0.1, 0.001, 9.81, warm)?;
//! let goal = |_| [Reference::setpoint(0.06)];
//! let run = Simulation::new(&truth, controller, goal, floating, 0.001)?;
//! let last = run.until(2.0)?.last().ok_or(Error::Missing { name: "sample" })??;
//! assert!((last.x[0] - 0.06).abs() < 1e-6);
//! # Ok::<(), Error>(())
//! ```
//!
//! All of it runs on numbers with derivatives too, also on those of another crate: the seventh example differentiates a whole run by its gains.
//!
//! # Named plants
//!
//! | plant | NX | input | output | relative degree |
//! |---|---|---|---|---|
//! | [`IntegratorChain`] | N | ν | x₁ | N |
//! | [`Pendulum`], [`VanDerPol`], [`Duffing`] | 2 | torque, force | angle, position | 2, in chain form |
//! | [`ThirdOrder`] | 3 | u | x₁ | 3, in chain form |
//! | [`FlexibleJoint`] | 4 | torque of the motor | angle of the link | 4 |
//! | [`MotorDrivenLink`] | 3 | voltage | angle | 3 |
//! | [`MagneticLevitation`] | 3 | voltage | distance | 3 under current, none without |
//! | [`CartPole`] | 4 | force | position or angle | 2, with zero dynamics: stable, unstable or drifting |
//! | [`BallAndBeam`] | 4 | acceleration of the beam | position of the ball | 3 in motion, none at rest |
//! | [`TwoLinkArm`] | 4 | torques | angles of the joints | (2, 2) |
//! | [`Unicycle`] | 4 | acceleration, yaw rate | position | (2, 2) in motion, none at rest |
//! | [`QuadrotorAttitude`] | 6 | torques | roll, pitch, yaw | (2, 2, 2) below ±π/2 of pitch |
//! | [`Quadrotor`] | 14 | F̈, torques | position, yaw | (4, 4, 4, 2) under thrust |
//! | [`TrackedRobot`] | 5 | commanded speed, yaw rate | – | a plant to simulate only |
//!
//! All but the last are `SmoothPlant` or `FeedbackLinearizable`, and plants to simulate as they stand: model, truth and chain are
//! three uses of one value. The last three columns are those of `SmoothPlant`.
//!
//! # Conventions
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
