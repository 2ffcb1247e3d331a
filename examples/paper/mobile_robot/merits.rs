//! What a run is judged by.

use brunovsky::prelude::*;

use super::{ON_TRACK, PERIOD, Sample, data::Row};

/// A run that is ever farther off than this on track, in m, counts as diverged.
const DIVERGED: f64 = 1.0;

/// Means over the samples on track, and over runs.
#[derive(Clone, Copy, Default)]
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
    distance(sample, sample.command.gnss)
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

/// The merits of all `runs`.
pub fn merits(runs: &[Vec<Sample>]) -> Result<Merits, Error> {
    let mut all = Merits::default();
    for run in runs {
        let error_true = mean(run, error_true);
        let commands = on_track(run).map(|sample| sample.u[1]);
        let seconds = on_track(run).count() as f64 * PERIOD;
        all.error += mean(run, error);
        all.error_true += error_true;
        all.worst = all.worst.max(error_true);
        let limited = |sample: &Sample| {
            f64::from(u8::from(sample.u[1] != sample.command.decided.asked.omega))
        };
        all.saturated += mean(run, limited);
        all.variation += TotalVariation::of(commands)? / seconds;
        all.diverged +=
            usize::from(on_track(run).any(|sample| self::error_true(sample) > DIVERGED));
    }
    let count = runs.len() as f64;
    for sum in [&mut all.error, &mut all.error_true, &mut all.saturated, &mut all.variation] {
        *sum /= count;
    }
    Ok(all)
}
