//! Differentiation by arithmetic: derivatives exact to rounding, of functions that are written once as plain formulas.
//!
//! | number | carries | for |
//! |---|---|---|
//! | any [`Scalar`] | a value | running the formula |
//! | [`Jet<S, K>`](Jet) | a value and its first K − 1 derivatives in time | Lie derivatives along a flow |
//! | [`Dual<S, M>`](Dual) | a value and its slopes in M directions | Jacobians, input gains |
//! | [`RunningError<T>`](RunningError) | a value and a bound on its rounding error | telling zero from almost zero |
//!
//! They are numbers over numbers: `Dual<Jet<RunningError<f64>, 4>, 2>` has the slopes of derivatives and what rounding did to them. A
//! formula that is generic over [`Smooth`] runs on all of them, and nothing is allocated.
//!
//! This module depends on nothing but [`Scalar`] and the [elementary functions](crate::elementary).
//!
//! # References
//! A. Griewank, A. Walther, *Evaluating Derivatives*, 3.1 (tangents) and 13 (Taylor arithmetic).

mod dual;
mod jet;
mod operators;
mod running_error;
mod smooth;

pub use dual::Dual;
pub use jet::Jet;
pub use running_error::RunningError;
pub use smooth::{Arithmetic, Smooth};

#[cfg(doc)]
use crate::Scalar;
