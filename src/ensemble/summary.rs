use std::vec::Vec;

use statrs::statistics::Statistics;

use super::{
    Estimate, mean,
    order_statistics::{rank, ranks},
};
use crate::{
    Error,
    error::{below, finite, positive},
};

/// A completed run and a figure of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    /// The run.
    pub index: u64,
    /// Its figure.
    pub value: f64,
}

/// What can be said of one figure of an ensemble.
///
/// Its mean and its deviation are those of the completed runs; in its quantiles a failed run counts as +∞.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    level: f64,
    total: usize,
    mean: f64,
    deviation: f64,
    ranked: Vec<Case>,
}

impl Summary {
    /// Of `total` runs those that `completed`, as (index, value).
    pub(super) fn new(
        level: f64,
        total: usize,
        completed: impl Iterator<Item = (u64, f64)> + Clone,
    ) -> Self {
        let values = completed.clone().map(|(_, value)| value);
        let (mean, deviation) = (values.clone().mean(), values.std_dev());
        let mut ranked: Vec<Case> = completed.map(|(index, value)| Case { index, value }).collect();
        ranked.sort_by(|a, b| a.value.total_cmp(&b.value));
        Self { level, total, mean, deviation, ranked }
    }

    /// The number of runs, completed or failed.
    pub fn total(&self) -> usize {
        self.total
    }

    /// The number of runs that failed.
    pub fn failed(&self) -> usize {
        self.total - self.ranked.len()
    }

    /// The completed runs from best to worst; among equals the first is first.
    pub fn ranked(&self) -> &[Case] {
        &self.ranked
    }

    /// The completed run with the largest value.
    pub fn worst(&self) -> Option<Case> {
        self.ranked.last().copied()
    }

    /// The completed run with the smallest value.
    pub fn best(&self) -> Option<Case> {
        self.ranked.first().copied()
    }

    /// The mean of the completed runs, x̄ ± t·s/√n with Student's t for n − 1 degrees of freedom.
    ///
    /// The interval is exact for a normal figure. For others it is right for large n, how large depending on their skewness; quantiles do
    /// without that.
    ///
    /// # Errors
    /// [`Error::Missing`] if no run completed, [`Error::NonFinite`] if the sums leave the range of `f64`.
    pub fn mean(&self) -> Result<Estimate, Error> {
        if self.ranked.is_empty() {
            return Err(Error::Missing { name: "completed run" });
        }
        mean::interval(self.mean, self.deviation, self.ranked.len(), self.level)
    }

    /// The standard deviation s of the completed runs, with n − 1.
    ///
    /// # Errors
    /// [`Error::Missing`] if fewer than two completed, [`Error::NonFinite`] if the sums leave the range of `f64`.
    pub fn deviation(&self) -> Result<f64, Error> {
        if self.ranked.len() < 2 {
            return Err(Error::Missing { name: "second completed run" });
        }
        finite("standard deviation", self.deviation)
    }

    /// The `p`-quantile of all runs, p in (0, 1): the least value that a share of at least p of them does not exceed, and two order
    /// statistics that enclose the true one whatever the distribution.
    ///
    /// It is a run's value, never between two; +∞ where it falls to the failed runs. The interval is \[x₍ₗ₎, x₍ᵤ₎\] with P(B < l) and P(B ≥ u) at
    /// most (1 − level)/2 each for B ~ Bin(n, p), infinite on the side where n is too small for that.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotBelow`] or [`Error::NonFinite`] for p, [`Error::Missing`] without runs.
    ///
    /// # References
    /// R. J. Hyndman, Y. Fan, "Sample quantiles in statistical packages", The American Statistician 50(4), 1996, definition 1.
    /// H. A. David, H. N. Nagaraja, "Order Statistics", third edition, 2003, section 7.1.
    pub fn quantile(&self, p: f64) -> Result<Estimate, Error> {
        below("p", positive("p", p)?, 1.0)?;
        if self.total == 0 {
            return Err(Error::Missing { name: "run" });
        }
        let ranked = |rank: usize| match rank.checked_sub(1) {
            None => f64::NEG_INFINITY,
            Some(k) => self.ranked.get(k).map_or(f64::INFINITY, |case| case.value),
        };
        let (low, high) = ranks(self.total, p, self.level);
        Ok(Estimate { value: ranked(rank(self.total, p)), low: ranked(low), high: ranked(high) })
    }
}
