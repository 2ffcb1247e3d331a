use nalgebra::SVector;

use super::{SlidingSurface, sign::Sign};
use crate::{
    Error, Scalar,
    controller::{
        Accept, Command, Controller, Measurement, Reference,
        feedback_linearization::{closed_loop, linearizing},
    },
    error::{finite, not_negative, positive},
    learning::{LearningMode, Switching},
    plant::FeedbackLinearizable,
};

/// Sliding-mode control of first order: u = b(x)⁻¹·(−a(x) + u_f + u_b + u_s) with u_f = ṙ_n, u_b = Σ c_i·e_{i+1} and u_s = k·sgn(σ).
///
/// The loop becomes σ̇ = −k·sgn(σ) − Δ. If k exceeds the bound B on |Δ|, σ is zero within |σ(0)|/(k − B) and stays there; from then on
/// e decays as the [`SlidingSurface`] says, whatever Δ does.
///
/// # The sign in samples
/// With the period h and the input held, σ(k+1) = σ(k) − k·h·ς − h·Δ, exactly for N = 1 and to O(h²) beyond.
///
/// | sign | law | what remains of \|σ\| |
/// |---|---|---|
/// | set-valued, the default | clamp(σ/(k·h), −1, 1): the ς for which σ would be zero at the end of the period | B·h |
/// | [saturation](Self::with_saturation) | clamp(σ/δ, −1, 1) | δ·B/k, while k·h ≤ δ |
/// | [smooth](Self::with_switching) | σ/(\|σ\| + δ), explicit or implicit | δ·B/(k − B), and B·h or chattering |
/// | saturation, δ = 0 | sgn(σ) itself | (k + B)·h: it chatters |
///
/// In the sliding mode of the set-valued sign u_s = σ/h: k does not appear in it, so a k however far too large changes nothing, and nothing
/// chatters.
///
/// Assumes b(x) ≠ 0, |Δ| < k and a reference that is N times differentiable. A model whose input gain is b̂ ≠ b has (b/b̂ − 1)·(u_f + u_b − a)
/// in its Δ, and b/b̂·k for k; the signs bear the b/b̂ that [`Switching`] tells. It has no memory, so a saturated actuator winds nothing up.
///
/// # References
/// V. Utkin, "Variable structure systems with sliding modes", IEEE Transactions on Automatic Control 22(2), 1977. J.-J. Slotine, W. Li, "Applied
/// Nonlinear Control", 1991, chapter 7. The set-valued sign: V. Acary, B. Brogliato, "Implicit Euler numerical scheme and chattering-free
/// implementation of sliding mode systems", Systems & Control Letters 59(5), 2010; V. Acary, B. Brogliato, Y. Orlov, "Chattering-free digital
/// sliding-mode control with state observer and disturbance rejection", IEEE Transactions on Automatic Control 57(5), 2012.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingModeControl<P: FeedbackLinearizable<N>, const N: usize> {
    model: P,
    surface: SlidingSurface<P::Scalar, N>,
    k: P::Scalar,
    sign: Sign<P::Scalar>,
}

/// An input of [`SlidingModeControl`] and its shares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingModeCommand<T> {
    /// The input u, in the plant's units.
    pub u: T,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// The feedback u_b = Σ c_i·e_{i+1}, in the units of ẋ_n.
    pub u_b: T,
    /// The switching term u_s = k·ς, in the units of ẋ_n.
    pub u_s: T,
    /// The sliding variable σ, in the units of x_n.
    pub sigma: T,
}

impl<T: Scalar> Command<T, 1> for SlidingModeCommand<T> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

