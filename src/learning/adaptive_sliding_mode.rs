use super::{AdaptationRule, Antecedents, Flow, SlidingMode};
use crate::{
    Error, Scalar,
    error::{below, positive},
    fuzzy::Network,
};

/// Sliding-mode learning for a |Δ̇| ≤ B of which no bound B is known: the learning rate grows while |s| is outside of a layer ε, and decays inside,
///
/// α̇ = γ·(|s| − ε) within \[α_min, α_max\], u̇_n = α·sgn(s),
///
/// by the Euler method, α before u_n. α_min is the rate of the rule that is made adaptive, where α starts too.
///
/// # What it promises
/// For V = ½·(|s| − ε)² + (α − B)²/(2γ) and the ideal sign, V̇ ≤ 0 outside of the layer whatever Δ does; inside, α only falls. So, for any B ≤ α_max,
/// known or not,
///
/// α ≤ B + m and |s| ≤ ε + m/√γ for all times, m = max(B − α_min, √((α(0) − B)² + γ·max(|s(0)| − ε, 0)²)),
///
/// and in between s returns into the layer again and again: outside, α grows until it exceeds B. (In samples, both up to the order of √γ·h.)
/// It does not stay there: α falls until it is too small, and finds out. For a B > α_max it is the rule with α = α_max.
///
/// # Which ε and γ
/// * ε > B·h + the noise of s. Within a period Δ moves by up to B·h, which no rule can know before; a layer thinner than that, or than the noise, lets α
///   grow to α_max, or without end.
/// * With [`Switching::Explicit`](super::Switching::Explicit), ε > αh/2 − δ too, for every α up to α_max: else the chattering feeds α, and α the chattering.
/// * √γ is the angular frequency at which α and s play around (B, ε): √γ·h < 1/2, or α is no function of time to speak of.
///
/// Everything that composes with [`SlidingMode`] composes with this: [`Switching`](super::Switching), [`Antecedents`], [`Bounded`](super::Bounded).
///
/// ```
/// use brunovsky::learning::{AdaptiveSlidingMode, SlidingMode};
///
/// let rule = AdaptiveSlidingMode::new(SlidingMode::new(0.5)?, 4.0, 0.1)?.with_ceiling(50.0)?;
/// assert_eq!(rule.alpha(), 0.5);
/// # Ok::<(), brunovsky::Error>(())
/// ```
///
/// # References
/// F. Plestan, Y. Shtessel, V. Brégeault, A. Poznyak, "New methodologies for adaptive sliding mode control", International Journal of Control
/// 83(9), 2010. Its first law is γ·|s|·sgn(|s| − ε), which jumps at the edge of the layer and does not decay at s = 0, where the set-valued sign rests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdaptiveSlidingMode<T, A = Flow<T>> {
    rule: SlidingMode<T, A>,
    growth: T,
    layer: T,
    floor: T,
    ceiling: Option<T>,
}

impl<T: Scalar, A> AdaptiveSlidingMode<T, A> {
    /// `rule` with an α that starts and ends where it is, and grows with γ = `growth` > 0, in 1/s², outside of the `layer` ε > 0, in the units of s.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for either.
    pub fn new(rule: SlidingMode<T, A>, growth: T, layer: T) -> Result<Self, Error> {
        let growth = positive("growth of alpha", growth)?;
        let floor = rule.alpha;
        Ok(Self { rule, growth, layer: positive("layer", layer)?, floor, ceiling: None })
    }

    /// The same rule with α ≤ `ceiling` = α_max, above α_min.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for the ceiling, [`Error::NotBelow`] for an α_min that is not below it.
    pub fn with_ceiling(self, ceiling: T) -> Result<Self, Error> {
        below("alpha", self.floor, positive("ceiling of alpha", ceiling)?)?;
        let mut rule = self.rule;
        rule.alpha = rule.alpha.min(ceiling);
        Ok(Self { rule, ceiling: Some(ceiling), ..self })
    }

    /// The learning rate α as it stands.
    pub fn alpha(&self) -> T {
        self.rule.alpha
    }
}

impl<T, W, A> AdaptationRule<W> for AdaptiveSlidingMode<T, A>
where
    T: Scalar,
    W: Network<Scalar = T>,
    A: Antecedents<W>,
{
    fn follow(&mut self, network: &mut W, e: &W::Input) {
        self.rule.follow(network, e);
    }

    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: T, dt: T) {
        let grown = self.rule.alpha + self.growth * dt * (s.abs() - self.layer);
        let least = grown.max(self.floor);
        self.rule.alpha = self.ceiling.map_or(least, |ceiling| least.min(ceiling));
        self.rule.adapt(network, firing, s, dt);
    }
}

checked! {
    [T: Scalar, A] AdaptiveSlidingMode<T, A>, [T, A]
    { rule: SlidingMode<T, A>, growth: T, layer: T, floor: T, ceiling: Option<T> } =>
    Self::new(rule, growth, layer).and_then(|new| {
        at_most("floor of alpha", positive("floor of alpha", floor)?, new.alpha())?;
        let Some(ceiling) = ceiling else { return Ok(Self { floor, ..new }) };
        at_most("alpha", new.alpha(), finite("ceiling of alpha", ceiling)?)?;
        Self { floor, ..new }.with_ceiling(ceiling)
    })
}
