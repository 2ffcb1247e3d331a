//! FLC beside CLELC, and CLELC in all its variants.

use brunovsky::{learning::Fixed, prelude::*};
use comfy_table::Table;

use super::{
    ALPHA, DELTA, PERIOD, Sample,
    merits::{largest, relative_variation, response, steady, unlearned},
    simulate,
};
use crate::claims::headed;

/// Three significant digits.
pub fn figure(value: f64) -> String {
    let magnitude = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    format!("{value:.*}", (2.0 - magnitude).max(0.0) as usize)
}

/// The same for a figure that may not exist.
pub fn figure_if(value: Option<f64>) -> String {
    value.map_or("never".to_owned(), figure)
}

/// The figures of merit of feedback linearization and of CLELC.
pub fn comparison(flc: &[Sample], clelc: &[Sample]) -> Result<Table, Error> {
    let merits = |run| -> Result<[String; 8], Error> {
        let x1 = response(run, 0)?;
        let error = ErrorMetrics::of(steady(run).map(|sample| (sample.t, sample.x[0])))?;
        Ok([
            figure_if(x1.rise_time()),
            figure_if(x1.settling_time()),
            figure(x1.overshoot()),
            figure(error.maximum()),
            figure_if(error.rms()),
            figure(largest(run, |sample| sample.command.u_b)),
            figure(largest(run, |sample| sample.command.u_n)),
            figure(largest(run, unlearned)),
        ])
    };
    let names = [
        "nominal: rise time of x₁, 10–90 %, in s",
        "nominal: settling time of x₁, 2 %, in s",
        "nominal: overshoot of x₁, in %",
        "uncertain: max abs x₁",
        "uncertain: RMS of x₁",
        "uncertain: max abs u_b",
        "uncertain: max abs u_n",
        "uncertain: max abs (u_n + Δ)",
    ];
    let mut table = headed(["", "FLC", "CLELC"]);
    for ((name, flc), clelc) in names.into_iter().zip(merits(flc)?).zip(merits(clelc)?) {
        table.add_row([name, &flc, &clelc]);
    }
    Ok(table)
}

/// The discretizations of the sign and the sources of ė_n.
pub fn variants(rule: SlidingMode<f64>) -> Result<Table, Error> {
    let explicit = rule.with_switching(Switching::Explicit { delta: DELTA })?;
    let implicit = rule.with_switching(Switching::Implicit { delta: DELTA })?;
    let fixed = rule.with_antecedents(Fixed);
    let descent = GradientDescent::new(ALPHA)?;
    let difference = BackwardDifference::new();
    let filtered = FilteredDifference::new(2.0 * PERIOD)?;
    let fine = PERIOD / 10.0;
    let runs = [
        ("explicit", "measured", PERIOD, simulate(Measured, explicit, PERIOD)?),
        ("implicit", "measured", PERIOD, simulate(Measured, implicit, PERIOD)?),
        ("set-valued", "measured", PERIOD, simulate(Measured, rule, PERIOD)?),
        ("explicit", "difference", PERIOD, simulate(difference, explicit, PERIOD)?),
        ("implicit", "difference", PERIOD, simulate(difference, implicit, PERIOD)?),
        ("set-valued", "difference", PERIOD, simulate(difference, rule, PERIOD)?),
        ("set-valued", "difference", fine, simulate(difference, rule, fine)?),
        ("set-valued", "filtered, 20 ms", PERIOD, simulate(filtered, rule, PERIOD)?),
        ("set-valued", "model-aided", PERIOD, simulate(ModelAided::new(), rule, PERIOD)?),
        (
            "set-valued, antecedents fixed",
            "difference",
            PERIOD,
            simulate(difference, fixed, PERIOD)?,
        ),
        ("(gradient descent, 25/s)", "difference", PERIOD, simulate(difference, descent, PERIOD)?),
        ("(no learning: FLC)", "", PERIOD, simulate(difference, NullRule, PERIOD)?),
    ];
    let mut table = headed([
        "sign",
        "ė_n",
        "h in s",
        "max abs x₁",
        "TV(u_n)/TV(Δ)",
        "rise in s",
        "settling in s",
        "overshoot in %",
    ]);
    for (sign, source, period, run) in &runs {
        let x1 = response(run, 0)?;
        table.add_row([
            *sign,
            source,
            &period.to_string(),
            &figure(largest(run, |sample| sample.x[0])),
            &figure(relative_variation(run)?),
            &figure_if(x1.rise_time()),
            &figure_if(x1.settling_time()),
            &figure(x1.overshoot()),
        ]);
    }
    Ok(table)
}
