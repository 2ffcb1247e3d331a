//! A picture for each plant: the errors of some of the controllers.

use std::path::Path;

use brunovsky::plot::{
    BLACK, BLUE, Dash, Draw, Figure, GREEN, Line, ORANGE, PURPLE, SKY, Stroke, VERMILION,
};

use crate::{Entry, worlds::World};

/// Who is drawn, and how.
const DRAWN: [(&str, Stroke); 7] = [
    ("PID", Stroke::new(BLACK, Dash::Dotted)),
    ("FLC", Stroke::new(VERMILION, Dash::Dashed)),
    ("ADRC", Stroke::new(GREEN, Dash::Dashed)),
    ("MRAC", Stroke::new(PURPLE, Dash::Dotted)),
    ("sliding mode, boundary layer", Stroke::new(ORANGE, Dash::Solid)),
    ("super-twisting", Stroke::new(SKY, Dash::Solid)),
    ("CLELC", Stroke::new(BLUE, Dash::Solid)),
];

/// Draws the step responses and, larger, what remains under the uncertainty.
pub fn draw<const N: usize>(
    out: &Path,
    world: &dyn World<N>,
    entries: &[Entry],
) -> anyhow::Result<()> {
    let story = world.story();
    let [quantity, _] = world.units();
    let label = format!("error: {quantity}");
    let mut start = Figure::over_time(&label).x_range(0.0..story.switched);
    let mut rest = Figure::over_time(&label).x_range(story.switched..story.end);
    for (name, stroke) in DRAWN {
        let Some(entry) = entries.iter().find(|entry| entry.name == name) else { continue };
        let Some((_, _, rows)) = &entry.result else { continue };
        let line = |from: f64, to: f64| {
            let points = rows.iter().filter(move |row| (from..=to).contains(&row.t));
            Line::new(name, points.map(|row| (row.t, row.step))).stroke(stroke)
        };
        start = start.line(line(0.0, story.switched));
        rest = rest.line(line(story.switched, story.end));
    }
    let name = world.name().replace(' ', "_");
    [start, rest].save(out.join(name).with_extension("svg"))?;
    Ok(())
}
