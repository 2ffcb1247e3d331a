//! Plants that are given by their equations, and what differentiation finds out about them.
//!
//! | from ẋ = f(x) + g(x)·u, y = h(x) | |
//! |---|---|
//! | [`Linearized`] | the chain form z = (h, L_f h, …), a = L_f^N h, B = L_g L_f^{N−1} h, for controllers and simulations |
//! | [`RelativeDegree`] | the N for which there is one: at a state, along a trajectory, over a box of [`BoxSamples`] |
//! | [`Jacobians`] | A, B, C near an operating point |
//! | [`Flow`] | the Lie derivatives themselves |

mod box_samples;
mod flow;
mod jacobians;
mod ladder;
mod linearized;
mod relative_degree;

pub use box_samples::BoxSamples;
pub use flow::{Along, Flow, LieDerivatives};
pub use jacobians::Jacobians;
pub(super) use ladder::control_affine;
pub use linearized::Linearized;
pub use relative_degree::RelativeDegree;

use nalgebra::SVector;

use crate::{Error, Scalar, differentiation::Smooth};

/// A plant with M inputs and as many outputs, by its equations: ẋ = f(x) + g(x)·u, y = h(x).
///
/// They are written once, for any number `S` that is [`Smooth`] over the plant's own, and run on plain numbers as on those that carry
/// derivatives. From them follow the chain form ([`linearized`](Self::linearized)), the relative degree and the Jacobians.
///
/// A law of order N runs f on N jets of 1 to N entries, so its cost grows with N³ at most. Marked `#[inline]`, f, g and h become one piece of
/// straight code with it, in which nothing is computed twice: a sine in f costs one sine, whatever the order.
///
/// # Example
/// A link that is driven through a spring; its angle q is to follow a reference. The motor acts on the fourth derivative of q:
///
/// ```
/// use brunovsky::{differentiation::Smooth, plant::{IntegratorChain, SmoothPlant}, prelude::*};
///
/// /// I·q̈ = −m·g·l·sin q − k·(q − θ), J·θ̈ = k·(q − θ) + u. State (q, q̇, θ, θ̇) in rad and rad/s, input u in N·m.
/// struct FlexibleJoint {
///     link: f64,      // I in kg·m²
///     motor: f64,     // J in kg·m²
///     weight: f64,    // m·g·l in N·m
///     stiffness: f64, // k in N·m/rad
/// }
///
/// impl SmoothPlant<4, 1> for FlexibleJoint {
///     type Scalar = f64;
///     #[inline]
///     fn drift_field<S: Smooth>(&self, [q, q_dot, theta, theta_dot]: [S; 4]) -> [S; 4] {
///         let spring = (q - theta) * self.stiffness;
///         let weight = q.sin() * self.weight;
///         [q_dot, -(weight + spring) / self.link, theta_dot, spring / self.motor]
///     }
///     fn input_fields<S: Smooth>(&self, _: [S; 4]) -> [[S; 4]; 1] {
///         [[0.0, 0.0, 0.0, 1.0 / self.motor].map(S::from)]
///     }
///     fn outputs<S: Smooth>(&self, [q, ..]: [S; 4]) -> [S; 1] {
///         [q]
///     }
/// }
///
/// let joint = FlexibleJoint { link: 1.0, motor: 0.3, weight: 10.0, stiffness: 100.0 };
/// let plant = joint.linearized::<4>([0.0; 4])?;
///
/// let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(5.0)?);
/// let controller = Decoupling::new(&plant, [flc]);
/// let reference = |_| [Reference::setpoint(1.0)];
/// let run = Simulation::new(&plant, controller, reference, [0.0; 4], 0.001)?;
/// let last = run.until(4.0)?.last().ok_or(Error::Missing { name: "sample" })??;
/// assert!((last.x[0] - 1.0).abs() < 1e-4);
/// # Ok::<(), Error>(())
/// ```
pub trait SmoothPlant<const NX: usize, const M: usize>: Sized {
    /// The number type of states, inputs and parameters.
    type Scalar: Scalar;

    /// The drift field f(x): ẋ without input.
    fn drift_field<S: Smooth<Self::Scalar>>(&self, x: [S; NX]) -> [S; NX];

    /// The input fields g₁(x), …, g_M(x): the j-th is ∂ẋ/∂uⱼ.
    fn input_fields<S: Smooth<Self::Scalar>>(&self, x: [S; NX]) -> [[S; NX]; M];

    /// The outputs h₁(x), …, h_M(x): what is to follow references.
    fn outputs<S: Smooth<Self::Scalar>>(&self, x: [S; NX]) -> [S; M];

    /// The plant in chain form, for outputs of relative degree N at the operating point `x`.
    ///
    /// # Errors
    /// Those of [`Linearized::new`].
    fn linearized<const N: usize>(
        self,
        x: impl Into<SVector<Self::Scalar, NX>>,
    ) -> Result<Linearized<Self, NX, N, M>, Error> {
        Linearized::new(self, x)
    }

    /// The relative degree at the state `x`, and what it was found from.
    ///
    /// What vanishes at `x` counts as zero if it also does at NX + 1 states close by, some ε^¼ away.
    ///
    /// # Errors
    /// [`Error::Unreached`] for an output whose first NX derivatives no input acts on; [`Error::UndefinedRelativeDegree`] if the decisive Lie
    /// derivative of an output vanishes at `x` but not close by; [`Error::IllConditioned`] if the decoupling matrix has a condition number
    /// above 1/√ε; [`Error::NonFiniteEntry`] and [`Error::NonFinite`] for `x`, f, g, h and their derivatives.
    fn relative_degree(
        &self,
        x: impl Into<SVector<Self::Scalar, NX>>,
    ) -> Result<RelativeDegree<Self::Scalar, NX, M>, Error> {
        RelativeDegree::at(self, x.into())
    }

    /// The relative degree over `states`: along a trajectory, or over a box ([`BoxSamples`]).
    ///
    /// # Errors
    /// [`Error::Unreached`] if no input acts on the first NX derivatives of an output at any of them; [`Error::NonFiniteEntry`] and
    /// [`Error::NonFinite`] for any of the states, f, g, h and their derivatives; [`Error::Missing`] without a state.
    fn relative_degree_over<I>(
        &self,
        states: I,
    ) -> Result<RelativeDegree<Self::Scalar, NX, M>, Error>
    where
        I: IntoIterator<Item = SVector<Self::Scalar, NX>>,
        I::IntoIter: Clone,
    {
        RelativeDegree::over(self, states.into_iter())
    }

    /// The Jacobians A, B and C at the state `x` and the input `u`.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] for `x`, `u`, f, g, h, A and C.
    fn jacobians(
        &self,
        x: impl Into<SVector<Self::Scalar, NX>>,
        u: impl Into<SVector<Self::Scalar, M>>,
    ) -> Result<Jacobians<Self::Scalar, NX, M>, Error> {
        jacobians::jacobians(self, &x.into(), &u.into())
    }
}

impl<P: SmoothPlant<NX, M>, const NX: usize, const M: usize> SmoothPlant<NX, M> for &P {
    type Scalar = P::Scalar;

    #[inline]
    fn drift_field<S: Smooth<P::Scalar>>(&self, x: [S; NX]) -> [S; NX] {
        (**self).drift_field(x)
    }

    #[inline]
    fn input_fields<S: Smooth<P::Scalar>>(&self, x: [S; NX]) -> [[S; NX]; M] {
        (**self).input_fields(x)
    }

    #[inline]
    fn outputs<S: Smooth<P::Scalar>>(&self, x: [S; NX]) -> [S; M] {
        (**self).outputs(x)
    }
}
