//! Plants: closed forms, conservation laws and symmetries of the benchmark plants, and the ladder of plant traits.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/precisions.rs"]
mod precisions;
#[path = "../common/smooth_plants.rs"]
mod smooth_plants;

mod ball_and_beam;
mod by_hand;
mod cart_pole;
mod chain_form;
mod duffing;
mod flexible_joint;
mod integrator_chain;
mod ladder;
mod magnetic_levitation;
mod motor_driven_link;
mod pendulum;
mod quadrotor;
mod smooth;
mod support;
mod third_order;
mod tracked_robot;
mod two_link_arm;
mod uncertain;
mod unicycle;
mod van_der_pol;

use precisions::at_f32_and_f64;