impl<P: FeedbackLinearizable<N, Scalar = T>, T: Scalar, const N: usize> SlidingModeControl<P, N> {
    /// A controller for the plant that `model` describes, with gain k > 0 in the units of ẋ_n and the set-valued sign.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(model: P, surface: SlidingSurface<T, N>, k: T) -> Result<Self, Error> {
        let sign = Sign::Switched(Switching::SetValued);
        Ok(Self { model, surface, k: positive("k", k)?, sign })
    }

    /// k = B + η for |Δ| ≤ `bound` = B ≥ 0: then σ·σ̇ ≤ −η·|σ|, so σ is zero within |σ(0)|/η. η = `margin` > 0, both in the units of ẋ_n.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn for_bound(
        model: P,
        surface: SlidingSurface<T, N>,
        bound: T,
        margin: T,
    ) -> Result<Self, Error> {
        let bound = not_negative("bound on the uncertainty", bound)?;
        Self::new(model, surface, bound + positive("margin", margin)?)
    }

    /// The same law with another sign: smoothed by a boundary layer, explicitly or implicitly.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`] for a boundary layer out of range.
    pub fn with_switching(self, switching: Switching<T>) -> Result<Self, Error> {
        Ok(Self { sign: Sign::Switched(switching).validated()?, ..self })
    }

    /// The same law with the saturation clamp(σ/δ, −1, 1), `delta` = δ ≥ 0 in the units of x_n. Stable while k·h < 2δ; 0 is the sign itself.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn with_saturation(self, delta: T) -> Result<Self, Error> {
        Ok(Self { sign: Sign::Saturated { delta }.validated()?, ..self })
    }

    /// The model that the law inverts.
    pub fn model(&self) -> &P {
        &self.model
    }

    /// The sliding surface.
    pub fn surface(&self) -> &SlidingSurface<T, N> {
        &self.surface
    }

    /// The gain k in the units of ẋ_n.
    pub fn gain(&self) -> T {
        self.k
    }

    /// |σ(0)|/(k − B) in seconds, within which σ reaches zero under the ideal sign while |Δ| ≤ `bound` = B; `None` unless k > B.
    ///
    /// # Errors
    /// [`Error::Negative`] for the bound; [`Error::NonFinite`] for it, for σ(0), and for a time beyond the range of the scalar.
    pub fn reaching_time(&self, sigma0: T, bound: T) -> Result<Option<T>, Error> {
        let size = finite("sigma(0)", sigma0)?.abs();
        let bound = not_negative("bound on the uncertainty", bound)?;
        let time = (self.k > bound).then(|| size / (self.k - bound));
        time.map(|time| finite("reaching time", time)).transpose()
    }

    /// What remains of |σ| at the samples, at period `dt` while |Δ| ≤ `bound` = B; `None` unless k > B. For N ≥ 2 it counts what u_b moves in a
    /// period as Δ.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`] for a parameter out of range.
    pub fn residual(&self, bound: T, dt: T) -> Result<Option<T>, Error> {
        not_negative("bound on the uncertainty", bound)?;
        finite("k*dt", self.k * positive("dt", dt)?)?;
        self.sign.residual(self.k, bound, dt)
    }
}

impl<P: FeedbackLinearizable<N>, const N: usize> Controller<N, 1> for SlidingModeControl<P, N> {
    type Scalar = P::Scalar;
    type Reference = Reference<P::Scalar, N>;
    type Command = SlidingModeCommand<P::Scalar>;

    /// # Errors
    /// [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] and [`Error::NonFiniteEntry`] for the measurement, the reference,
    /// a(x), b(x), u_b, σ and k·dt; [`Error::Singular`] where b(x) is zero or so small that u is not finite.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let feedback = |e: &_| self.surface.feedback(e);
        let (last, off) = (nalgebra::zero(), LearningMode::Off);
        let at = closed_loop(&self.model, feedback, measurement, reference, dt, last, off)?;
        let sigma = finite("sigma", self.surface.value(&at.e))?;
        let (u_f, u_b) = (at.u_f, at.u_b);
        let u_s = self.k * self.sign.sign(sigma, finite("k*dt", self.k * dt)?);
        let u = linearizing(&at, u_f + u_b + u_s)?;
        let command = SlidingModeCommand { u, u_f, u_b, u_s, sigma };
        accept(&command)?;
        Ok(command)
    }

    fn reset(&mut self) {}
}

checked! {
    [P: FeedbackLinearizable<N>, const N: usize] SlidingModeControl<P, N>, [P, P::Scalar]
    {
        model: P,
        surface: SlidingSurface<P::Scalar, N>,
        k: P::Scalar,
        sign: Sign<P::Scalar>,
    } =>
    Self::new(model, surface, k).and_then(|new| Ok(Self { sign: sign.validated()?, ..new }))
}
