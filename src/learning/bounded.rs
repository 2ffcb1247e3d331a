use super::AdaptationRule;
use crate::{
    Error, Scalar,
    error::positive,
    fuzzy::{Network, Strengths},
};

/// Any rule with limits on what it learns: |u_n| ≤ U and, if wanted, a step of u_n of at most R·h in a period.
///
/// Where the rule would go beyond, the consequents move along w̃ alone, just as far as the limits allow:
///
/// u_n⁺ = u_n + clamp(step, −R·h, R·h), then clamped to \[−U, U\]; a step beyond the range of the scalar is not taken.
///
/// U is the largest |Δ| that the plant can have, or the most that the actuator has to give for it. A learner that winds up can do no more
/// harm than U; a U below |Δ| leaves the rest to the feedback. U holds for a frozen u_n as well.
///
/// R is for rules with no limit of their own: under [`SlidingMode`](super::SlidingMode) the step is αh at the most anyway, while under
/// [`GradientDescent`](super::GradientDescent) it grows with s, so one outlier of a sensor moves u_n arbitrarily far. An R below the
/// rate of Δ leaves a lag to the feedback. It limits learning: with [`Fixed`](super::Fixed) antecedents u_n also moves when e
/// does, by what is known already. A [`RateLimit`](crate::channel::RateLimit) limits the input itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounded<R, T> {
    rule: R,
    bound: T,
    rate: Option<T>,
}

impl<R, T: Scalar> Bounded<R, T> {
    /// `rule` with `bound` U > 0 in the units of ẋ_n.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(rule: R, bound: T) -> Result<Self, Error> {
        Ok(Self { rule, bound: positive("bound", bound)?, rate: None })
    }

    /// The same rule with u_n learned at `rate` R > 0 at the most, in the units of ẋ_n per second.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_rate(self, rate: T) -> Result<Self, Error> {
        Ok(Self { rate: Some(positive("rate of u_n", rate)?), ..self })
    }

    fn clamped(&self, u_n: T) -> T {
        u_n.max(-self.bound).min(self.bound)
    }

    /// What a step from `last` to `u_n` is cut down to.
    fn limited(&self, last: T, u_n: T, dt: T) -> T {
        self.clamped(match self.rate {
            None => u_n,
            Some(rate) => u_n.max(last - rate * dt).min(last + rate * dt),
        })
    }
}

impl<T: Scalar, W: Network<Scalar = T>, R: AdaptationRule<W>> AdaptationRule<W> for Bounded<R, T> {
    fn follow(&mut self, network: &mut W, e: &W::Input) {
        self.rule.follow(network, e);
    }

    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: T, dt: T) {
        let last = self.output(network, firing);
        let mut learned = network.clone();
        self.rule.adapt(&mut learned, firing, s, dt);
        let free = self.rule.output(&learned, firing);
        let u_n = if free.is_finite() { self.limited(last, free, dt) } else { last };
        // A step that is cut starts again from before it: taking the excess back would leave the rounding of an arbitrarily large number.
        if u_n == free {
            *network = learned;
        } else {
            let step = u_n - self.rule.output(network, firing);
            network.move_consequents(firing, step / firing.norm_squared());
        }
    }

    fn output(&self, network: &W, firing: &W::Firing) -> T {
        self.clamped(self.rule.output(network, firing))
    }
}

checked! {
    [R, T: Scalar] Bounded<R, T>, [R, T] { rule: R, bound: T, rate: Option<T> } =>
    Self::new(rule, bound).and_then(|bounded| match rate {
        Some(rate) => bounded.with_rate(rate),
        None => Ok(bounded),
    })
}
