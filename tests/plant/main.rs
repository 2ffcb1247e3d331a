//! Plants: closed forms, conservation laws and symmetries of the benchmark plants, and the ladder of plant traits.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/precisions.rs"]
mod precisions;
#[path = "../common/smooth_plants.rs"]
mod smooth_plants;

mod integrator_chain;
mod ladder;
mod pendulum;
mod smooth;
mod support;
mod third_order;
mod tracked_robot;
mod two_link_arm;
mod uncertain;
mod unicycle;
mod van_der_pol;

use precisions::at_f32_and_f64;
