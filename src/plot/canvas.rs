use std::sync::OnceLock;

use plotters::{
    coord::Shift,
    element::{Circle, Drawable, PathElement, PointCollection, Polygon, Rectangle, Text},
    prelude::{DrawingArea, DrawingBackend},
    style::{
        Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBAColor, RGBColor, ShapeStyle,
        TextStyle, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};

use super::{
    BLACK, Error, Stroke,
    geometry::{Point, dashes, simplified},
};

/// The family of all text. Its glyphs are those of the bundled font; a viewer of an SVG file that does not have it takes one of the same
/// widths, or its own.
const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// Where a text lies about its point.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Align {
    Left,
    Centre,
    Right,
    /// Centred, and read from below.
    Upwards,
}

/// An area to draw on, in pixels of 1/96 inch whatever its resolution.
pub(super) struct Canvas<'a, DB: DrawingBackend> {
    area: &'a DrawingArea<DB, Shift>,
    /// Dots of the backend a pixel.
    scale: f64,
}

impl<'a, DB: DrawingBackend> Canvas<'a, DB> {
    pub fn new(area: &'a DrawingArea<DB, Shift>, scale: f64) -> Self {
        Self { area, scale }
    }

    /// A line through `points`, broken as its stroke says.
    pub fn line(&self, points: &[Point], stroke: &Stroke) -> Result<(), Error> {
        let style = ShapeStyle {
            color: stroke.colour.to_rgba(),
            filled: false,
            stroke_width: self.dots(stroke.width).max(1),
        };
        // What is off by less than the eye sees only makes files large and edges rough.
        let points = simplified(points, 0.04);
        for piece in dashes(&points, stroke.dash.pattern()) {
            let mut dots: Vec<_> = piece.into_iter().map(|point| self.dot(point)).collect();
            dots.dedup();
            self.draw(&PathElement::new(dots, style))?;
        }
        Ok(())
    }

    /// A filled polygon.
    pub fn polygon(&self, corners: &[Point], colour: RGBAColor) -> Result<(), Error> {
        let dots: Vec<_> = corners.iter().map(|point| self.dot(*point)).collect();
        self.draw(&Polygon::new(dots, colour.filled()))
    }

    /// A filled rectangle between two corners.
    pub fn rectangle(&self, corners: [Point; 2], colour: RGBColor) -> Result<(), Error> {
        self.draw(&Rectangle::new(corners.map(|point| self.dot(point)), colour.filled()))
    }

    /// A disc with a rim, `fill` inside.
    pub fn disc(&self, at: Point, radius: f64, rim: RGBColor, fill: RGBColor) -> Result<(), Error> {
        self.draw(&Circle::new(self.dot(at), self.dots(radius), rim.filled()))?;
        self.draw(&Circle::new(self.dot(at), self.dots(radius - 1.4), fill.filled()))
    }

    /// A text whose line of writing passes a third of its size below `at`, so that it looks centred there.
    pub fn text(&self, text: &str, size: f64, at: Point, align: Align) -> Result<(), Error> {
        let (h_pos, transform) = match align {
            Align::Left => (HPos::Left, FontTransform::None),
            Align::Centre => (HPos::Center, FontTransform::None),
            Align::Right => (HPos::Right, FontTransform::None),
            Align::Upwards => (HPos::Center, FontTransform::Rotate270),
        };
        // The backends write 0.27 and 0.38 of the size above the bottom.
        let down = (0.36 + 0.32) * size;
        let at = match align {
            Align::Upwards => (at.0 + down, at.1),
            _ => (at.0, at.1 + down),
        };
        let font = font(size * self.scale)?.transform(transform);
        let style = TextStyle::from(font).color(&BLACK).pos(Pos::new(h_pos, VPos::Bottom));
        self.draw(&Text::new(text.to_owned(), self.dot(at), style))
    }

    fn draw<E>(&self, element: &E) -> Result<(), Error>
    where
        for<'b> &'b E: PointCollection<'b, (i32, i32)>,
        E: Drawable<DB>,
    {
        self.area.draw(element).map_err(Error::backend)
    }

    fn dot(&self, (x, y): Point) -> (i32, i32) {
        ((x * self.scale).round() as i32, (y * self.scale).round() as i32)
    }

    fn dots(&self, length: f64) -> u32 {
        (length * self.scale).round() as u32
    }
}

/// The width of a text.
pub(super) fn width(text: &str, size: f64) -> Result<f64, Error> {
    // Layouts are in whole dots, and a little wider than what is drawn.
    let ((left, _), (right, _)) = font(100.0)?.layout_box(text).map_err(Error::backend)?;
    Ok(f64::from(right - left) / 100.0 * size * 0.94)
}

/// The font, in the size that a backend makes letters of `size` from.
fn font(size: f64) -> Result<FontDesc<'static>, Error> {
    static REGISTERED: OnceLock<bool> = OnceLock::new();
    REGISTERED
        .get_or_init(|| register_font(FAMILY, FontStyle::Normal, dejavu::sans::regular()).is_ok());
    Ok(FontDesc::new(FontFamily::Name(FAMILY), size * 1.24, FontStyle::Normal))
}
