use std::ops::Range;

use super::{
    Error, Figure,
    axis::Ticks,
    canvas::width,
    figure::{Layer, Shape},
    geometry::Point,
};

/// The sizes of letters in pixels: of ticks and legend, and of the axes' labels. 12 pixels are 9 pt.
pub(super) const SMALL: f64 = 11.5;
pub(super) const NORMAL: f64 = 12.5;

const EDGE: f64 = 8.0;
/// The middle of the vertical axis' label, from the left.
pub(super) const LABEL: f64 = EDGE + 0.7 * NORMAL;
const ROW: f64 = 18.0;
const SAMPLE: f64 = 28.0;

/// Where everything is, in pixels.
pub(super) struct Layout {
    pub size: [f64; 2],
    pub ranges: [Range<f64>; 2],
    pub ticks: [Ticks; 2],
    /// The rectangle between the axes, y from above.
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
    /// The layers with a name, and where their samples begin.
    pub legend: Vec<(usize, Point)>,
    /// The ticks of the colour bar.
    pub bar: Option<Ticks>,
    pub said: Said,
}

/// What another panel says already: the legend of the one above, the label of the x axis of the one below.
#[derive(Clone, Copy, Default)]
pub(super) struct Said {
    pub legend: bool,
    pub x_label: bool,
}

impl Layout {
    /// The layout of a figure whose left margin is `left` at least, without what a neighbouring panel says already.
    pub fn of(figure: &Figure, left: f64, said: Said) -> Result<Self, Error> {
        let [mut x, mut y] = figure.ranges()?;
        let [full_width, mut height] = figure.size;
        let y_ticks = Ticks::of(&y, height / 40.0);
        let left = left.max(margin(&y_ticks)?);
        let bar = figure.colour_bar.as_ref().map(|bar| Ticks::of(&bar.range, height / 40.0));
        let right = match &bar {
            // The bar, its ticks and its label.
            Some(ticks) => full_width - (32.0 + margin(ticks)?),
            // Half the label of a tick at the end.
            None => full_width - 20.0,
        };
        let (legend, rows) = legend(figure, left, right, said.legend)?;
        let top = EDGE + rows.max(if events(figure) { 1.0 } else { 0.3 }) * ROW;
        let bottom = if said.x_label { 28.0 } else { 46.0 };
        if figure.equal {
            (height, x, y) = equal(right - left, top + bottom, height, x, y);
        }
        let ticks =
            [Ticks::of(&x, (right - left) / 62.0), Ticks::of(&y, (height - top - bottom) / 40.0)];
        // Fewer ticks on more room may have longer labels; there are not many such steps.
        let needed = margin(&ticks[1])?;
        if needed > left {
            return Self::of(figure, needed, said);
        }
        let size = [full_width, height];
        let bottom = height - bottom;
        let room = (right - left).min(bottom - top);
        crate::error::below("least room between the axes", 20.0, room)?;
        Ok(Self { size, ranges: [x, y], ticks, left, right, top, bottom, legend, bar, said })
    }

    /// Where a point of the figure is.
    pub fn at(&self, (x, y): Point) -> Point {
        let [x_range, y_range] = &self.ranges;
        let part =
            |value: f64, range: &Range<f64>| (value - range.start) / (range.end - range.start);
        (
            self.left + part(x, x_range) * (self.right - self.left),
            self.bottom - part(y, y_range) * (self.bottom - self.top),
        )
    }

    /// Whether a point lies between the axes.
    pub fn sees(&self, (x, y): Point) -> bool {
        let [x_range, y_range] = &self.ranges;
        let within = |value: f64, range: &Range<f64>| range.start <= value && value <= range.end;
        within(x, x_range) && within(y, y_range)
    }
}

/// What the label of a vertical axis and of its ticks need.
fn margin(ticks: &Ticks) -> Result<f64, Error> {
    let widths = ticks.places.iter().map(|(_, text)| width(text, SMALL));
    let widest = widths.collect::<Result<Vec<_>, _>>()?.into_iter().fold(0.0, f64::max);
    Ok(EDGE + 1.4 * NORMAL + widest + 17.0)
}

fn events(figure: &Figure) -> bool {
    figure
        .layers
        .iter()
        .any(|layer| matches!(layer, Layer::Event { label, .. } if !label.is_empty()))
}

/// Where the names go, in rows above the axes where they cover nothing, and how many rows that takes.
fn legend(
    figure: &Figure,
    left: f64,
    right: f64,
    said: bool,
) -> Result<(Vec<(usize, Point)>, f64), Error> {
    let mut places = Vec::new();
    let (mut x, mut row) = (left, 0.0);
    // What the marks mean comes after the lines that they are on.
    let layers = || figure.layers.iter().enumerate().filter(|_| !said);
    let is_mark = |layer: &Layer| matches!(layer, Layer::Mark { .. });
    let in_turn = layers().filter(|(_, layer)| !is_mark(layer));
    for (i, layer) in in_turn.chain(layers().filter(|(_, layer)| is_mark(layer))) {
        let Some(label) = layer.key() else { continue };
        let wide = layer.sample() + width(label, SMALL)? + 22.0;
        if x > left && x + wide - 22.0 > right {
            (x, row) = (left, row + 1.0);
        }
        places.push((i, (x, EDGE + (row + 0.5) * ROW)));
        x += wide;
    }
    let rows = if places.is_empty() { 0.0 } else { row + 1.0 };
    // Events are named in a row of their own.
    let rows = if events(figure) { rows + 0.9 } else { rows + 0.2 };
    Ok((places, rows))
}

/// A unit as long up as across: the height follows from the width, until that were too tall or too flat; then the range that is too
/// short is extended.
fn equal(
    across: f64,
    margins: f64,
    height: f64,
    x: Range<f64>,
    y: Range<f64>,
) -> (f64, Range<f64>, Range<f64>) {
    let [wide, tall] = [&x, &y].map(|range| range.end - range.start);
    let up = (across * tall / wide).clamp(0.3 * across, (1.6 * height).max(0.3 * across));
    let extended = |range: Range<f64>, span: f64| {
        let by = 0.5 * (span - (range.end - range.start)).max(0.0);
        range.start - by..range.end + by
    };
    (margins + up, extended(x, tall * across / up), extended(y, wide * up / across))
}

impl Layer {
    /// The name in the legend.
    pub fn key(&self) -> Option<&str> {
        let label = match self {
            Layer::Line { label, .. }
            | Layer::Band { label, .. }
            | Layer::Mark { label, .. }
            | Layer::Key { label, .. } => label,
            Layer::Event { .. } | Layer::Note { .. } | Layer::Cells { .. } => return None,
        };
        (!label.is_empty()).then_some(label)
    }

    /// The width of the sample in front of the name, and of the gap after it.
    pub fn sample(&self) -> f64 {
        match self {
            Layer::Mark { shape: Shape::Ring | Shape::Disc, .. } => 14.0,
            Layer::Key { .. } => 24.0,
            _ => SAMPLE + 6.0,
        }
    }
}
