//! The experiments of the paper: runs them, prints its claims beside what was measured, and writes the data and the figures.
//!
//! E. Kayacan, "Closed-loop error learning control for uncertain nonlinear systems with experimental validation on a mobile
//! robot", IEEE/ASME Transactions on Mechatronics 24(5), 2019.

mod claims;
mod mobile_robot;
mod third_order;

use std::{fs, path::PathBuf};

use clap::{Parser, ValueEnum};

/// Runs the experiments of the paper on closed-loop error learning control.
#[derive(Parser)]
struct Arguments {
    /// The experiment to run; all of them if none is named.
    experiment: Option<Experiment>,

    /// Where to write the data and the figures.
    #[arg(long, default_value = "target/paper")]
    out: PathBuf,

    /// How many times the robot meets another ground, under each controller.
    #[arg(long, default_value_t = 40)]
    runs: u64,

    /// A folder in which these runs are kept, and from which they are resumed.
    #[arg(long)]
    record: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Experiment {
    /// The simulation of a third-order nonlinear system.
    ThirdOrder,
    /// The tracked robot.
    MobileRobot,
    /// The tracked robot on random ground: an ensemble.
    RandomGround,
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    let wanted = |experiment| arguments.experiment.is_none_or(|only| only == experiment);
    fs::create_dir_all(&arguments.out)?;

    let mut claims = Vec::new();
    if wanted(Experiment::ThirdOrder) {
        claims.extend(third_order::run(&arguments.out.join("third_order"))?);
    }
    if wanted(Experiment::MobileRobot) {
        claims.extend(mobile_robot::run(&arguments.out.join("mobile_robot"))?);
    }
    if wanted(Experiment::RandomGround) {
        mobile_robot::run_random(arguments.runs, arguments.record.as_deref())?;
    }
    if !claims.is_empty() {
        println!("{}\n", claims::table(&claims));
        claims::write(&arguments.out.join("claims.csv"), &claims)?;
        println!("Data and figures are in {}.", arguments.out.display());
    }
    Ok(())
}
