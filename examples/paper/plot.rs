//! Line plots over time, as SVG.

use std::path::Path;

use plotters::prelude::*;

/// One line of a plot: a label for the legend, a colour, and points (t, y).
pub struct Line<'a> {
    label: &'a str,
    colour: RGBColor,
    points: Vec<(f64, f64)>,
    dashed: bool,
}

impl<'a> Line<'a> {
    /// A solid line.
    pub fn new(label: &'a str, colour: RGBColor, points: Vec<(f64, f64)>) -> Self {
        Self { label, colour, points, dashed: false }
    }

    /// The same line, dashed.
    pub fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }
}

/// Colours that stay apart for colour-blind readers and in grey print (M. Okabe, K. Ito).
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
/// The second of them.
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
/// For lines that lie on others.
pub const BLACK: RGBColor = RGBColor(0, 0, 0);
/// For what is not a result: references and marks.
pub const GREY: RGBColor = RGBColor(110, 110, 110);

/// Draws `lines` over `time` into an SVG file; `y_label` names quantity and unit, `y` is the range shown.
pub fn over_time(
    path: &Path,
    y_label: &str,
    time: std::ops::Range<f64>,
    y: std::ops::Range<f64>,
    lines: &[Line],
) -> anyhow::Result<()> {
    let area = SVGBackend::new(path, (760, 430)).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(14)
        .x_label_area_size(46)
        .y_label_area_size(68)
        .build_cartesian_2d(time, y)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY.mix(0.25))
        .x_label_formatter(&|t| t.to_string())
        .x_desc("time t in s")
        .y_desc(y_label)
        .label_style(("sans-serif", 15))
        .axis_desc_style(("sans-serif", 16))
        .draw()?;
    for line in lines {
        let style = line.colour.stroke_width(2);
        let points = line.points.iter().copied();
        let drawn = if line.dashed {
            chart.draw_series(DashedLineSeries::new(points, 7, 5, style))?
        } else {
            chart.draw_series(LineSeries::new(points, style))?
        };
        let dashed = line.dashed;
        drawn.label(line.label).legend(move |(x, y)| {
            let gap = if dashed { 5 } else { 0 };
            plotters::element::DashedPathElement::new([(x, y), (x + 26, y)], 7, gap, style)
        });
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.9))
        .border_style(GREY.mix(0.5))
        .label_font(("sans-serif", 15))
        .draw()?;
    area.present()?;
    Ok(())
}
