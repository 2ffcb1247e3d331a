//! The sampled-data loop against independent integration and closed forms, and figures of merit against their definitions.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/precisions.rs"]
mod precisions;

mod closed_loop;
mod error_metrics;
mod gradient;
mod hardware;
mod recording;
mod step_info;
mod total_variation;

use precisions::at_f32_and_f64;

/// `value` in the scalar type of the check.
fn num<T: brunovsky::Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}
