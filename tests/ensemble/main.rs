//! Ensembles and sweeps: the same runs on any number of threads and after any interruption, and statistics against closed forms.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod design;
mod failures;
mod mean;
mod proportion;
mod quantile;
mod record;
mod run;
mod runner;
mod support;
mod sweep;
