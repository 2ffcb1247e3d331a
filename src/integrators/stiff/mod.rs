//! Methods for stiff problems: linear equations instead of short steps.

mod jacobian;
mod lu;
mod rodas;

pub use jacobian::{FiniteDifferences, Jacobian, Linearization};
pub use rodas::Rodas;
