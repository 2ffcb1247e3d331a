//! Numbers that carry derivatives: closed forms, identities, num_dual as a second implementation, and a higher precision for rounding errors.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/precisions.rs"]
mod precisions;

mod dual;
mod jet;
mod mixed;
mod running_error;
mod support;

use precisions::at_f32_and_f64;
