use std::ops::Range;

use colorous::{CIVIDIS, Gradient, VIRIDIS};
use plotters::style::RGBColor;

/// From values to colours, even to the eye, to colour-blind readers and in grey print.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum ColourMap {
    /// From dark blue over grey to yellow, made for colour-blind readers (J. R. Nuñez, C. R. Anderton, R. S. Renslow, 2018).
    #[default]
    Cividis,
    /// From violet over green to yellow (S. van der Walt, N. Smith, 2015).
    Viridis,
}

/// The scale beside a map of colours.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ColourBar {
    pub label: String,
    pub range: Range<f64>,
    pub map: ColourMap,
}

impl ColourBar {
    /// For what is not a number.
    pub const NONE: RGBColor = RGBColor(200, 200, 200);

    /// The colour of a value; what lies outside of the range has the colour of its end.
    pub fn colour(&self, value: f64) -> RGBColor {
        if value.is_nan() {
            return Self::NONE;
        }
        let gradient: Gradient = match self.map {
            ColourMap::Cividis => CIVIDIS,
            ColourMap::Viridis => VIRIDIS,
        };
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        // 128 steps are finer than the eye and keep files small.
        let part = (part.clamp(0.0, 1.0) * 128.0).round() / 128.0;
        let colour = gradient.eval_continuous(part);
        RGBColor(colour.r, colour.g, colour.b)
    }
}
