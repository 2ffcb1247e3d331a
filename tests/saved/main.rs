//! What is saved goes on bit for bit when it is loaded, and what no constructor accepts is not loaded.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[macro_use]
#[path = "../common/laws.rs"]
mod precisions;

mod controllers;
mod hostile;
mod hostile_laws;
mod laws;
mod mutated;
mod parts;
mod support;
