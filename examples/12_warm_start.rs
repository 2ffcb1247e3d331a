//! A controller goes on with what it has learned after the power was off: saved as text by one process, loaded by another.

use std::{env, fs, process::Command};

use anyhow::{Context, ensure};
use brunovsky::{plant::Pendulum, prelude::*};

const FILE: &str = "target/warm_start.json";

type Learner = NeuroFuzzy<FuzzyNetwork<f64, 2, 3>, ModelAided<f64>, SlidingMode<f64>>;
type Loop = Clelc<Pendulum<f64>, Learner, 2>;

/// A controller that has learned nothing yet.
fn new() -> Result<Loop, Error> {
    let believed = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
    let flc = FeedbackLinearization::new(believed, Gains::from_lambda(4.0)?);
    let network = FuzzyNetwork::evenly_spaced([2.0, 4.0])?;
    let learner = NeuroFuzzy::new(network, ModelAided::new(), SlidingMode::new(20.0)?);
    Ok(Clelc::new(flc, learner))
}

/// How far a pendulum sags within 5 s, in rad, that is to be held horizontal and carries half as much again as the controller believes.
fn sag(controller: &mut Loop) -> Result<f64, Error> {
    let horizontal = core::f64::consts::FRAC_PI_2;
    let carrying = Pendulum::new(1.5, 0.5, 0.1, 9.81)?;
    let hold = |_t| Reference::setpoint(horizontal);
    let run = Simulation::new(&carrying, controller, hold, [horizontal, 0.0], 0.005)?;
    run.until(5.0)?.try_fold(0.0, |most: f64, sample| Ok(most.max(horizontal - sample?.x[0])))
}

fn first_day() -> anyhow::Result<()> {
    let mut controller = new()?;
    println!("first day, nothing learned:    sags by {:.17} rad", sag(&mut controller)?);
    let text = serde_json::to_string_pretty(&controller)?;
    fs::create_dir_all("target")?;
    fs::write(FILE, &text)?;
    let bytes = postcard::to_stdvec(&controller)?;
    println!("saved in {FILE}: {} bytes, {} as postcard", text.len(), bytes.len());

    let next_day = Command::new(env::current_exe()?).arg(FILE).status()?;
    ensure!(next_day.success(), "the next day failed");
    println!("had the power stayed on:       sags by {:.17} rad", sag(&mut controller)?);
    Ok(())
}

fn next_day(file: &str) -> anyhow::Result<()> {
    let text = fs::read_to_string(file)?;
    let mut warm: Loop = serde_json::from_str(&text)?;
    println!("next day, in a new process:    sags by {:.17} rad", sag(&mut warm)?);

    let damaged = text.replacen("\"alpha\": ", "\"alpha\": -", 1);
    let refused =
        serde_json::from_str::<Loop>(&damaged).err().context("a negative α was loaded")?;
    println!("a file with a negative α is refused: {refused}");
    Ok(())
}

fn main() -> anyhow::Result<()> {
    match env::args().nth(1) {
        None => first_day(),
        Some(file) => next_day(&file),
    }
}
