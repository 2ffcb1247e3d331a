//! Two heat maps over the same axes with one colour bar, as SVG.

use std::{ops::Range, path::Path};

use plotters::{
    coord::Shift,
    prelude::*,
    style::{
        colors::colormaps::{ColorMap, ViridisRGB},
        text_anchor::{HPos, Pos, VPos},
    },
};

/// The axes: levels spaced by equal factors, and where theory has its border on the x axis.
pub struct HeatMap<'a> {
    pub x: &'a [f64],
    pub y: &'a [f64],
    pub border: f64,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const FONT: (&str, i32) = ("sans-serif", 15);

impl HeatMap<'_> {
    /// Draws two maps, each with its title and its values row by row; what is not finite stays grey.
    pub fn draw(&self, path: &Path, maps: [(&str, &Vec<f64>); 2]) -> anyhow::Result<()> {
        let area = SVGBackend::new(path, (1000, 430)).into_drawing_area();
        area.fill(&WHITE)?;
        let (maps_area, bar_area) = area.split_horizontally(880);
        let all = maps.iter().flat_map(|(_, values)| *values).filter(|value| value.is_finite());
        let range = all
            .fold(f64::INFINITY..0.0, |range, &value| range.start.min(value)..range.end.max(value));
        for (panel, (title, values)) in maps_area.split_evenly((1, 2)).iter().zip(maps) {
            self.panel(panel, title, values, &range)?;
        }
        bar(&bar_area, &range)?;
        area.present()?;
        Ok(())
    }

    fn panel(
        &self,
        area: &Area,
        title: &str,
        values: &[f64],
        range: &Range<f64>,
    ) -> anyhow::Result<()> {
        let (x_edges, y_edges) = (edges(self.x), edges(self.y));
        let mut chart = ChartBuilder::on(area)
            .margin(12)
            .caption(title, ("sans-serif", 18))
            .x_label_area_size(46)
            .y_label_area_size(64)
            .build_cartesian_2d(
                (first(&x_edges)..last(&x_edges)).log_scale().with_key_points(marks(self.x, 2.0)),
                (first(&y_edges)..last(&y_edges)).log_scale().with_key_points(decades(self.y)),
            )?;
        let rows = y_edges.windows(2).zip(values.chunks(self.x.len()));
        chart.draw_series(rows.flat_map(|(y, row)| {
            let cells = x_edges.windows(2).zip(row);
            cells.map(|(x, value)| {
                Rectangle::new([(x[0], y[0]), (x[1], y[1])], colour(*value, range).filled())
            })
        }))?;
        let ends = [(self.border, first(&y_edges)), (self.border, last(&y_edges))];
        chart.draw_series(DashedLineSeries::new(ends, 8, 5, WHITE.stroke_width(3)))?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc("αh/δ")
            .y_desc("standard deviation of the noise of ẋ, by αh")
            .x_label_formatter(&|x| short(*x))
            .y_label_formatter(&|y| short(*y))
            .label_style(FONT)
            .axis_desc_style(("sans-serif", 16))
            .draw()?;
        let place =
            FONT.into_text_style(area).color(&WHITE).pos(Pos::new(HPos::Left, VPos::Bottom));
        let at = (self.border * 1.07, first(&y_edges) * 1.07);
        chart.draw_series([Text::new(format!("αh/δ = {}", self.border), at, place)])?;
        Ok(())
    }
}

/// The colour bar, logarithmic.
fn bar(area: &Area, range: &Range<f64>) -> anyhow::Result<()> {
    const STEPS: i32 = 200;
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .margin_top(41)
        .margin_bottom(58)
        .right_y_label_area_size(62)
        .build_cartesian_2d(0.0..1.0, (range.start..range.end).log_scale())?
        .set_secondary_coord(
            0.0..1.0,
            (range.start..range.end)
                .log_scale()
                .with_key_points(decades(&[range.start, range.end])),
        );
    let at = |k: i32| range.start * (range.end / range.start).powf(f64::from(k) / f64::from(STEPS));
    chart.draw_series((0..STEPS).map(|k| {
        Rectangle::new([(0.0, at(k)), (1.0, at(k + 1))], colour(at(k), range).filled())
    }))?;
    chart
        .configure_secondary_axes()
        .y_desc("RMS of s, by αh")
        .y_label_formatter(&|value| short(*value))
        .label_style(FONT)
        .axis_desc_style(("sans-serif", 16))
        .draw()?;
    Ok(())
}

/// Viridis: its lightness grows evenly, for colour-blind readers and grey print too.
fn colour(value: f64, range: &Range<f64>) -> RGBColor {
    if !value.is_finite() {
        return RGBColor(150, 150, 150);
    }
    let share = (value / range.start).ln() / (range.end / range.start).ln();
    ViridisRGB.get_color(share.clamp(0.0, 1.0))
}

/// Powers of `base` between the first and the last level, the ends included.
fn marks(levels: &[f64], base: f64) -> Vec<f64> {
    const SLACK: f64 = 1e-9;
    let power = |level: f64| level.ln() / base.ln();
    let from = (power(first(levels)) - SLACK).ceil() as i32;
    let to = (power(last(levels)) + SLACK).floor() as i32;
    (from..=to).map(|k| base.powi(k)).collect()
}

/// 1, 2 and 5 times the powers of ten between the first and the last level, the ends included.
fn decades(levels: &[f64]) -> Vec<f64> {
    let [low, high] = [first(levels) * (1.0 - 1e-9), last(levels) * (1.0 + 1e-9)];
    let powers = marks(&[low / 10.0, high], 10.0);
    let all = powers.iter().flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * power));
    all.filter(|mark| (low..=high).contains(mark)).collect()
}

/// The edges of cells around levels that are spaced by equal factors.
fn edges(levels: &[f64]) -> Vec<f64> {
    let factor = match levels {
        [first, .., last] => (last / first).powf(0.5 / (levels.len() - 1) as f64),
        _ => 2.0,
    };
    levels.iter().take(1).map(|x| x / factor).chain(levels.iter().map(|x| x * factor)).collect()
}

fn first(values: &[f64]) -> f64 {
    values.first().copied().unwrap_or(1.0)
}

fn last(values: &[f64]) -> f64 {
    values.last().copied().unwrap_or(2.0)
}

/// Four places at most.
fn short(value: f64) -> String {
    ((value * 1e4).round() / 1e4).to_string()
}
