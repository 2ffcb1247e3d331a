use nalgebra::SVector;

use crate::{
    Scalar,
    fuzzy::{Firing, FuzzyNetwork, Grid, Inputs},
};

/// How a network moves, given the sliding variable s.
///
/// At every sample the compensator lets the rule [`follow`](Self::follow) the input, finds the firing strengths and s, lets it
/// [`adapt`](Self::adapt), and takes what the rule lets [`out`](Self::output). A rule is given finite numbers and does not fail; a network that leaves the range of the scalar is
/// found by the compensator.
pub trait AdaptationRule<T: Scalar, const I: usize, const K: usize>
where
    Inputs<I>: Grid,
{
    /// Moves what moves with the input `e`, before the network is evaluated there. By default nothing does.
    fn follow(&mut self, network: &mut FuzzyNetwork<T, I, K>, e: &SVector<T, I>) {
        let _ = (network, e);
    }

    /// Learns from `s` over a period of `dt` seconds; `firing` is how the rules fire at the present input.
    fn adapt(&mut self, network: &mut FuzzyNetwork<T, I, K>, firing: &Firing<T, I, K>, s: T, dt: T);

    /// u_n for rules that fire as `firing` says: by default the network's output. What limits u_n limits it here, whether or not it learns.
    fn output(&self, network: &FuzzyNetwork<T, I, K>, firing: &Firing<T, I, K>) -> T {
        network.output(firing)
    }
}

/// The rule that never learns: the network stays as it was given.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NullRule;

impl<T: Scalar, const I: usize, const K: usize> AdaptationRule<T, I, K> for NullRule
where
    Inputs<I>: Grid,
{
    fn adapt(&mut self, _: &mut FuzzyNetwork<T, I, K>, _: &Firing<T, I, K>, _: T, _: T) {}
}
