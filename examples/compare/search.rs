//! The same search for every controller, on the plant that it knows.
//!
//! It minimizes the integral of the error over a run with a load on the input, among those parameters under which the input does not move more
//! than twice as much as under feedback linearization with the plant's usual λ: the noise has to be lived with.

use brunovsky::{
    ensemble::{Axis, Design, Run, Sweep},
    prelude::*,
};

use crate::{
    contestants::{Contestant, MOST, Point},
    worlds::{Row, Trial, World},
};

/// How much more the input may move.
const ACTIVITY: f64 = 2.0;
/// The tries are made in as many rounds, each in a box around the best so far, of such a share of the ranges.
const ROUNDS: [f64; 5] = [1.0, 0.5, 0.25, 0.12, 0.06];

/// The integral of the error, and the total variation of the input.
pub fn cost(rows: &[Row]) -> Result<[f64; 2], Error> {
    let error = ErrorMetrics::of(rows.iter().map(|row| (row.t, row.error)))?.iae();
    Ok([error, TotalVariation::of(rows.iter().map(|row| row.u))?])
}

/// The best of `tries` points for `contestant`, if there is one under which the plant is not lost.
pub fn best<const N: usize>(
    world: &dyn World<N>,
    contestant: &Contestant<N>,
    variation: f64,
    tries: u32,
) -> Result<Option<Point>, Error> {
    let mut best: Option<(f64, Point)> = None;
    for share in ROUNDS {
        let middle = best.map_or([0.5; MOST], |(_, point)| point);
        let axes = middle.map(|middle| {
            let low = (middle - 0.5 * share).clamp(0.0, 1.0 - share);
            Axis::linear("share of the range", low, low + share)
        });
        let [a, b, c, d, e, f] = axes;
        let design =
            Design::latin_hypercube([a?, b?, c?, d?, e?, f?], tries / ROUNDS.len() as u32, 1)?;
        let sweep = Sweep::new(design, 1, 0, ["cost"], |point: Point, _: Run| {
            let make = || contestant.at(&point);
            let [error, moves] = cost(&world.run(&make, contestant.sees_output, Trial::Search)?)?;
            // What moves too much is worse by the square of that.
            Ok::<_, Error>([error * (moves / (ACTIVITY * variation)).max(1.0).powi(2)])
        })?;
        for (point, runs) in sweep.map().cells() {
            for (_, [cost]) in runs.completed() {
                if best.is_none_or(|(least, _)| *cost < least) {
                    best = Some((*cost, *point));
                }
            }
        }
    }
    Ok(best.map(|(_, point)| point))
}
