//! The robot on random ground, from a random start, under random noise.
//!
//! 10⁵ runs under each of three controllers take some 5 ms each; with a folder they can be interrupted and resumed:
//! `cargo run --release --example paper -- random-ground --runs 100000 --record target/random_ground`.

use std::{fs, path::Path};

use brunovsky::{
    controller::ChainControllers,
    ensemble::{
        Ensemble, Estimate, Run, Runs,
        rand::{Rng, RngExt},
    },
    prelude::*,
};
use comfy_table::Table;

use super::{
    Axes, DELTA, Field, GROUND, Ground, Path2, RECOMMENDED_DELTA, YAW_RATE, clelc, field, flc,
    merits::{DIVERGED, error_true, figures, on_track},
    path, rule, simulate,
};
use crate::claims::headed;

const SEED: u64 = 1;
const LEVEL: f64 = 0.95;

/// The study's ground with its mean tractions changed by up to ±0.05 and ±0.1, anywhere on it, up to 2 m beside the path.
fn random(run: &mut Run) -> Field {
    let ground = Ground {
        longitudinal: GROUND.longitudinal + run.random_range(-0.05..0.05),
        yaw: GROUND.yaw + run.random_range(-0.1..0.1),
        side: GROUND.side + run.random_range(-0.05..0.05),
        origin: [run.random_range(-100.0..100.0), run.random_range(-100.0..100.0)],
    };
    Field { ground, offset: run.random_range(-2.0..2.0), ..field() }
}

/// `count` runs under the controllers `axes`, kept in a file of the folder `record` if there is one. A run that is ever too far off on track has failed.
fn runs(
    name: &str,
    axes: impl ChainControllers<f64, 2, 2, Commands = Axes> + Copy + Send + Sync,
    path: &Path2,
    count: u64,
    record: Option<&Path>,
) -> anyhow::Result<Runs<3>> {
    let names = ["true error in m", "ω saturated", "TV(ω) in rad/s²"];
    let ensemble = Ensemble::new(SEED, names, |mut run: Run| {
        let field = random(&mut run);
        let samples = simulate(axes, path, field, run.next_u64())?;
        let farthest = on_track(&samples).map(error_true).fold(0.0, f64::max);
        if farthest > DIVERGED {
            let name = "distance from the path in m";
            return Err(Error::NotBelow { name, value: farthest, limit: DIVERGED });
        }
        let [_, error_true, saturated, variation, _] = figures(&samples)?;
        Ok([error_true, saturated, variation])
    });
    let ensemble = ensemble.with_progress();
    Ok(match record {
        None => ensemble.runs(count),
        Some(folder) => ensemble.recorded(count, folder.join(name).with_extension("csv"), name)?,
    })
}

fn row(table: &mut Table, name: &str, runs: &Runs<3>) -> anyhow::Result<()> {
    let [error, saturated, variation] = runs.summaries(LEVEL)?;
    let failed = runs.failure_rate(LEVEL)?;
    let percent = |share: Estimate| {
        let [value, low, high] = [share.value, share.low, share.high].map(|share| 100.0 * share);
        format!("{:.2} %", Estimate { value, low, high })
    };
    table.add_row([
        name.to_owned(),
        format!("{:.4}", error.mean()?),
        format!("{:.4}", error.quantile(0.5)?),
        format!("{:.4}", error.quantile(0.95)?),
        error
            .worst()
            .map_or_else(String::new, |worst| format!("{:.3} (run {})", worst.value, worst.index)),
        percent(saturated.mean()?),
        format!("{:.3}", variation.mean()?),
        percent(failed),
    ]);
    Ok(())
}

/// Runs the ensemble under three controllers and prints its table; runs kept in the folder `record` are not made again.
pub fn run(count: u64, record: Option<&Path>) -> anyhow::Result<()> {
    if let Some(folder) = record {
        fs::create_dir_all(folder)?;
    }
    let path = path(YAW_RATE)?;
    let implicit = |delta| rule(Switching::Implicit { delta });
    let recommended = clelc(ModelAided::new(), implicit(RECOMMENDED_DELTA)?)?;
    let paper = clelc(ModelAided::new(), implicit(DELTA)?)?;
    let all = [
        ("FLC", runs("flc", flc()?, &path, count, record)?),
        ("CLELC, δ = 2", runs("clelc", recommended, &path, count, record)?),
        ("CLELC, δ = 0.05", runs("clelc_paper_delta", paper, &path, count, record)?),
    ];
    let mut table = headed([
        "random ground",
        "true error in m",
        "its median",
        "its 95 % quantile",
        "worst completed run",
        "ω saturated",
        "TV(ω) in rad/s²",
        "failed",
    ]);
    for (name, runs) in &all {
        row(&mut table, &format!("under {name}"), runs)?;
    }
    println!(
        "Mobile robot on random ground, {count} runs each, with 95 % intervals; failed: farther off than {DIVERGED} m on track\n"
    );
    println!("{table}\n");
    for (name, runs) in &all {
        for (index, reason) in runs.failures().take(3) {
            println!("{name}, run {index}: {reason}");
        }
    }
    println!();
    Ok(())
}
