use std::vec::Vec;

use super::{Estimate, Outcome, Summary, estimate::level as checked, proportion::proportion};
use crate::Error;

/// The outcomes of runs 0, 1, … of an experiment.
#[derive(Debug, Clone, PartialEq)]
pub struct Runs<const M: usize> {
    names: [&'static str; M],
    outcomes: Vec<Outcome<M>>,
}

impl<const M: usize> Runs<M> {
    pub(super) fn new(names: [&'static str; M], outcomes: Vec<Outcome<M>>) -> Self {
        Self { names, outcomes }
    }

    /// The names of the figures.
    pub fn names(&self) -> &[&'static str; M] {
        &self.names
    }

    /// All outcomes, by the index of the run.
    pub fn outcomes(&self) -> &[Outcome<M>] {
        &self.outcomes
    }

    /// The runs that completed: index and figures.
    pub fn completed(&self) -> impl Iterator<Item = (u64, &[f64; M])> + Clone {
        (0..)
            .zip(&self.outcomes)
            .filter_map(|(index, outcome)| Some((index, outcome.as_ref().ok()?)))
    }

    /// The runs that failed: index and reason.
    pub fn failures(&self) -> impl Iterator<Item = (u64, &str)> + Clone {
        (0..).zip(&self.outcomes).filter_map(|(index, outcome)| match outcome {
            Ok(_) => None,
            Err(reason) => Some((index, reason.as_str())),
        })
    }

    /// The share of runs that failed, with Wilson's interval, which covers the probability of failure with the confidence `level` in (0, 1).
    ///
    /// It is neither empty nor a point if no run failed: of 100 runs without a failure, up to 3.7 % may be expected to at 0.95.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotBelow`] or [`Error::NonFinite`] for the level, [`Error::Missing`] without runs.
    ///
    /// # References
    /// E. B. Wilson, "Probable inference, the law of succession, and statistical inference", Journal of the American Statistical
    /// Association 22(158), 1927.
    pub fn failure_rate(&self, level: f64) -> Result<Estimate, Error> {
        let level = checked(level)?;
        if self.outcomes.is_empty() {
            return Err(Error::Missing { name: "run" });
        }
        proportion(self.failures().count(), self.outcomes.len(), level)
    }

    /// What can be said of each figure, with intervals of the confidence `level` in (0, 1): `let [error, effort] = runs.summaries(0.95)?;`.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotBelow`] or [`Error::NonFinite`] for the level.
    pub fn summaries(&self, level: f64) -> Result<[Summary; M], Error> {
        let level = checked(level)?;
        let total = self.outcomes.len();
        Ok(core::array::from_fn(|k| {
            Summary::new(level, total, self.completed().map(|(index, figures)| (index, figures[k])))
        }))
    }
}
