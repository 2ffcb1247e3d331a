use nalgebra::SVector;

use super::AdaptationRule;
use crate::{
    Error, Scalar,
    error::positive,
    fuzzy::{Firing, FuzzyNetwork, Grid, Inputs},
};

/// Any rule with its output projected onto |u_n| ≤ U and, if wanted, |u_n(k) − u_n(k−1)| ≤ R·h: a step that leads beyond is replaced by one
/// along w̃ that leads to the limit.
///
/// U is the largest |Δ| that the plant can have, or the most that the actuator has to give for it. A learner that winds up can do no more
/// harm than U; a U below |Δ| leaves the rest to the feedback.
///
/// R is for rules with no limit of their own: under [`SlidingMode`](super::SlidingMode) u_n moves by at most αh a period anyway, while
/// under [`GradientDescent`](super::GradientDescent) the step grows with s, so one outlier of a sensor moves it arbitrarily far. An R below
/// the rate of Δ leaves a lag to the feedback.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounded<R, T> {
    rule: R,
    bound: T,
    rate: Option<T>,
    last: Option<T>,
}

impl<R, T: Scalar> Bounded<R, T> {
    /// `rule` with `bound` U > 0 in the units of ẋ_n.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(rule: R, bound: T) -> Result<Self, Error> {
        Ok(Self { rule, bound: positive("bound", bound)?, rate: None, last: None })
    }

    /// The same rule with u_n moving at `rate` R > 0 at the most, in the units of ẋ_n per second.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_rate(self, rate: T) -> Result<Self, Error> {
        Ok(Self { rate: Some(positive("rate of u_n", rate)?), ..self })
    }

    fn clamped(&self, u_n: T) -> T {
        u_n.max(-self.bound).min(self.bound)
    }
}

impl<T: Scalar, R: AdaptationRule<T, I, K>, const I: usize, const K: usize> AdaptationRule<T, I, K>
    for Bounded<R, T>
where
    Inputs<I>: Grid,
{
    fn follow(&mut self, network: &mut FuzzyNetwork<T, I, K>, e: &SVector<T, I>) {
        self.rule.follow(network, e);
    }

    fn adapt(
        &mut self,
        network: &mut FuzzyNetwork<T, I, K>,
        firing: &Firing<T, I, K>,
        s: T,
        dt: T,
    ) {
        // Before the first sample u_n is what the network was given with.
        let (given, before) = (*network, network.output(firing));
        let last = self.clamped(self.last.unwrap_or(before));
        self.rule.adapt(network, firing, s, dt);
        let learned = network.output(firing);
        let u_n = match self.rate.map(|rate| rate * dt) {
            None => self.clamped(learned),
            Some(reach) => self.clamped(learned.max(last - reach).min(last + reach)),
        };
        // A sum that is not finite is left as it is, to be refused. The step is not undone by a difference: one that is large beside u_n
        // would leave its rounding behind.
        if learned.is_finite() && learned != u_n {
            network.restore_consequents(&given);
            network.move_consequents(firing, (u_n - before) / firing.norm_squared());
        }
        self.last = Some(u_n);
    }
}
