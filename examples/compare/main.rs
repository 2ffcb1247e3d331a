//! Every controller of the crate on four plants, tuned with the same effort, in one table.
//!
//! Each plant first is what its model says. A search finds the parameters of each law there: the same number of tries for all, the same sensor
//! noise and limits of the input, and a constant load in place of the uncertainty that comes in the test. What the search minimizes, and how
//! much the input may move meanwhile, is said in [`search`].

mod contestants;
mod figures;
mod merits;
mod search;
mod table;
mod worlds;

use std::{fs, path::PathBuf};

use brunovsky::prelude::*;
use clap::Parser;
use contestants::{Contestant, Point};
use merits::Merits;
use worlds::{
    About, FlexibleJointWorld, PendulumWorld, RobotWorld, Row, ThirdOrderWorld, Trial, World,
};

/// Compares all controllers.
#[derive(Parser)]
struct Arguments {
    /// How many parameters are tried for each controller on each plant.
    #[arg(long, default_value_t = 400, value_parser = clap::value_parser!(u32).range(10..))]
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
    /// The parameters that were found, if any keep the plant.
    found: Vec<(&'static str, f64)>,
    /// The figures and the run, unless the plant was lost.
    result: Option<(Merits, Vec<Row>)>,
    /// The time of a step in ns.
    time: Option<f64>,
}

/// The parameter λ at its usual value, in the middle of its range.
const USUAL: Point = [0.5; contestants::MOST];

fn compare<const N: usize>(world: &dyn World<N>, tries: u32) -> anyhow::Result<Vec<Entry>> {
    let About { period, story, .. } = world.about();
    let contestants = world.contestants()?;
    let flc = contestants.iter().find(|contestant| contestant.name == "FLC");
    let flc = flc.ok_or(Error::Missing { name: "FLC" })?;
    let usual = world.run(&|| flc.at(&USUAL), false, Trial::Search)?;
    let [_, variation] = search::cost(&usual)?;
    let entry = |contestant: &Contestant<N>| -> anyhow::Result<Entry> {
        let &Contestant { name, knows, .. } = contestant;
        let best = search::best(world, contestant, variation, tries)?;
        let Some(point) = best else {
            return Ok(Entry { name, knows, found: Vec::new(), result: None, time: None });
        };
        let run = world.run(&|| contestant.at(&point), contestant.sees_output, Trial::Test);
        let judged = |rows: Vec<Row>| Ok::<_, Error>((Merits::of(&rows, story)?, rows));
        Ok(Entry {
            name,
            knows,
            found: contestant.parameters(&point),
            result: run.ok().map(judged).transpose()?,
            time: Some(merits::nanoseconds(&mut contestant.at(&point)?, period)?),
        })
    };
    contestants.iter().map(entry).collect()
}

fn main() -> anyhow::Result<()> {
    let Arguments { tries, only, out } = Arguments::parse();
    fs::create_dir_all(&out)?;
    let mut table = table::headed();
    let mut found = Vec::new();
    // Their chains are of different order, so they do not fit in one list.
    macro_rules! on {
        ($($world:ident),*) => {$(
            let name = $world.about().name;
            if name.contains(&only) {
                let entries = compare(&$world, tries)?;
                table::add(&mut table, name, &entries);
                figures::draw(&out, &$world, &entries)?;
                found.push((name, entries));
            }
        )*};
    }
    on!(ThirdOrderWorld, PendulumWorld, FlexibleJointWorld, RobotWorld);
    table::write(&out.join("parameters.csv"), &found)?;
    println!("{tries} tries for each controller on each plant\n\n{table}\n");
    println!("Figures, and the parameters that were found, are in {}.", out.display());
    Ok(())
}
