//! Trajectory tracking for the unicycle robot, by dynamic feedback linearization.

mod dynamic_extension;
mod planar;

pub use dynamic_extension::{Standstill, UnicycleCommand, UnicycleController};
pub use planar::{Direction, Heading, feedforward_speed, feedforward_yaw_rate, heading};
