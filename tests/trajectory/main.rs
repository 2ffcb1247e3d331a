//! Trajectories against closed forms, identities of their derivatives, symmetries, and the optimality they are defined by.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/precisions.rs"]
mod precisions;

mod boundary;
mod circle;
mod constant_speed;
mod derivatives;
mod figure_eight;
mod limits;
mod line;
mod minimum_jerk;
mod quintic;
mod support;

use precisions::at_f32_and_f64;
