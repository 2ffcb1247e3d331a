use std::ops::Range;

use plotters::style::RGBColor;

use super::{Dash, GREY, Line, Stroke, axis::Axis, colours::ColourBar, geometry::Point};
use crate::Error;

/// A figure in the making: axes with units, and what is drawn between them.
///
/// Start with the kind of figure ([`over_time`](Self::over_time), [`in_plane`](Self::in_plane), [`phase_plane`](Self::phase_plane), …),
/// add to it, and [`save`](super::Draw::save) it. What is added first lies below. Anything can be added to any kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    pub(super) axes: [Axis; 2],
    pub(super) layers: Vec<Layer>,
    pub(super) size: [f64; 2],
    /// Whether a unit is as long up as across; the height follows from that.
    pub(super) equal: bool,
    pub(super) colour_bar: Option<ColourBar>,
}

/// Something drawn between the axes, in their units where nothing else is said.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Layer {
    Line {
        label: String,
        points: Vec<Point>,
        stroke: Stroke,
    },
    /// A line across the whole figure at an x, named beside it.
    Event {
        label: String,
        x: f64,
    },
    /// Between a lower and an upper line.
    Band {
        label: String,
        points: Vec<(f64, Range<f64>)>,
        stroke: Stroke,
    },
    Mark {
        label: String,
        at: Point,
        shape: Shape,
        colour: RGBColor,
    },
    /// A text to the right of a point.
    Note {
        text: String,
        at: Point,
    },
    /// Rectangles between grid lines with a value each, row by row from below.
    Cells {
        x: Vec<f64>,
        y: Vec<f64>,
        values: Vec<f64>,
    },
    /// A colour's name for the legend.
    Key {
        label: String,
        colour: RGBColor,
    },
}

/// A mark at a point; its size is in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    Ring,
    Disc,
    /// Pointing along a direction in the units of the axes.
    Arrow {
        along: Point,
        length: f64,
    },
    /// A vehicle that looks that way.
    Vehicle {
        along: Point,
    },
}

impl Figure {
    /// A figure with these labels on its axes, which name quantity and unit: "position x₁ in m".
    pub fn new(x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        Self {
            axes: [Axis::new(x_label, 0.03), Axis::new(y_label, 0.05)],
            layers: Vec::new(),
            size: [640.0, 340.0],
            equal: false,
            colour_bar: None,
        }
    }

    /// The width and height in pixels of 1/96 inch. Letters and lines stay as they are, at 9 pt, so give the size at which it is printed.
    ///
    /// # Errors
    /// [`Error::NotBelow`] or [`Error::NonFinite`] for sizes outside of 100 to 10 000 pixels.
    pub fn size(self, width: f64, height: f64) -> Result<Self, Error> {
        for (name, size) in [("width of the figure", width), ("height of the figure", height)] {
            crate::error::finite(name, size)?;
            crate::error::below(name, size, 10_001.0)?;
            crate::error::below("least size of a figure", 99.0, size)?;
        }
        Ok(Self { size: [width, height], ..self })
    }

    /// Shows this range of the x axis, and no more.
    pub fn x_range(mut self, range: Range<f64>) -> Self {
        self.axes[0].range = Some(range);
        self
    }

    /// Shows this range of the y axis, and no more.
    pub fn y_range(mut self, range: Range<f64>) -> Self {
        self.axes[1].range = Some(range);
        self
    }

    /// Adds a line.
    pub fn line(mut self, line: Line) -> Self {
        let stroke = line.stroke.unwrap_or_else(|| self.next_stroke());
        self.layers.push(Layer::Line { label: line.label, points: line.points, stroke });
        self
    }

    /// Marks an instant, or any x, by a vertical line with a name at its top.
    pub fn event(mut self, x: f64, label: impl Into<String>) -> Self {
        self.layers.push(Layer::Event { label: label.into(), x });
        self
    }

    /// Adds a point with a name beside it.
    pub fn point(mut self, at: (f64, f64), name: impl Into<String>) -> Self {
        self.mark(Shape::Disc, at, super::BLACK);
        self.layers.push(Layer::Note { text: name.into(), at });
        self
    }

    pub(super) fn mark(&mut self, shape: Shape, at: Point, colour: RGBColor) {
        self.layers.push(Layer::Mark { label: String::new(), at, shape, colour });
    }

    /// The style of the next line without one of its own: the first whose colour is free.
    pub(super) fn next_stroke(&self) -> Stroke {
        let taken = |colour| {
            self.layers
                .iter()
                .any(|layer| matches!(layer, Layer::Line { stroke, .. } if stroke.colour == colour))
        };
        let free = (0..self.layers.len()).map(Stroke::nth).find(|stroke| !taken(stroke.colour));
        free.unwrap_or_else(|| Stroke::nth(self.layers.len()))
    }

    /// What the axes show.
    pub(super) fn ranges(&self) -> Result<[Range<f64>; 2], Error> {
        let [x_axis, y_axis] = &self.axes;
        let x = x_axis.shown(self.layers.iter().flat_map(Layer::points).map(|point| point.0))?;
        let seen = self.layers.iter().flat_map(Layer::points);
        let seen = seen.filter(|point| x.start <= point.0 && point.0 <= x.end);
        let y = y_axis.shown(seen.map(|point| point.1))?;
        Ok([x, y])
    }
}

impl Layer {
    pub const EVENT: Stroke = Stroke::new(GREY, Dash::Solid).width(1.0);

    /// What has to be seen of it.
    fn points(&self) -> Vec<Point> {
        match self {
            Layer::Line { points, .. } => points.clone(),
            Layer::Band { points, .. } => {
                points.iter().flat_map(|(x, y)| [(*x, y.start), (*x, y.end)]).collect()
            }
            Layer::Mark { at, .. } => vec![*at],
            Layer::Cells { x, y, .. } => {
                let ends = |edges: &[f64]| Some((*edges.first()?, *edges.last()?));
                let corners = ends(x).zip(ends(y));
                corners.map_or_else(Vec::new, |((x0, x1), (y0, y1))| vec![(x0, y0), (x1, y1)])
            }
            Layer::Event { .. } | Layer::Note { .. } | Layer::Key { .. } => Vec::new(),
        }
    }
}
