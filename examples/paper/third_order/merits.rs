//! What a run is judged by.

use brunovsky::prelude::*;

use super::{START, STEADY, SWITCHED_ON, Sample, uncertainty};

/// The nominal response of state `i`, from its initial value to 0.
pub fn response(run: &[Sample], i: usize) -> Result<StepInfo<f64>, Error> {
    let nominal = run.iter().take_while(|sample| sample.t < SWITCHED_ON);
    StepInfo::of(nominal.map(|sample| (sample.t, sample.x[i])), START[i], 0.0)
}

/// The samples that belong to the steady response under Δ.
pub fn steady(run: &[Sample]) -> impl Iterator<Item = &Sample> {
    run.iter().filter(|sample| sample.t >= STEADY)
}

/// max |f| over the steady samples.
pub fn largest(run: &[Sample], f: impl Fn(&Sample) -> f64) -> f64 {
    steady(run).map(|sample| f(sample).abs()).fold(0.0, f64::max)
}

/// u_n + Δ: what is not learned.
pub fn unlearned(sample: &Sample) -> f64 {
    sample.command.u_n + uncertainty(sample.t)
}

/// The total variation of u_n over the steady samples, as a multiple of that of Δ.
pub fn relative_variation(run: &[Sample]) -> Result<f64, Error> {
    let learned = TotalVariation::of(steady(run).map(|sample| sample.command.u_n))?;
    let uncertain = TotalVariation::of(steady(run).map(|sample| uncertainty(sample.t)))?;
    Ok(learned / uncertain)
}

/// The time from which on |s| is at most `bound`, up to the moment when Δ sets in.
pub fn reached(run: &[Sample], bound: f64) -> Option<f64> {
    let nominal = run.iter().take_while(|sample| sample.t < SWITCHED_ON);
    nominal.fold(None, |since, sample| {
        let inside = sample.command.s.abs() <= bound;
        inside.then(|| since.unwrap_or(sample.t))
    })
}
