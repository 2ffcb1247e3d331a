use super::{AdaptationRule, ClosedLoop, Compensation, Compensator, ErrorRate, LearningMode};
use crate::{
    Error, Scalar,
    error::{finite, finite_vector, positive},
    fuzzy::{Network, Over},
};

/// The intelligent controller of CLELC: a fuzzy network over the error vector e, trained on s = ė_n + u_b.
///
/// At each sample the network is evaluated at e, s is formed with ė_n from the error-rate source, the rule learns over the period,
/// and u_n is the output *after* learning. Where the loop's [`LearningMode`] says so, the step of the rule is left out, and u_n too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeuroFuzzy<W, E, R> {
    network: W,
    error_rate: E,
    rule: R,
}

impl<W: Network, E, R> NeuroFuzzy<W, E, R> {
    /// A `network` trained by `rule`, with ė_n from `error_rate`.
    pub fn new<T, const N: usize>(network: W, error_rate: E, rule: R) -> Self
    where
        T: Scalar,
        W: Over<T, N>,
        E: ErrorRate<T, N>,
        R: AdaptationRule<W>,
    {
        Self { network: network.released(), error_rate, rule }
    }

    /// The network as it stands.
    pub fn network(&self) -> &W {
        &self.network
    }

    /// The network as it stands, to be changed.
    pub fn network_mut(&mut self) -> &mut W {
        &mut self.network
    }
}

impl<T, W, E, R, const N: usize> Compensator<T, N> for NeuroFuzzy<W, E, R>
where
    T: Scalar,
    W: Over<T, N>,
    E: ErrorRate<T, N> + Clone,
    R: AdaptationRule<W> + Clone,
{
    fn advance_if(
        &mut self,
        at: &ClosedLoop<T, N>,
        dt: T,
        accept: &mut dyn FnMut(&Compensation<T>) -> Result<(), Error>,
    ) -> Result<Compensation<T>, Error> {
        positive("dt", dt)?;
        finite_vector("e", &at.e)?;
        let mut next = self.clone();
        next.rule.follow(&mut next.network, &at.e);
        let firing = next.network.fire(&at.e);
        // What is not in the loop is not in s either; −0 changes no sum.
        let known = match at.learning {
            LearningMode::Off => -T::zero(),
            LearningMode::Frozen | LearningMode::Active => next.rule.output(&next.network, &firing),
        };
        let s = finite("s", next.error_rate.error_rate(at, known, dt)? + at.u_b)?;
        let u_n = match at.learning {
            LearningMode::Off | LearningMode::Frozen => known,
            LearningMode::Active => {
                next.rule.adapt(&mut next.network, &firing, s, dt);
                next.rule.output(&next.network, &firing)
            }
        };
        let compensation = Compensation { u_n: finite("u_n", u_n)?, s };
        accept(&compensation)?;
        *self = next;
        Ok(compensation)
    }
}

checked! {
    [W, E, R] NeuroFuzzy<W, E, R>, [W, E, R] { network: W, error_rate: E, rule: R } =>
    Ok(Self { network, error_rate, rule })
}
