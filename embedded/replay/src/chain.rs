use brunovsky::{
    fuzzy::{Grid, Inputs, Over},
    learning::{AdaptationRule, ErrorRate},
    plant::IntegratorChain,
    prelude::*,
};

use crate::Real;

/// CLELC of a chain of order N, with K memberships an input.
pub type Chain<E, R, const N: usize, const K: usize> =
    Clelc<IntegratorChain<Real, N>, NeuroFuzzy<FuzzyNetwork<Real, N, K>, E, R>, N>;

/// The feedback of a chain of order N.
pub fn feedback<const N: usize>()
-> Result<FeedbackLinearization<IntegratorChain<Real, N>, N>, Error> {
    Ok(FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(2.0)?))
}

/// CLELC of a chain of order N that learns by `rule`, with ė_n from `error_rate`.
pub fn chain<E, R, const N: usize, const K: usize>(
    error_rate: E,
    rule: R,
) -> Result<Chain<E, R, N, K>, Error>
where
    E: ErrorRate<Real, N> + Clone,
    R: AdaptationRule<FuzzyNetwork<Real, N, K>> + Clone,
    Inputs<N>: Grid,
{
    trained(FuzzyNetwork::evenly_spaced([2.0; N])?, error_rate, rule)
}

/// CLELC of a chain of order N with `network`.
pub fn trained<W, E, R, const N: usize>(
    network: W,
    error_rate: E,
    rule: R,
) -> Result<Clelc<IntegratorChain<Real, N>, NeuroFuzzy<W, E, R>, N>, Error>
where
    W: Over<Real, N>,
    E: ErrorRate<Real, N> + Clone,
    R: AdaptationRule<W> + Clone,
{
    Ok(Clelc::new(feedback()?, NeuroFuzzy::new(network, error_rate, rule)))
}
