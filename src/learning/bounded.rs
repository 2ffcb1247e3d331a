use nalgebra::SVector;

use super::AdaptationRule;
use crate::{
    Error, Scalar,
    error::positive,
    fuzzy::{Firing, FuzzyNetwork, Grid, Inputs},
};

/// Any rule with its output projected onto |u_n| ≤ U: what is learned beyond the bound is taken back along w̃.
///
/// U is the largest |Δ| that the plant can have, or the most that the actuator has to give for it. A learner that winds up can do no more
/// harm than U; a U below |Δ| leaves the rest to the feedback.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounded<R, T> {
    rule: R,
    bound: T,
}

impl<R, T: Scalar> Bounded<R, T> {
    /// `rule` with `bound` U > 0 in the units of ẋ_n.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(rule: R, bound: T) -> Result<Self, Error> {
        Ok(Self { rule, bound: positive("bound", bound)? })
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
        self.rule.adapt(network, firing, s, dt);
        let u_n = network.output(firing);
        let excess = u_n - u_n.max(-self.bound).min(self.bound);
        if !excess.is_zero() {
            network.move_consequents(firing, -excess / firing.norm_squared());
        }
    }
}
