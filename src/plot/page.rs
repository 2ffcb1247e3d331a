use std::ops::Range;

use plotters::{
    prelude::DrawingBackend,
    style::{Color, RGBColor},
};

use super::{
    Dash, Error, Figure, Stroke,
    axis::Axis,
    canvas::{Align, Canvas, width},
    figure::{Layer, Shape},
    geometry::{Point, clipped},
    layout::{LABEL, Layout, NORMAL, SMALL},
};

const WHITE: RGBColor = RGBColor(255, 255, 255);
const GRID: Stroke = Stroke::new(RGBColor(225, 225, 225), Dash::Solid).width(0.7);
/// The opacity of a band, through which others are seen.
const BAND: f64 = 0.22;
const FRAME: Stroke = Stroke::new(RGBColor(60, 60, 60), Dash::Solid).width(0.9);

/// One panel on its canvas.
pub(super) struct Page<'a, DB: DrawingBackend> {
    pub figure: &'a Figure,
    pub layout: &'a Layout,
    pub canvas: Canvas<'a, DB>,
}

impl<DB: DrawingBackend> Page<'_, DB> {
    pub fn draw(&self) -> Result<(), Error> {
        let surface = |layer: &&Layer| matches!(layer, Layer::Cells { .. } | Layer::Band { .. });
        let layers = || self.figure.layers.iter();
        if self.figure.colour_bar.is_none() {
            self.grid()?;
        }
        layers().filter(surface).try_for_each(|layer| self.layer(layer))?;
        layers().filter(|layer| !surface(layer)).try_for_each(|layer| self.layer(layer))?;
        self.axes()?;
        self.colour_bar()?;
        self.legend()
    }

    fn grid(&self) -> Result<(), Error> {
        let Layout { left, right, top, bottom, ticks: [x, y], .. } = self.layout;
        for (place, _) in &x.places {
            let at = self.layout.at((*place, 0.0)).0;
            self.canvas.line(&[(at, *top), (at, *bottom)], &GRID)?;
        }
        for (place, _) in &y.places {
            let at = self.layout.at((0.0, *place)).1;
            self.canvas.line(&[(*left, at), (*right, at)], &GRID)?;
        }
        Ok(())
    }

    fn axes(&self) -> Result<(), Error> {
        let Layout { left, right, top, bottom, ticks: [x, y], .. } = self.layout;
        let (left, right, top, bottom) = (*left, *right, *top, *bottom);
        self.frame([(left, top), (right, bottom)])?;
        for (place, text) in &x.places {
            let at = self.layout.at((*place, 0.0)).0;
            self.canvas.line(&[(at, bottom), (at, bottom + 4.0)], &FRAME)?;
            self.canvas.text(text, SMALL, (at, bottom + 13.0), Align::Centre)?;
        }
        for (place, text) in &y.places {
            let at = self.layout.at((0.0, *place)).1;
            self.canvas.line(&[(left - 4.0, at), (left, at)], &FRAME)?;
            self.canvas.text(text, SMALL, (left - 7.0, at), Align::Right)?;
        }
        let [x_axis, y_axis] = &self.figure.axes;
        let middle = ((left + right) / 2.0, bottom + 32.0);
        if !self.layout.said.x_label {
            self.canvas.text(&x_axis.label(x.exponent), NORMAL, middle, Align::Centre)?;
        }
        let middle = (LABEL, (top + bottom) / 2.0);
        self.canvas.text(&y_axis.label(y.exponent), NORMAL, middle, Align::Upwards)
    }

    fn frame(&self, [(left, top), (right, bottom)]: [Point; 2]) -> Result<(), Error> {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        self.canvas.line(&corners, &FRAME)
    }

    fn layer(&self, layer: &Layer) -> Result<(), Error> {
        let layout = self.layout;
        match layer {
            Layer::Line { points, stroke, .. } => self.polyline(points, stroke),
            Layer::Event { label, x } => {
                let [_, y_range] = &layout.ranges;
                self.polyline(&[(*x, y_range.start), (*x, y_range.end)], &Layer::EVENT)?;
                let at = (layout.at((*x, 0.0)).0, layout.top - 8.0);
                if !layout.sees((*x, y_range.start)) {
                    return Ok(());
                }
                // Near an end the name stays inside.
                let half = width(label, SMALL)? / 2.0;
                let (least, most) = (layout.left + half, layout.right - half);
                let at = (at.0.max(least).min(most.max(least)), at.1);
                self.canvas.text(label, SMALL, at, Align::Centre)
            }
            Layer::Band { points, stroke, .. } => self.band(points, stroke),
            Layer::Mark { at, shape, colour, .. } if layout.sees(*at) => {
                self.mark(layout.at(*at), shape, *colour)
            }
            Layer::Note { text, at } if layout.sees(*at) => {
                let (x, y) = layout.at(*at);
                let fits = x + 8.0 + width(text, SMALL)? < layout.right;
                let (x, align) =
                    if fits { (x + 7.0, Align::Left) } else { (x - 7.0, Align::Right) };
                self.canvas.text(text, SMALL, (x, y - 9.0), align)
            }
            Layer::Mark { .. } | Layer::Note { .. } | Layer::Key { .. } => Ok(()),
            Layer::Cells { x, y, values } => self.cells(x, y, values),
        }
    }

    fn band(&self, points: &[(f64, Range<f64>)], stroke: &Stroke) -> Result<(), Error> {
        let [x_range, y_range] = &self.layout.ranges;
        let seen = || {
            points.iter().filter(|(x, y)| {
                x_range.start <= *x && *x <= x_range.end && y.start.is_finite() && y.end.is_finite()
            })
        };
        let place = |x: f64, y: f64| self.layout.at((x, y.clamp(y_range.start, y_range.end)));
        let lower = seen().map(|(x, y)| place(*x, y.start));
        let upper = seen().map(|(x, y)| place(*x, y.end));
        let corners: Vec<_> = lower.chain(upper.rev()).collect();
        self.canvas.polygon(&corners, stroke.colour.mix(BAND))?;
        let edge = stroke.width(0.5);
        let side = |end: fn(&Range<f64>) -> f64| -> Vec<Point> {
            points.iter().map(|(x, y)| (*x, end(y))).collect()
        };
        self.polyline(&side(|y| y.start), &edge)?;
        self.polyline(&side(|y| y.end), &edge)
    }

    fn polyline(&self, points: &[Point], stroke: &Stroke) -> Result<(), Error> {
        let [x_range, y_range] = &self.layout.ranges;
        for piece in clipped(points, x_range, y_range) {
            let piece: Vec<_> = piece.into_iter().map(|point| self.layout.at(point)).collect();
            self.canvas.line(&piece, stroke)?;
        }
        Ok(())
    }

    fn mark(&self, (x, y): Point, shape: &Shape, colour: RGBColor) -> Result<(), Error> {
        match shape {
            Shape::Ring => self.canvas.disc((x, y), 4.0, colour, WHITE),
            Shape::Disc => self.canvas.disc((x, y), 3.4, colour, colour),
            Shape::Arrow { along, length } => {
                let Some((cos, sin)) = self.direction(*along) else { return Ok(()) };
                let place = |ahead: f64, aside: f64| {
                    (
                        x + length * (ahead * cos - aside * sin),
                        y + length * (ahead * sin + aside * cos),
                    )
                };
                let stroke = Stroke::new(colour, Dash::Solid).width(0.9);
                self.canvas.line(&[place(-0.5, 0.0), place(0.3, 0.0)], &stroke)?;
                let head = [place(0.5, 0.0), place(0.15, 0.14), place(0.15, -0.14)];
                self.canvas.polygon(&head, colour.to_rgba())
            }
            Shape::Vehicle { along } => {
                let Some((cos, sin)) = self.direction(*along) else { return Ok(()) };
                let place = |ahead: f64, aside: f64| {
                    (x + ahead * cos - aside * sin, y + ahead * sin + aside * cos)
                };
                let body = [place(9.0, 0.0), place(-6.0, 5.0), place(-6.0, -5.0)];
                self.canvas.polygon(&body, colour.mix(0.5))?;
                let [nose, ..] = body;
                let outline: Vec<_> = body.into_iter().chain([nose]).collect();
                self.canvas.line(&outline, &Stroke::new(colour, Dash::Solid).width(1.0))
            }
        }
    }

    /// A direction on the page, of length 1.
    fn direction(&self, (dx, dy): Point) -> Option<Point> {
        let Layout { left, right, top, bottom, ranges: [x, y], .. } = self.layout;
        let across = dx * (right - left) / (x.end - x.start);
        let down = -dy * (bottom - top) / (y.end - y.start);
        let length = across.hypot(down);
        (length.is_finite() && length > 0.0).then(|| (across / length, down / length))
    }

    fn cells(&self, x: &[f64], y: &[f64], values: &[f64]) -> Result<(), Error> {
        let Some(bar) = &self.figure.colour_bar else { return Ok(()) };
        let colours: Vec<_> = values.iter().map(|value| bar.colour(*value)).collect();
        let [x_range, y_range] = &self.layout.ranges;
        let place = |x: f64, y: f64| {
            self.layout
                .at((x.clamp(x_range.start, x_range.end), y.clamp(y_range.start, y_range.end)))
        };
        let columns = x.len().saturating_sub(1).max(1);
        for (row, low) in colours.chunks(columns).zip(y) {
            // Each rectangle reaches to the top and a pixel to the right, and the next covers what is too much: between neighbours that
            // only touch, seams would show.
            let mut column = 0;
            for run in row.chunk_by(|a, b| a == b) {
                let end = column + run.len();
                if let (Some(from), Some(to), Some(colour)) =
                    (x.get(column), x.get(end), run.first())
                {
                    let ((left, bottom), (right, _)) = (place(*from, *low), place(*to, *low));
                    let right = (right + 1.0).min(self.layout.right);
                    self.canvas.rectangle([(left, self.layout.top), (right, bottom)], *colour)?;
                }
                column = end;
            }
        }
        Ok(())
    }

    fn colour_bar(&self) -> Result<(), Error> {
        let (Some(bar), Some(ticks)) = (&self.figure.colour_bar, &self.layout.bar) else {
            return Ok(());
        };
        let Layout { right, top, bottom, .. } = self.layout;
        let (left, right) = (right + 14.0, right + 28.0);
        let steps = 128;
        let height = |part: f64| bottom - part * (bottom - top);
        for i in 0..steps {
            let part = f64::from(i) / f64::from(steps);
            let value = bar.range.start + part * (bar.range.end - bar.range.start);
            self.canvas.rectangle([(left, *top), (right, height(part))], bar.colour(value))?;
        }
        self.frame([(left, *top), (right, *bottom)])?;
        let mut widest = 0.0_f64;
        for (place, text) in &ticks.places {
            let at = height((place - bar.range.start) / (bar.range.end - bar.range.start));
            self.canvas.line(&[(right, at), (right + 4.0, at)], &FRAME)?;
            self.canvas.text(text, SMALL, (right + 7.0, at), Align::Left)?;
            widest = widest.max(width(text, SMALL)?);
        }
        let axis = Axis::new(bar.label.clone(), 0.0);
        let middle = (right + widest + 21.0, (top + bottom) / 2.0);
        self.canvas.text(&axis.label(ticks.exponent), NORMAL, middle, Align::Upwards)
    }

    fn legend(&self) -> Result<(), Error> {
        for (i, (x, y)) in &self.layout.legend {
            let Some(layer) = self.figure.layers.get(*i) else { continue };
            let wide = layer.sample() - 6.0;
            match layer {
                Layer::Line { stroke, .. } => {
                    self.canvas.line(&[(*x, *y), (x + wide, *y)], stroke)?;
                }
                Layer::Band { stroke, .. } => {
                    let [low, high] = [y + 5.0, y - 5.0];
                    let corners = [(*x, high), (x + wide, high), (x + wide, low), (*x, low)];
                    self.canvas.polygon(&corners, stroke.colour.mix(BAND))?;
                    self.canvas.line(&[(*x, *y), (x + wide, *y)], stroke)?;
                }
                Layer::Key { colour, .. } => {
                    self.canvas.rectangle([(*x, y - 5.0), (x + wide, y + 5.0)], *colour)?;
                    self.frame([(*x, y - 5.0), (x + wide, y + 5.0)])?;
                }
                Layer::Mark { shape, colour, .. } => {
                    self.mark((x + wide / 2.0, *y), shape, *colour)?;
                }
                _ => {}
            }
            let label = layer.key().unwrap_or_default();
            self.canvas.text(label, SMALL, (x + layer.sample(), *y), Align::Left)?;
        }
        Ok(())
    }
}
