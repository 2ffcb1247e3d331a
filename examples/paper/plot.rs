//! Line plots over time and in the plane, as SVG.

use std::{ops::Range, path::Path};

use plotters::{coord::types::RangedCoordf64, element::DashedPathElement, prelude::*};

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

    /// The part of the line that lies in a region.
    fn within(&self, inside: impl Fn(&(f64, f64)) -> bool) -> Self {
        Self { points: self.points.iter().copied().filter(inside).collect(), ..*self }
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

/// Where a robot is and where it looks.
pub struct Pose {
    /// The position in m.
    pub at: (f64, f64),
    /// The heading in rad.
    pub heading: f64,
    /// The colour of the robot.
    pub colour: RGBColor,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Draws `lines` over `time` into an SVG file; `y_label` names quantity and unit, `y` is the range shown.
pub fn over_time(
    path: &Path,
    y_label: &str,
    time: Range<f64>,
    y: Range<f64>,
    lines: &[Line],
) -> anyhow::Result<()> {
    let area = SVGBackend::new(path, (760, 430)).into_drawing_area();
    let mut chart = axes(&area, ["time t in s", y_label], [time, y])?;
    draw(&mut chart, lines)?;
    legend(&mut chart)?;
    area.present()?;
    Ok(())
}

/// Draws `lines` in the plane, one metre as long up as across, with robots at `poses` and named `marks`.
pub fn in_plane(
    path: &Path,
    lines: &[Line],
    poses: &[Pose],
    marks: &[(&str, (f64, f64))],
) -> anyhow::Result<()> {
    let points = || lines.iter().flat_map(|line| &line.points);
    let x =
        points().fold(0.0..0.0, |range: Range<f64>, p| range.start.min(p.0)..range.end.max(p.0));
    let y =
        points().fold(0.0..0.0, |range: Range<f64>, p| range.start.min(p.1)..range.end.max(p.1));
    plane(path, lines, poses, marks, [x.start - 3.0..x.end + 3.0, y.start - 3.0..y.end + 8.0], 2.0)
}

/// The same within `reach` metres about a point.
pub fn close_up(
    path: &Path,
    lines: &[Line],
    poses: &[Pose],
    (x, y): (f64, f64),
    reach: f64,
) -> anyhow::Result<()> {
    let ranges = [x - 1.7 * reach..x + 1.7 * reach, y - reach..y + reach];
    plane(path, lines, poses, &[], ranges, 0.2 * reach)
}

fn plane(
    path: &Path,
    lines: &[Line],
    poses: &[Pose],
    marks: &[(&str, (f64, f64))],
    [x, y]: [Range<f64>; 2],
    size: f64,
) -> anyhow::Result<()> {
    // 96 and 74 pixels are for margins and labels.
    let height = (760.0 - 96.0) * (y.end - y.start) / (x.end - x.start) + 74.0;
    let area = SVGBackend::new(path, (760, height as u32)).into_drawing_area();
    let mut chart = axes(&area, ["x in m", "y in m"], [x.clone(), y.clone()])?;
    let inside = |p: &(f64, f64)| x.contains(&p.0) && y.contains(&p.1);
    let lines: Vec<_> = lines.iter().map(|line| line.within(inside)).collect();
    draw(&mut chart, &lines)?;
    for pose in poses.iter().filter(|pose| inside(&pose.at)) {
        let corner = |ahead: f64, aside: f64| {
            let (sin, cos) = pose.heading.sin_cos();
            let (x, y) = pose.at;
            (x + size * (ahead * cos - aside * sin), y + size * (ahead * sin + aside * cos))
        };
        let outline =
            vec![corner(0.6, 0.0), corner(-0.4, 0.35), corner(-0.4, -0.35), corner(0.6, 0.0)];
        chart.draw_series([Polygon::new(outline, pose.colour.mix(0.6))])?;
    }
    for (name, at) in marks {
        chart.draw_series([EmptyElement::at(*at)
            + Circle::new((0, 0), 4, BLACK.filled())
            + Text::new((*name).to_owned(), (6, -18), ("sans-serif", 15))])?;
    }
    legend(&mut chart)?;
    area.present()?;
    Ok(())
}

fn axes<'a, 'b>(
    area: &'a Area<'b>,
    [x_label, y_label]: [&str; 2],
    [x, y]: [Range<f64>; 2],
) -> anyhow::Result<Chart<'a, 'b>> {
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(area)
        .margin(14)
        .x_label_area_size(46)
        .y_label_area_size(68)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY.mix(0.25))
        .x_label_formatter(&|t| t.to_string())
        .x_desc(x_label)
        .y_desc(y_label)
        .label_style(("sans-serif", 15))
        .axis_desc_style(("sans-serif", 16))
        .draw()?;
    Ok(chart)
}

fn draw<'a, 'b: 'a>(chart: &mut Chart<'a, 'b>, lines: &[Line]) -> anyhow::Result<()> {
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
            DashedPathElement::new([(x, y), (x + 26, y)], 7, gap, style)
        });
    }
    Ok(())
}

fn legend<'a, 'b: 'a>(chart: &mut Chart<'a, 'b>) -> anyhow::Result<()> {
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.9))
        .border_style(GREY.mix(0.5))
        .label_font(("sans-serif", 15))
        .draw()?;
    Ok(())
}
