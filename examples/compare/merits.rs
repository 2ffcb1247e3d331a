//! What a run is judged by.

use std::{hint::black_box, time::Instant};

use brunovsky::prelude::*;

use crate::{
    contestants::Any,
    worlds::{Row, Story},
};

/// The figures of a run: the response while the plant is the model, and what remains under the uncertainty.
pub struct Merits {
    /// 10 to 90 % of the way, in s.
    pub rise: Option<f64>,
    /// Into 2 % of the way, in s.
    pub settling: Option<f64>,
    /// In % of the way.
    pub overshoot: f64,
    /// The largest error in the steady state of the model.
    pub nominal: f64,
    /// The largest error in the steady state under the uncertainty.
    pub uncertain: f64,
    /// The RMS of the error from its beginning on.
    pub rms: f64,
    /// The RMS of the input from then on.
    pub effort: f64,
    /// The total variation of the input from then on, a second.
    pub variation: f64,
}

impl Merits {
    pub fn of(rows: &[Row], story: Story) -> Result<Self, Error> {
        let from =
            |start: f64, end: f64| rows.iter().filter(move |row| (start..end).contains(&row.t));
        let error = |start, end| ErrorMetrics::of(from(start, end).map(|row| (row.t, row.error)));
        let first = rows.first().ok_or(Error::Missing { name: "sample" })?;
        let nominal = from(0.0, story.switched).map(|row| (row.t, row.step));
        let response = StepInfo::of(nominal, first.step, 0.0)?;
        let uncertain = (story.switched, f64::INFINITY);
        let input = || from(uncertain.0, uncertain.1);
        let rms =
            |metrics: ErrorMetrics<f64>| metrics.rms().ok_or(Error::Missing { name: "sample" });
        Ok(Self {
            rise: response.rise_time(),
            settling: response.settling_time(),
            overshoot: response.overshoot(),
            nominal: error(story.settled, story.switched)?.maximum(),
            uncertain: error(story.steady, f64::INFINITY)?.maximum(),
            rms: rms(error(uncertain.0, uncertain.1)?)?,
            effort: rms(ErrorMetrics::of(input().map(|row| (row.t, row.u)))?)?,
            variation: TotalVariation::of(input().map(|row| row.u))? / (story.end - story.switched),
        })
    }
}

/// The time of an update in ns, the least of some rounds; the controller sees a chain that swings.
pub fn nanoseconds<const N: usize>(controller: &mut Any<N>, period: f64) -> Result<f64, Error> {
    const STEPS: u32 = 2000;
    let mut least = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        for k in 0..STEPS {
            let swing = 0.01 * (0.05 * f64::from(k)).sin();
            let seen = Measurement::new(SVector::<f64, N>::repeat(swing));
            black_box(controller.update(black_box(&seen), &Reference::setpoint(0.0), period)?);
        }
        least = least.min(start.elapsed().as_secs_f64() * 1e9 / f64::from(STEPS));
    }
    Ok(least)
}
