//! A picture for each plant: the errors of some of the controllers on the way, and below what remains of them under Δ.

use std::path::Path;

use brunovsky::plot::{
    BLACK, BLUE, Dash, Draw, Figure, GREEN, Line, ORANGE, PURPLE, SKY, Stroke, VERMILION,
};

use crate::{
    Entry,
    worlds::{About, World},
};

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

/// What the lower panel shows, in terms of the largest error there under feedback linearization alone; larger ones leave it.
const SHOWN: f64 = 1.5;

/// Draws both into the folder `out`.
pub fn draw<const N: usize>(
    out: &Path,
    world: &dyn World<N>,
    entries: &[Entry],
) -> anyhow::Result<()> {
    let About { name, error, story, .. } = world.about();
    let label = format!("error: {error}");
    let mut start = Figure::over_time(&label).x_range(0.0..story.switched);
    let mut rest = Figure::over_time(&label).x_range(story.switched..story.end);
    let flc = entries.iter().find(|entry| entry.name == "FLC").and_then(|e| e.result.as_ref());
    if let Some((_, rows)) = flc {
        let after = rows.iter().filter(|row| row.t >= story.switched);
        let largest = SHOWN * after.map(|row| row.step.abs()).fold(0.0, f64::max);
        rest = rest.y_range(-largest..largest);
    }
    for (name, stroke) in DRAWN {
        let Some(entry) = entries.iter().find(|entry| entry.name == name) else { continue };
        let Some((_, rows)) = &entry.result else { continue };
        let line = |from: f64, to: f64| {
            let points = rows.iter().filter(move |row| (from..=to).contains(&row.t));
            Line::new(name, points.map(|row| (row.t, row.step))).stroke(stroke)
        };
        start = start.line(line(0.0, story.switched));
        rest = rest.line(line(story.switched, story.end));
    }
    [start, rest].save(out.join(name.replace(' ', "_")).with_extension("svg"))?;
    Ok(())
}
