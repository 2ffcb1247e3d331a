//! Controllers: gains, the linearizing law, closed-loop error learning, and the simulation study of the paper.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/precisions.rs"]
mod precisions;
#[path = "../common/smooth_plants.rs"]
mod smooth_plants;

mod active_disturbance_rejection;
mod adaptive;
mod backstepping;
mod clelc;
mod compensated;
mod decoupling;
mod feedback_linearization;
mod gains;
mod input_only;
mod learning_mode;
mod limited;
mod lqr;
mod measurement;
mod paper;
mod pid;
mod reference;
mod run_time_choice;
mod sliding_mode;
mod snapshot;
mod state_feedback;
mod supervised;
mod support;
mod unicycle;
mod unmatched;

use precisions::at_f32_and_f64;
