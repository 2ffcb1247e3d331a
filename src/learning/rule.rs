use crate::fuzzy::Network;

/// How a network `W` moves, given the sliding variable s.
///
/// At every sample the compensator lets the rule [`follow`](Self::follow) the input, finds the firing strengths and s, lets it
/// [`adapt`](Self::adapt), and takes what the rule lets [`out`](Self::output). A rule is given finite numbers and does not fail; a network that leaves the range of the scalar is
/// found by the compensator.
///
/// A rule is written for every [`Network`], or for those that can do what it needs.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a rule for the network `{W}`",
    label = "cannot train this network"
)]
pub trait AdaptationRule<W: Network> {
    /// Moves what moves with the input `e`, before the network is evaluated there. By default nothing does.
    fn follow(&mut self, network: &mut W, e: &W::Input) {
        let _ = (network, e);
    }

    /// Learns from `s` over a period of `dt` seconds; `firing` is how the rules fire at the present input.
    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: W::Scalar, dt: W::Scalar);

    /// u_n for rules that fire as `firing` says: by default the network's output. What limits u_n limits it here, whether or not it learns.
    fn output(&self, network: &W, firing: &W::Firing) -> W::Scalar {
        network.output(firing)
    }
}

/// The rule that never learns: the network stays as it was given.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NullRule;

impl<W: Network> AdaptationRule<W> for NullRule {
    fn adapt(&mut self, _: &mut W, _: &W::Firing, _: W::Scalar, _: W::Scalar) {}
}
