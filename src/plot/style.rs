use plotters::style::RGBColor;

/// The colours of M. Okabe and K. Ito, which stay apart for colour-blind readers; their yellow is too pale for lines on white.
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
/// See [`BLUE`].
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
/// See [`BLUE`].
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
/// See [`BLUE`].
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
/// See [`BLUE`].
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
/// See [`BLUE`].
pub const SKY: RGBColor = RGBColor(86, 180, 233);
/// For references, and for lines that lie on others.
pub const BLACK: RGBColor = RGBColor(0, 0, 0);
/// For what is not a result: marks, fields, and what was before.
pub const GREY: RGBColor = RGBColor(110, 110, 110);

const COLOURS: [RGBColor; 6] = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY];
const DASHES: [Dash; 5] =
    [Dash::Solid, Dash::Dashed, Dash::DashDot, Dash::Dotted, Dash::LongDashed];

/// How a line is broken up, so that lines stay apart in black and white too.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// ────
    Solid,
    /// ─ ─ ─
    Dashed,
    /// ─ · ─
    DashDot,
    /// · · ·
    Dotted,
    /// ── ──
    LongDashed,
}

impl Dash {
    /// The lengths of strokes and gaps in turn, in pixels.
    pub(super) fn pattern(self) -> &'static [f64] {
        match self {
            Dash::Solid => &[],
            Dash::Dashed => &[6.0, 3.5],
            Dash::DashDot => &[8.0, 3.0, 1.8, 3.0],
            Dash::Dotted => &[1.8, 2.4],
            Dash::LongDashed => &[12.0, 4.0],
        }
    }
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// The colour.
    pub colour: RGBColor,
    /// The width in pixels.
    pub width: f64,
    /// Strokes and gaps.
    pub dash: Dash,
}

impl Stroke {
    /// A line of normal width.
    pub const fn new(colour: RGBColor, dash: Dash) -> Self {
        Self { colour, width: 1.6, dash }
    }

    /// The same line with another width in pixels.
    pub const fn width(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// The style of line number `i` of a figure: colours and dashes both change from one to the next, and thirty pairs come before the
    /// first returns.
    pub(super) fn nth(i: usize) -> Self {
        let colour = COLOURS.get(i % COLOURS.len()).copied().unwrap_or(BLACK);
        let dash = DASHES.get(i % DASHES.len()).copied().unwrap_or(Dash::Solid);
        Self::new(colour, dash)
    }
}
