//! What the paper says about its simulation, claim by claim.

use brunovsky::prelude::*;

use super::{
    ALPHA, BOUND, DELTA, EXPERIMENT, PERIOD, START, Sample,
    merits::{largest, reached, relative_variation, response, unlearned},
    simulate,
    tables::{figure, figure_if},
};
use crate::claims::Claim;

/// A response counts as having no steady-state error if it stays in the band that settling times are measured by.
const BAND: f64 = 0.02;

/// Judges the paper's claims by the runs.
pub fn judge(
    flc: &[Sample],
    clelc: &[Sample],
    rule: SlidingMode<f64>,
) -> anyhow::Result<Vec<Claim>> {
    let mut claims = nominal(flc, clelc)?;
    claims.extend(uncertain(flc, clelc)?);
    claims.extend(theory(clelc, rule)?);
    Ok(claims)
}

fn claim(what: impl Into<String>, paper: &str, measured: String, borne_out: bool) -> Claim {
    Claim::new(EXPERIMENT, what, paper, measured, borne_out)
}

/// "The CLELC results in smaller rise and settling times, and overshoot than the traditional FLC in the absence of uncertainties."
fn nominal(flc: &[Sample], clelc: &[Sample]) -> Result<Vec<Claim>, Error> {
    let mut claims = Vec::new();
    for i in 0..START.len() {
        let (flc, clelc) = (response(flc, i)?, response(clelc, i)?);
        let merits = [
            ("rise time", "s", flc.rise_time(), clelc.rise_time()),
            ("settling time", "s", flc.settling_time(), clelc.settling_time()),
            ("overshoot", "%", Some(flc.overshoot()), Some(clelc.overshoot())),
        ];
        for (merit, unit, flc, clelc) in merits {
            let precise =
                |value: Option<f64>| value.map_or("never".to_owned(), |v| format!("{v:.4}"));
            let smaller = matches!((flc, clelc), (Some(flc), Some(clelc)) if clelc < flc);
            claims.push(claim(
                format!("nominal {merit} of x{}", i + 1),
                "CLELC smaller than FLC",
                format!("CLELC {} {unit}, FLC {} {unit}", precise(clelc), precise(flc)),
                smaller,
            ));
        }
    }
    Ok(claims)
}

/// "The traditional FLC is not robust … CLELC … controls the system without any steady-state error. … the feedback control input
/// approaches to zero."
fn uncertain(flc: &[Sample], clelc: &[Sample]) -> Result<Vec<Claim>, Error> {
    let band = BAND * START[0].abs();
    let [flc_x1, clelc_x1] = [flc, clelc].map(|run| largest(run, |sample| sample.x[0]));
    let u_b = largest(clelc, |sample| sample.command.u_b);
    let u_n = largest(clelc, |sample| sample.command.u_n);
    let unlearned = largest(clelc, unlearned);
    let variation = relative_variation(clelc)?;
    Ok(vec![
        claim(
            "FLC under uncertainty",
            "not robust: x1 leaves its 2 % band",
            format!("max |x1| = {}", figure(flc_x1)),
            flc_x1 > band,
        ),
        claim(
            "CLELC under uncertainty",
            "no steady-state error: x1 stays in its 2 % band",
            format!("max |x1| = {}", figure(clelc_x1)),
            clelc_x1 <= band,
        ),
        claim(
            "the learned term takes over",
            "u_n = -Δ, to 2 % of its size",
            format!("max |u_n + Δ| = {} of max |u_n| = {}", figure(unlearned), figure(u_n)),
            unlearned <= BAND * u_n,
        ),
        claim(
            "the feedback approaches zero",
            "u_b = 0, to 2 % of u_n",
            format!("max |u_b| = {} of max |u_n| = {}", figure(u_b), figure(u_n)),
            u_b <= BAND * u_n,
        ),
        claim(
            "no chattering (implicit sign)",
            "u_n moves no more than Δ does, to 10 %",
            format!("TV(u_n) = {} TV(Δ)", figure(variation)),
            variation <= 1.1,
        ),
    ])
}

/// "The finite time is found as t_h ≤ 4.5 seconds", and the remark that the smoothed sign reduces chattering.
fn theory(clelc: &[Sample], rule: SlidingMode<f64>) -> anyhow::Result<Vec<Claim>> {
    let certificate = rule.certificate(PERIOD, BOUND)?;
    let s0 = clelc.first().map_or(0.0, |sample| sample.command.s);
    let bound = certificate.reaching_time(s0)?;
    let residual = certificate.residual().unwrap_or(0.0);
    let found = reached(clelc, residual);
    let states = (0..START.len())
        .map(|i| Ok(response(clelc, i)?.settling_time()))
        .collect::<Result<Option<Vec<f64>>, Error>>()?;
    let slowest = states.and_then(|times| times.into_iter().reduce(f64::max));

    let smoothed = Switching::Explicit { delta: DELTA };
    let explicit = rule.with_switching(smoothed)?;
    let ratio = Certificate::new(ALPHA, smoothed, PERIOD, BOUND)?.step_ratio();
    let variation = relative_variation(&simulate(BackwardDifference::new(), explicit, PERIOD)?)?;
    let within = |time: Option<f64>| time.zip(bound).is_some_and(|(time, bound)| time <= bound);
    Ok(vec![
        claim(
            "bound on the reaching time",
            "t_h = 4.5 s",
            format!("{} s from |s(0)| = {}", figure_if(bound), figure(s0.abs())),
            bound.is_some_and(|bound| (bound - 4.5).abs() < 1e-9),
        ),
        claim(
            "s reaches zero in finite time",
            "within t_h",
            format!("|s| ≤ {} from {} s on", figure(residual), figure_if(found)),
            within(found),
        ),
        claim(
            "the states converge",
            "within t_h",
            format!("2 % settling of the slowest: {} s", figure_if(slowest)),
            within(slowest),
        ),
        claim(
            "δ = 0.05 reduces chattering (the paper's sign, explicit Euler)",
            "u_n moves no more than Δ does, to 10 %",
            format!("αh/δ = {ratio}: TV(u_n) = {} TV(Δ)", figure(variation)),
            variation <= 1.1,
        ),
    ])
}
