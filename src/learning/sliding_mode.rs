use super::{AdaptationRule, Antecedents, Certificate, Flow, Switching};
use crate::{
    Error, Scalar,
    error::positive,
    fuzzy::{Network, Strengths},
};

/// The sliding-mode learning rule, which makes the network's output obey u̇_n = α·sgn(s) (eq_dotun5).
///
/// | parameter | law | equation |
/// |---|---|---|
/// | consequents | ḟ_r = w̃_r/(w̃ᵀw̃)·α·sgn(s) | eq_fr |
/// | centres | ċ = ė + (e − c)·α·sgn(s) | eq_c_ik |
/// | widths | σ̇ = −(σ + σ³/(e − c)²)·α·sgn(s) | eq_sigma_ik |
///
/// [`Switching`] says how sgn(s) is discretized, [`Antecedents`] whether centres and widths move and what happens where their law is
/// singular. If α exceeds the bound B on |Δ̇|, s reaches zero within |s(0)|/(α − B); see [`Certificate`].
///
/// ```
/// use brunovsky::learning::{Fixed, SlidingMode, Switching};
///
/// let recommended = SlidingMode::new(25.0)?;
/// let literal = SlidingMode::new(25.0)?.with_switching(Switching::Explicit { delta: 0.05 })?;
/// let remembering = recommended.with_antecedents(Fixed);
/// assert!(literal.certificate(0.01, 5.0)?.explicit_chatters());
/// # let _ = remembering;
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingMode<T, A = Flow<T>> {
    pub(super) alpha: T,
    switching: Switching<T>,
    antecedents: A,
}

impl<T: Scalar> SlidingMode<T> {
    /// The rule with learning rate α > 0 (in the units of ẋ_n per second), the set-valued sign and flowing antecedents.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(alpha: T) -> Result<Self, Error> {
        Ok(Self {
            alpha: positive("alpha", alpha)?,
            switching: Switching::SetValued,
            antecedents: Flow::default(),
        })
    }
}

impl<T: Scalar, A> SlidingMode<T, A> {
    /// The same rule with another discretization of the sign.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`] for a boundary layer out of range.
    pub fn with_switching(self, switching: Switching<T>) -> Result<Self, Error> {
        Ok(Self { switching: switching.validated()?, ..self })
    }

    /// The same rule with another treatment of the antecedents: [`Fixed`](super::Fixed), or a [`Flow`] between other bounds.
    pub fn with_antecedents<B>(self, antecedents: B) -> SlidingMode<T, B> {
        SlidingMode { alpha: self.alpha, switching: self.switching, antecedents }
    }

    /// What theory promises of this rule at period `dt` for an uncertainty with |Δ̇| ≤ `bound`.
    ///
    /// # Errors
    /// As [`Certificate::new`].
    pub fn certificate(&self, dt: T, bound: T) -> Result<Certificate<T>, Error> {
        Certificate::new(self.alpha, self.switching, dt, bound)
    }
}

impl<T: Scalar, W: Network<Scalar = T>, A: Antecedents<W>> AdaptationRule<W> for SlidingMode<T, A> {
    fn follow(&mut self, network: &mut W, e: &W::Input) {
        self.antecedents.follow(network, e);
    }

    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: T, dt: T) {
        let reach = self.alpha * dt;
        let travel = reach * self.switching.sign(s, reach);
        network.move_consequents(firing, travel / firing.norm_squared());
        self.antecedents.flow(network, travel);
    }
}

checked! {
    [T: Scalar, A] SlidingMode<T, A>, [T, A]
    { alpha: T, switching: Switching<T>, antecedents: A } =>
    SlidingMode::new(alpha)
        .and_then(|rule| Ok(rule.with_switching(switching)?.with_antecedents(antecedents)))
}
