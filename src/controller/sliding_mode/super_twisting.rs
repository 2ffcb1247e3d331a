use nalgebra::SVector;

use super::{SlidingSurface, SuperTwistingGains, super_twisting_gains::sgn};
use crate::{
    Error, Scalar,
    controller::{
        Accept, Command, Controller, Measurement, Reference,
        feedback_linearization::{closed_loop, linearizing},
    },
    error::{finite, remembered},
    learning::LearningMode,
    plant::FeedbackLinearizable,
    scalar::constant,
};

/// Super-twisting control: u = b(x)⁻¹·(−a(x) + u_f + u_b + u_s + w) with u_f = ṙ_n, u_b = Σ c_i·e_{i+1}, u_s = k₁·|σ|^½·sgn(σ) and ẇ = k₂·sgn(σ).
///
/// With z = −(w + Δ) the loop becomes σ̇ = −k₁·|σ|^½·sgn(σ) + z, ż = −k₂·sgn(σ) − Δ̇. The sign is integrated, so u is continuous; for |Δ̇| ≤ L and
/// [gains](SuperTwistingGains) that fit, σ and σ̇ are zero after a finite time, and then w = −Δ.
///
/// # In samples
/// With the period h, σ(k+1) = σ(k) − h·(u_s + w + Δ): exactly for N = 1 and Δ the mean over the period; beyond, what u_b moves meanwhile counts
/// as Δ.
///
/// * [`Implicit`](Stepping::Implicit), the default: backward Euler of the loop above in (ξ, z), where ξ = σ + h·(w + Δ) of the period before is
///   what σ would be without z. In its equation ξ − h·(w + Δ) is the σ that is measured, so it has a closed form:
///   ξ⁺ + h·k₁·|ξ⁺|^½·ς + h²·k₂·ς = σ with ς ∈ sgn(ξ⁺), w⁺ = w + h·k₂·ς, u_s = (σ − ξ⁺)/h.
///   Where |σ| ≤ h²·k₂, ξ⁺ = 0 and u_s = σ/h: the gains do not appear, nothing chatters, and σ(k+1) = −h·(Δ(k) − Δ(k−1)). That is at most
///   h²·L, and without knowing Δ(k) there is no less.
/// * [`Explicit`](Stepping::Explicit): forward Euler, for comparison. It chatters at the order of h², the more the greater the gains are.
///
/// # Saturated actuators
/// What did not arrive is no Δ to be integrated. Where another input is reported as applied than was asked for, w becomes what it would be had σ
/// been the one that asks for this input (conditioning): ẇ = k₂·sgn(v − w), where v is u_s + w less what did not arrive. So w never goes further
/// than what the actuator can do, and does not wind up.
///
/// Assumes b(x) ≠ 0 and a reference that is N times differentiable. A Δ that jumps is caught again in finite time.
///
/// # References
/// A. Levant, "Sliding order and sliding accuracy in sliding mode control", International Journal of Control 58(6), 1993. Implicit steps: B.
/// Brogliato, A. Polyakov, D. Efimov, "The implicit discretization of the super-twisting sliding-mode control algorithm", IEEE Transactions on
/// Automatic Control 65(8), 2020, of (σ, w), which leaves σ = −h·Δ; with a modified sliding variable as here, R. Seeber, B. Andritsch, "Proper
/// implicit discretization of the super-twisting controller—without and with actuator saturation", Automatica 173, 2025. Conditioning: R. Seeber,
/// M. Reichhartinger, "Conditioned super-twisting algorithm for systems with saturated control action", Automatica 116, 2020.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SuperTwisting<P: FeedbackLinearizable<N>, const N: usize> {
    model: P,
    surface: SlidingSurface<P::Scalar, N>,
    gains: SuperTwistingGains<P::Scalar>,
    stepping: Stepping,
    last: Option<Step<P::Scalar>>,
}

/// How [`SuperTwisting`] is discretized.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Stepping {
    /// Forward Euler.
    Explicit,
    /// Backward Euler, solved in closed form.
    #[default]
    Implicit,
}

/// An input of [`SuperTwisting`] and its shares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SuperTwistingCommand<T> {
    /// The input u, in the plant's units.
    pub u: T,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// The feedback u_b = Σ c_i·e_{i+1}, in the units of ẋ_n.
    pub u_b: T,
    /// The share of the root, k₁·|σ|^½·sgn(σ), in the units of ẋ_n; in the implicit law with the step h·k₂·ς of w in it.
    pub u_s: T,
    /// The integrated sign w, in the units of ẋ_n: what is known of −Δ.
    pub w: T,
    /// The sliding variable σ, in the units of x_n.
    pub sigma: T,
}

