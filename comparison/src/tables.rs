//! What is printed.

use anyhow::Result;
use comfy_table::{Table, presets::NOTHING};

use crate::{
    measure::{Contender, Run, Work, times, work},
    problems::Problem,
};

/// One contender at all tolerances: its work and its time, where it arrived.
type Series = Vec<Option<(Work, f64)>>;

/// The first contender is the one that the others are compared with.
pub fn compare<P: Problem<N>, const N: usize>(contenders: &[Contender<N>]) -> Result<()> {
    println!("\n{}", P::NAME);
    let digits: Vec<i32> = P::DIGITS.collect();
    let mut all: Vec<Series> = contenders.iter().map(|_| vec![]).collect();
    for digits in &digits {
        let rtol = 10.0_f64.powi(-digits);
        let runs: Vec<Run<N>> = contenders.iter().map(|contender| contender.run).collect();
        let times = times(&runs, rtol);
        for ((run, series), time) in runs.into_iter().zip(&mut all).zip(times) {
            series.push(work::<P, N>(run, rtol).ok().map(|work| (work, time)));
        }
    }
    let mut table = Table::new();
    table.load_preset(NOTHING);
    table.set_header(["method", "rtol", "error", "f", "∂f/∂x", "µs", "time/ours"]);
    for (contender, series) in contenders.iter().zip(&all) {
        for ((digits, point), first) in digits.iter().zip(series).zip(&all[0]) {
            let mut row = vec![contender.name.to_owned(), format!("1e-{digits}")];
            match point {
                None => row.push("failed".to_owned()),
                Some((work, time)) => row.extend([
                    format!("{:.1e}", work.error),
                    work.rates.to_string(),
                    format!("{:.0}", work.jacobians),
                    format!("{:.1}", time * 1e6),
                    first.as_ref().map_or(String::new(), |(_, ours)| format!("{:.2}", time / ours)),
                ]),
            }
            table.add_row(row);
        }
    }
    println!("{table}\n");
    println!("{}", at_equal_error(contenders, &all));
    Ok(())
}

/// f and time for the errors 10⁻³, 10⁻⁴, …, by linear interpolation of the logarithms.
fn at_equal_error<const N: usize>(contenders: &[Contender<N>], all: &[Series]) -> Table {
    let mut table = Table::new();
    table.load_preset(NOTHING);
    table.set_header(["at equal error", "error", "f", "f/ours", "µs", "time/ours"]);
    for (contender, series) in contenders.iter().zip(all) {
        for digits in [3, 5, 7, 9] {
            let error = 10.0_f64.powi(-digits);
            let of = |series: &Series| {
                let rates = interpolated(series, error, |point| point.0.rates as f64)?;
                Some((rates, interpolated(series, error, |point| point.1)?))
            };
            if let (Some((rates, time)), Some(ours)) = (of(series), of(&all[0])) {
                table.add_row([
                    contender.name.to_owned(),
                    format!("1e-{digits}"),
                    format!("{rates:.0}"),
                    format!("{:.2}", rates / ours.0),
                    format!("{:.1}", time * 1e6),
                    format!("{:.2}", time / ours.1),
                ]);
            }
        }
    }
    table
}

/// Between the last point above the error and the next, which is below it.
fn interpolated(series: &Series, error: f64, of: impl Fn(&(Work, f64)) -> f64) -> Option<f64> {
    let points: Vec<_> = series.iter().flatten().collect();
    let above = points.iter().rposition(|point| point.0.error >= error)?;
    let (coarse, fine) = (points[above], points.get(above + 1)?);
    let part = (error / coarse.0.error).ln() / (fine.0.error / coarse.0.error).ln();
    Some((of(coarse).ln() + part * (of(fine) / of(coarse)).ln()).exp())
}
