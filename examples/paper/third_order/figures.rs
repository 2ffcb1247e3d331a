//! The paper's four figures: the states under both controllers, and the control signals of CLELC.

use std::{ops::Range, path::Path};

use super::{END, SWITCHED_ON, Sample, uncertainty};
use crate::plot::{BLACK, BLUE, GREY, Line, VERMILION, over_time};

fn points(run: &[Sample], f: impl Fn(&Sample) -> f64) -> Vec<(f64, f64)> {
    run.iter().map(|sample| (sample.t, f(sample))).collect()
}

/// A vertical line where Δ sets in.
fn onset(range: &Range<f64>) -> Line<'static> {
    let points = vec![(SWITCHED_ON, range.start), (SWITCHED_ON, range.end)];
    Line::new("Δ sets in", GREY, points)
}

/// Draws `x1.svg` to `x3.svg` and `control.svg` into `out`.
pub fn draw(out: &Path, flc: &[Sample], clelc: &[Sample]) -> anyhow::Result<()> {
    let ranges = [-0.3..1.1, -2.0..1.2, -11.0..7.0];
    for (i, range) in ranges.into_iter().enumerate() {
        let number = i + 1;
        let file = out.join(format!("x{number}.svg"));
        let lines = [
            onset(&range),
            Line::new("FLC", VERMILION, points(flc, |sample| sample.x[i])).dashed(),
            Line::new("CLELC", BLUE, points(clelc, |sample| sample.x[i])),
        ];
        over_time(&file, &format!("state x{number}"), 0.0..END, range, &lines)?;
    }
    // The feedback starts far outside this range; its label says so, and the rest stays legible.
    let range = -8.0..12.0;
    let start = clelc.first().map_or(0.0, |sample| sample.command.u_b);
    let feedback = format!("feedback u_b (from {start})");
    let lines = [
        onset(&range),
        Line::new(&feedback, VERMILION, points(clelc, |sample| sample.command.u_b)),
        Line::new("learned u_n", BLUE, points(clelc, |sample| sample.command.u_n)),
        Line::new("−Δ", BLACK, points(clelc, |sample| -uncertainty(sample.t))).dashed(),
    ];
    let file = out.join("control.svg");
    over_time(&file, "shares of the control", 0.0..END, range, &lines)
}
