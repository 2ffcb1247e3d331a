//! The paper's four figures: the states under both controllers, and the control signals of CLELC.

use std::path::Path;

use brunovsky::plot::{BLACK, BLUE, Dash, Draw, Figure, Line, Stroke, VERMILION};

use super::{END, SWITCHED_ON, Sample, uncertainty};

fn points(run: &[Sample], f: impl Fn(&Sample) -> f64) -> impl Iterator<Item = (f64, f64)> {
    run.iter().map(move |sample| (sample.t, f(sample)))
}

/// Draws `x1.svg` to `x3.svg` and `control.svg` into `out`.
pub fn draw(out: &Path, flc: &[Sample], clelc: &[Sample]) -> anyhow::Result<()> {
    let over_time = |label: &str, range| {
        Figure::over_time(label).x_range(0.0..END).y_range(range).event(SWITCHED_ON, "Δ sets in")
    };
    let states = [("x₁", -0.3..1.1), ("x₂", -2.0..1.2), ("x₃", -11.0..7.0)];
    for (i, (name, range)) in states.into_iter().enumerate() {
        over_time(&format!("state {name}"), range)
            .line(
                Line::new("FLC", points(flc, |s| s.x[i]))
                    .stroke(Stroke::new(VERMILION, Dash::Dashed)),
            )
            .line(
                Line::new("CLELC", points(clelc, |s| s.x[i]))
                    .stroke(Stroke::new(BLUE, Dash::Solid)),
            )
            .save(out.join(format!("x{}.svg", i + 1)))?;
    }
    // The feedback starts far outside this range; its label says so, and the rest stays legible.
    let start = clelc.first().map_or(0.0, |sample| sample.command.u_b);
    let feedback =
        Line::new(format!("feedback u_b (from {start})"), points(clelc, |s| s.command.u_b));
    let learned = Line::new("learned u_n", points(clelc, |s| s.command.u_n));
    let truth = Line::new("−Δ", points(clelc, |s| -uncertainty(s.t)));
    over_time("shares of the control", -8.0..12.0)
        .line(feedback.stroke(Stroke::new(VERMILION, Dash::DashDot)))
        .line(learned.stroke(Stroke::new(BLUE, Dash::Solid)))
        .line(truth.stroke(Stroke::new(BLACK, Dash::Dashed)))
        .save(out.join("control.svg"))?;
    Ok(())
}
