//! Every controller of the crate on four plants, tuned with the same effort, in one table.
//!
//! `cargo run --release --example compare`

mod contestants;
mod figures;
mod merits;
mod search;
mod table;
mod worlds;

use std::{fs, path::PathBuf};

use brunovsky::prelude::*;
use clap::Parser;
use contestants::Point;
use merits::Merits;
use worlds::{FlexibleJointWorld, PendulumWorld, RobotWorld, Row, ThirdOrderWorld, Trial, World};

/// Compares all controllers.
#[derive(Parser)]
struct Arguments {
    /// How many parameters are tried for each controller on each plant.
    #[arg(long, default_value_t = 400)]
    tries: u32,
    /// Only the plants whose name contains this.
    #[arg(long, default_value = "")]
    only: String,
    /// Where to draw.
    #[arg(long, default_value = "target/compare")]
    out: PathBuf,
}

/// What became of a controller on a plant.
struct Entry {
    name: &'static str,
    knows: &'static str,
    /// Its parameters, figures and run, unless it lost the plant.
    result: Option<(Vec<(&'static str, f64)>, Merits, Vec<Row>)>,
    /// The time of a step in ns.
    time: Option<f64>,
}

/// The parameter λ at its usual value, in the middle of its range.
const USUAL: Point = [0.5; contestants::MOST];

fn compare<const N: usize>(world: &dyn World<N>, tries: u32) -> anyhow::Result<Vec<Entry>> {
    let contestants = world.contestants();
    let flc = contestants.iter().find(|contestant| contestant.name == "FLC");
    let flc = flc.ok_or(Error::Missing { name: "FLC" })?;
    let usual = world.run(&|| flc.at(&USUAL), false, Trial::Search)?;
    let [_, variation] = search::cost(&usual)?;
    let mut entries = Vec::new();
    for contestant in &contestants {
        let best = search::best(world, contestant, variation, tries)?;
        let mut entry =
            Entry { name: contestant.name, knows: contestant.knows, result: None, time: None };
        if let Some(point) = best {
            let time = merits::nanoseconds(&mut contestant.at(&point)?, world.period())?;
            entry.time = Some(time);
            let run = world.run(&|| contestant.at(&point), contestant.sees_output(), Trial::Test);
            if let Ok(rows) = run {
                let merits = Merits::of(&rows, world.story())?;
                entry.result = Some((contestant.parameters(&point), merits, rows));
            }
        }
        entries.push(entry);
    }
    Ok(entries)
}

fn main() -> anyhow::Result<()> {
    let Arguments { tries, only, out } = Arguments::parse();
    fs::create_dir_all(&out)?;
    let mut table = table::headed();
    macro_rules! on {
        ($($world:expr),*) => {$(
            if $world.name().contains(&only) {
                let entries = compare(&$world, tries)?;
                table::add(&mut table, $world.name(), &entries);
                figures::draw(&out, &$world, &entries)?;
            }
        )*};
    }
    on!(ThirdOrderWorld, PendulumWorld, FlexibleJointWorld, RobotWorld);
    println!("{tries} tries for each controller on each plant\n\n{table}");
    println!("\nFigures are in {}.", out.display());
    Ok(())
}
