//! Figures of control for papers and screens, as SVG and PNG (feature `plot`).
//!
//! | figure | constructor | pieces of its own |
//! |---|---|---|
//! | signals over time | [`Figure::over_time`] | [`event`](Figure::event) |
//! | many runs | the same | [`spread`](Figure::spread): median and band of quantiles |
//! | who did the work | [`Figure::shares`]: u_b, u_n and the learned part | |
//! | phase portrait | [`Figure::phase_plane`] | [`field`](Figure::field), [`path`](Figure::path) |
//! | trajectories in the plane | [`Figure::in_plane`] | [`path`](Figure::path), [`vehicle`](Figure::vehicle), [`close_up`](Figure::close_up) |
//! | membership functions | [`Figure::memberships`] | |
//! | map over two parameters | [`Figure::heat_map`] | [`undefined`](Figure::undefined), [`colour_range`](Figure::colour_range) |
//!
//! A [`Figure`] takes [`Line`]s, events and named points, whatever its kind; an array of figures is drawn as panels below each other.
//! [`Draw`] writes either to a file or on an area of [`plotters`].
//!
//! Lines differ in colour (Okabe–Ito, safe for colour-blind readers) and in dashes, so that they stay apart in black and white. Names stand
//! above the axes, where they cover nothing. Letters are 9 pt at the size given, so draw a figure at the size at which it is printed.
//!
//! The same figure gives the same bytes. The font is bundled: nothing needs to be installed.
//!
//! This module depends on [`fuzzy`](crate::fuzzy) for memberships and on nothing else of the crate.

mod axis;
mod canvas;
mod colours;
mod draw;
mod ensemble;
mod error;
mod figure;
mod geometry;
mod heat_map;
mod in_plane;
mod layout;
mod line;
mod memberships;
mod over_time;
mod page;
mod phase_plane;
mod shares;
mod style;

pub use colours::ColourMap;
pub use draw::Draw;
pub use error::Error;
pub use figure::Figure;
pub use line::Line;
pub use plotters::{self, style::RGBColor};
pub use style::{BLACK, BLUE, Dash, GREEN, GREY, ORANGE, PURPLE, SKY, Stroke, VERMILION};
