//! What a run is judged by.

use anyhow::bail;
use brunovsky::{ensemble::Runs, prelude::*};

use super::{ON_TRACK, PERIOD, Sample, data::Row};

/// A run that is ever farther off than this on track, in m, counts as diverged.
pub const DIVERGED: f64 = 1.0;

/// Means over the samples on track, and over runs.
#[derive(Clone, Copy)]
pub struct Merits {
    /// Distance of reference and GNSS position, in m.
    pub error: f64,
    /// Distance of reference and true position, in m.
    pub error_true: f64,
    /// The largest mean true error of a run, in m.
    pub worst: f64,
    /// The share of samples whose yaw rate command is limited.
    pub saturated: f64,
    /// The total variation of the yaw rate command, in rad/s a second.
    pub variation: f64,
    /// How many runs diverged.
    pub diverged: usize,
}

/// Distance of the reference from a position.
pub fn distance(sample: &Sample, position: [f64; 2]) -> f64 {
    let [x, y] = &sample.reference;
    (x.r[0] - position[0]).hypot(y.r[0] - position[1])
}

/// Distance of reference and GNSS position.
pub fn error(sample: &Sample) -> f64 {
    distance(sample, [sample.seen.x[0], sample.seen.x[1]])
}

/// Distance of reference and true position.
pub fn error_true(sample: &Sample) -> f64 {
    distance(sample, [sample.x[0], sample.x[1]])
}

/// The samples on track.
pub fn on_track(run: &[Sample]) -> impl Iterator<Item = &Sample> {
    run.iter().filter(|sample| sample.t >= ON_TRACK)
}

/// The mean of `f` over the samples on track.
pub fn mean(run: &[Sample], f: impl Fn(&Sample) -> f64) -> f64 {
    mean_of(on_track(run).map(f))
}

/// The mean of `f` over the rows on track.
pub fn mean_on_track(rows: &[Row], f: impl Fn(&Row) -> f64) -> f64 {
    mean_of(rows.iter().filter(|row| row.t >= ON_TRACK).map(f))
}

fn mean_of(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}

/// What a run is judged by.
pub const FIGURES: [&str; 5] =
    ["error in m", "true error in m", "ω saturated", "TV(ω) in rad/s²", "diverged"];

/// The [`FIGURES`] of a run.
pub fn figures(run: &[Sample]) -> Result<[f64; 5], Error> {
    let limited = |sample: &Sample| sample.u[1] != sample.command.asked.omega;
    let diverged = on_track(run).any(|sample| error_true(sample) > DIVERGED);
    let seconds = on_track(run).count() as f64 * PERIOD;
    Ok([
        mean(run, error),
        mean(run, error_true),
        mean(run, |sample| f64::from(limited(sample))),
        TotalVariation::of(on_track(run).map(|sample| sample.u[1]))? / seconds,
        f64::from(diverged),
    ])
}

impl Merits {
    /// The merits of all `runs`, none of which may have failed.
    pub fn of(runs: &Runs<5>) -> anyhow::Result<Self> {
        if let Some((seed, reason)) = runs.failures().next() {
            bail!("the run with seed {seed} failed: {reason}");
        }
        let [error, error_true, saturated, variation, _] = runs.summaries(0.95)?;
        let diverged = runs.completed().filter(|(_, [.., diverged])| *diverged > 0.0);
        Ok(Self {
            error: error.mean()?.value,
            error_true: error_true.mean()?.value,
            worst: error_true.worst().map_or(0.0, |case| case.value),
            saturated: saturated.mean()?.value,
            variation: variation.mean()?.value,
            diverged: diverged.count(),
        })
    }
}
