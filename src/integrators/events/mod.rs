//! When a function of the state crosses zero.

mod crossing;
mod locate;
mod next_event;
mod watch;

pub use crossing::{Crossing, Direction};
pub use next_event::Occurrence;
pub use watch::Events;
