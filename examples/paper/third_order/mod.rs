//! The simulation study: a third-order system, nominal for 10 s and then under Δ = 5·sin t.

use std::{fs, path::Path};

use brunovsky::{
    controller::ClelcCommand,
    learning::{AdaptationRule, ErrorRate},
    plant::ThirdOrder,
    prelude::*,
    simulation::{self, Column, Recording},
};

use crate::claims::Claim;

mod claims;
mod figures;
mod merits;
mod tables;

const EXPERIMENT: &str = "third-order";
const START: [f64; 3] = [1.0, -1.0, -10.0];
const LAMBDA: f64 = 3.0;
const ALPHA: f64 = 25.0;
const DELTA: f64 = 0.05;
const PERIOD: f64 = 0.01;
const SWITCHED_ON: f64 = 10.0;
const END: f64 = 20.0;
/// From here on the response to the disturbance counts as steady: five seconds are fifteen time constants 1/λ.
const STEADY: f64 = 15.0;
/// The bound on |Δ̇| for Δ = 5·sin t.
const BOUND: f64 = 5.0;

/// The uncertainty Δ(t).
fn uncertainty(t: f64) -> f64 {
    if t >= SWITCHED_ON { 5.0 * t.sin() } else { 0.0 }
}

type Sample = simulation::Sample<f64, Reference<f64, 3>, ClelcCommand<f64>, 3, 1>;

/// One run of the study. Feedback linearization control is CLELC with a network that never learns: its s is then on record too.
fn simulate(
    error_rate: impl ErrorRate<f64, 3> + Clone,
    rule: impl AdaptationRule<FuzzyNetwork<f64, 3, 3>> + Clone,
    period: f64,
) -> Result<Vec<Sample>, Error> {
    let model = ThirdOrder::new();
    let plant = Uncertain::matched(model, |t: f64, _x: &_, _u: &_| uncertainty(t));
    let flc = FeedbackLinearization::new(model, Gains::from_lambda(LAMBDA)?);
    let network = FuzzyNetwork::<_, 3, 3>::evenly_spaced(START.map(|x| 2.0 * x.abs()))?;
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, error_rate, rule));
    Simulation::new(&plant, clelc, |_| Reference::setpoint(0.0), START, period)?
        .until(END)?
        .collect()
}

/// Runs the study, prints its tables, writes data and figures into `out`.
pub fn run(out: &Path) -> anyhow::Result<Vec<Claim>> {
    fs::create_dir_all(out)?;
    let rule = SlidingMode::new(ALPHA)?;
    let flc = simulate(BackwardDifference::new(), NullRule, PERIOD)?;
    let clelc = simulate(BackwardDifference::new(), rule, PERIOD)?;

    for (name, run) in [("flc", &flc), ("clelc", &clelc)] {
        recording(run).save(out.join(name).with_extension("csv"))?;
    }
    figures::draw(out, &flc, &clelc)?;
    println!("Third-order system, h = {PERIOD} s, ė_n by backward difference, set-valued sign\n");
    println!("{}\n", tables::comparison(&flc, &clelc)?);
    println!("The same under every source of ė_n and every discretization of the sign\n");
    println!("{}\n", tables::variants(rule)?);
    claims::judge(&flc, &clelc, rule)
}

/// The control samples, each with the input that the plant receives until the next.
fn recording(run: &[Sample]) -> Recording {
    let columns: [Column<Sample>; 11] = [
        ("t", |s| s.t),
        ("x1", |s| s.x[0]),
        ("x2", |s| s.x[1]),
        ("x3", |s| s.x[2]),
        ("r1", |s| s.reference.r[0]),
        ("u", |s| s.u[0]),
        ("u_f", |s| s.command.u_f),
        ("u_b", |s| s.command.u_b),
        ("u_n", |s| s.command.u_n),
        ("s", |s| s.command.s),
        ("delta", |s| uncertainty(s.t)),
    ];
    Recording::of(run, &columns)
}
