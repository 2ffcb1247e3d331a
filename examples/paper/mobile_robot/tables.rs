//! The robot under every setting, and under every policy against windup.

use brunovsky::{
    controller::ChainControllers,
    ensemble::{Ensemble, Run},
    learning::{Bounded, Conditional},
    prelude::*,
};
use comfy_table::Table;

use super::{
    Axes, DELTA, Field, Path2, RECOMMENDED_DELTA, SEEDS, clelc, flc,
    merits::{FIGURES, Merits, figures},
    rule,
    sensors::Accuracy,
    simulate,
};
use crate::claims::headed;

/// The settings of the study, by name.
pub struct Settings {
    pub flc: Merits,
    pub explicit: Merits,
    pub ignoring: Merits,
    pub paper: Merits,
    pub recommended: Merits,
}

fn over_seeds(
    axes: impl ChainControllers<f64, 2, 2, Commands = Axes> + Copy + Send + Sync,
    path: &Path2,
    field: Field,
) -> anyhow::Result<Merits> {
    // The sensors have seeds of their own: those with which the ground was calibrated.
    let ensemble =
        Ensemble::new(0, FIGURES, |run: Run| figures(&simulate(axes, path, field, run.index())?));
    Merits::of(&ensemble.runs(SEEDS))
}

/// Runs every setting over all seeds.
pub fn settings(path: &Path2, field: Field) -> anyhow::Result<Settings> {
    let explicit = rule(Switching::Explicit { delta: DELTA })?;
    let implicit = rule(Switching::Implicit { delta: DELTA })?;
    let recommended = rule(Switching::Implicit { delta: RECOMMENDED_DELTA })?;
    let difference = BackwardDifference::new();
    Ok(Settings {
        flc: over_seeds(flc()?, path, field)?,
        explicit: over_seeds(clelc(difference, explicit)?, path, field)?,
        ignoring: over_seeds(clelc(difference, implicit)?, path, field)?,
        paper: over_seeds(clelc(ModelAided::new(), implicit)?, path, field)?,
        recommended: over_seeds(clelc(ModelAided::new(), recommended)?, path, field)?,
    })
}

/// The settings as a table.
pub fn of_settings(settings: &Settings) -> Table {
    let mut table = headed([
        "",
        "error in m",
        "true error in m",
        "worst run in m",
        "ω saturated",
        "TV(ω) in rad/s²",
        "diverged",
    ]);
    let rows = [
        ("FLC", settings.flc),
        ("CLELC, explicit sign, δ = 0.05, difference (the paper's)", settings.explicit),
        ("CLELC, implicit sign, δ = 0.05, difference", settings.ignoring),
        ("CLELC, implicit sign, δ = 0.05, model-aided", settings.paper),
        ("CLELC, implicit sign, δ = 2, model-aided (recommended)", settings.recommended),
    ];
    for (name, merits) in rows {
        table.add_row([
            name.to_owned(),
            format!("{:.4}", merits.error),
            format!("{:.4}", merits.error_true),
            format!("{:.4}", merits.worst),
            format!("{:.0} %", 100.0 * merits.saturated),
            format!("{:.3}", merits.variation),
            format!("{} of {SEEDS}", merits.diverged),
        ]);
    }
    table
}

/// Policies against windup, under limits that leave the drives room and limits that do not, at several noise levels.
pub fn policies(path: &Path2, field: Field) -> anyhow::Result<Table> {
    let mut table = headed([
        "limit in rad/s",
        "noise",
        "δ",
        "FLC",
        "ignore",
        "conditional",
        "model-aided",
        "bounded, 0.2 m/s²",
    ]);
    let cell = |merits: Merits| match merits.diverged {
        0 => format!("{:.3} ({:.0} %)", merits.error_true, 100.0 * merits.saturated),
        runs => format!("{runs} diverged"),
    };
    let difference = BackwardDifference::new();
    // A tenth of the acceleration v·ω that the limit of 0.1 rad/s allows at the reference speed.
    let conditional = Conditional::new(difference, 0.004)?;
    for limit in [1.0, 0.1, 0.07] {
        for noise in [0.3, 1.0, 2.0] {
            let Accuracy { speed, heading, .. } = field.accuracy;
            let accuracy =
                Accuracy { speed: noise * speed, heading: noise * heading, ..field.accuracy };
            let field = Field { accuracy, limit, ..field };
            let flc = cell(over_seeds(flc()?, path, field)?);
            for delta in [DELTA, RECOMMENDED_DELTA] {
                let rule = rule(Switching::Implicit { delta })?;
                table.add_row([
                    limit.to_string(),
                    format!("{noise} ×"),
                    delta.to_string(),
                    flc.clone(),
                    cell(over_seeds(clelc(difference, rule)?, path, field)?),
                    cell(over_seeds(clelc(conditional, rule)?, path, field)?),
                    cell(over_seeds(clelc(ModelAided::new(), rule)?, path, field)?),
                    cell(over_seeds(clelc(difference, Bounded::new(rule, 0.2)?)?, path, field)?),
                ]);
            }
        }
    }
    Ok(table)
}
