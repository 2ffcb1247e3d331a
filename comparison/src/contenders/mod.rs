//! The same problem in the words of each crate.

pub mod diffsol;
pub mod ode_solvers;
pub mod ours;
