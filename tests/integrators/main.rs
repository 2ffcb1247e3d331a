//! Integration methods: one measurement of the order for all of them, exactness, and the checks of `integrate`.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod adaptive;
mod dormand_prince;
mod euler;
mod events;
mod heun;
mod integrate;
mod order;
mod order_conditions;
mod rk4;
mod rodas;
mod trees;
