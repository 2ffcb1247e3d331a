//! Figures, judged by the SVG text that they become: what is drawn must lie where the ticks say.

mod errors;
mod figure;
mod kinds;
mod png;
mod support;
mod ticks;