impl<T: Scalar> Command<T, 1> for SuperTwistingCommand<T> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

/// What is remembered of a period.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Step<T> {
    /// w at its start, and at its end if all arrives.
    start: T,
    end: T,
    /// The farthest that w can move, k₂·h.
    reach: T,
    /// u_s + w, the input u that came of it, and the b(x) at which.
    sum: T,
    u: T,
    gain: T,
}

impl<T: Scalar> Step<T> {
    /// w at the end of the period, in which the input `u` arrived.
    fn conditioned(&self, u: T, stepping: Stepping) -> T {
        if u == self.u {
            return self.end;
        }
        let beyond = self.sum + self.gain * (u - self.u) - self.start;
        let step = match stepping {
            Stepping::Explicit => sgn(beyond) * self.reach,
            // `beyond` is twice the step of w as long as that is within reach.
            Stepping::Implicit => (beyond * constant(0.5)).max(-self.reach).min(self.reach),
        };
        self.start + step
    }
}

impl<P: FeedbackLinearizable<N>, const N: usize> SuperTwisting<P, N> {
    /// A controller for the plant that `model` describes. w is 0 at first.
    pub fn new(
        model: P,
        surface: SlidingSurface<P::Scalar, N>,
        gains: SuperTwistingGains<P::Scalar>,
    ) -> Self {
        Self { model, surface, gains, stepping: Stepping::Implicit, last: None }
    }

    /// The same law with another discretization.
    pub fn with_stepping(self, stepping: Stepping) -> Self {
        Self { stepping, ..self }
    }

    /// The model that the law inverts.
    pub fn model(&self) -> &P {
        &self.model
    }

    /// The sliding surface.
    pub fn surface(&self) -> &SlidingSurface<P::Scalar, N> {
        &self.surface
    }

    /// The gains.
    pub fn gains(&self) -> &SuperTwistingGains<P::Scalar> {
        &self.gains
    }
}

impl<P: FeedbackLinearizable<N>, const N: usize> Controller<N, 1> for SuperTwisting<P, N> {
    type Scalar = P::Scalar;
    type Reference = Reference<P::Scalar, N>;
    type Command = SuperTwistingCommand<P::Scalar>;

    /// # Errors
    /// [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] and [`Error::NonFiniteEntry`] for the measurement, the reference,
    /// a(x), b(x), u_b, σ, u_s, w and k₂·dt; [`Error::Singular`] where b(x) is zero or so small that u is not finite.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let (zero, one) = (nalgebra::zero(), nalgebra::one());
        let feedback = |e: &_| self.surface.feedback(e);
        let asked = self.last.map_or(zero, |last| last.u);
        let off = LearningMode::Off;
        let at = closed_loop(&self.model, feedback, measurement, reference, dt, asked, off)?;
        let sigma = finite("sigma", self.surface.value(&at.e))?;
        let start = self.last.map_or(zero, |last| last.conditioned(at.u, self.stepping));

        let (u_s, w, end) = match self.stepping {
            Stepping::Explicit => {
                let (u_s, end) = self.gains.explicit(sigma, start, dt);
                (u_s, start, end)
            }
            Stepping::Implicit => {
                let (u_s, end) = self.gains.implicit(sigma, start, dt);
                (u_s, end, end)
            }
        };
        let reach = finite("k2*dt", self.gains.k2() * dt)?;
        let (end, sum) = (remembered("w", end, one)?, remembered("u_s + w", u_s + w, one)?);
        let (u_f, u_b) = (at.u_f, at.u_b);
        let u = linearizing(&at, u_f + u_b + sum)?;
        let command = SuperTwistingCommand { u, u_f, u_b, u_s, w, sigma };
        accept(&command)?;
        self.last = Some(Step { start, end, reach, sum, u, gain: at.gain });
        Ok(command)
    }

    fn reset(&mut self) {
        self.last = None;
    }
}

checked! {
    [T: Scalar] Step<T>, [T] { start: T, end: T, reach: T, sum: T, u: T, gain: T } =>
    known("w", [start, end]).and_then(|()| {
        known("last u_s + w, u and b(x)", [sum, u, gain])?;
        Ok(Self { start, end, reach: not_negative("k2*dt", reach)?, sum, u, gain })
    })
}

checked! {
    [P: FeedbackLinearizable<N>, const N: usize] SuperTwisting<P, N>, [P, P::Scalar]
    {
        model: P,
        surface: SlidingSurface<P::Scalar, N>,
        gains: SuperTwistingGains<P::Scalar>,
        stepping: Stepping,
        last: Option<Step<P::Scalar>>,
    } =>
    Ok(Self { model, surface, gains, stepping, last })
}
