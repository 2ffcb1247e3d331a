//! Learning on the closed-loop error.
//!
//! With the input u = b⁻¹·(−a + u_f + u_b + u_n) the plant ẋ_n = a + b·u + Δ obeys ė_n = −u_b − u_n − Δ, so the sliding variable
//!
//! s = ė_n + u_b = −(u_n + Δ)   (eq_ss2)
//!
//! *is* the uncertainty that has not been learned yet, with the sign turned. Learning u̇_n = α·sgn(s) drives it to zero; the
//! feedback u_b then has nothing left to do.
//!
//! | piece | what it decides | choices |
//! |---|---|---|
//! | [`ErrorRate`] | where ė_n comes from | [`Measured`], [`ModelAided`], any [`Differentiator`](crate::differentiator::Differentiator) of e_n, [`OfState`], [`FeedbackError`]; [`Conditional`] around any, [`Redundant`] around two |
//! | [`AdaptationRule`] | how the network moves | [`SlidingMode`], [`AdaptiveSlidingMode`], [`GradientDescent`], [`RecursiveLeastSquares`], [`NullRule`]; [`Bounded`] around any |
//! | [`Switching`] | how sgn(s) is discretized | `Explicit`, `Implicit`, `SetValued` |
//! | [`Antecedents`] | whether the memberships move | [`Fixed`], [`Flow`] |
//! | [`Compensator`] | all of it together: e, u_b, … ↦ u_n | [`NeuroFuzzy`], [`NullCompensator`]; [`Guarded`] around any |
//! | [`LearningMode`] | whether u_n is learned, and whether it is used | `Off`, `Frozen`, `Active` |
//! | [`Certificate`] | what theory promises | |
//! | [`Advisor`] | which α and δ, from a record of s | [`Recommendation`] |
//! | [`Monitor`], [`Watchdog`] | whether it holds: at each sample, and for how long not | |
//!
//! Signs as everywhere: e = r − x. Units: s, u_b, u_f, u_n and Δ have those of ẋ_n; α those of ẋ_n per second.
//!
//! This module depends on [`fuzzy`](crate::fuzzy) and [`differentiator`](crate::differentiator), and knows nothing of controllers.

mod adaptive_sliding_mode;
mod advisor;
mod antecedents;
mod bounded;
mod certificate;
mod closed_loop;
mod compensator;
mod error_rate;
mod gradient_descent;
mod guarded;
mod mode;
mod monitor;
mod neuro_fuzzy;
mod recursive_least_squares;
mod rule;
mod sliding_mode;
mod switching;
mod watchdog;

pub use crate::differentiator::{BackwardDifference, FilteredDifference};
pub use adaptive_sliding_mode::AdaptiveSlidingMode;
pub use advisor::{Advisor, Recommendation};
pub use antecedents::{Antecedents, Fixed, Flow};
pub use bounded::Bounded;
pub use certificate::Certificate;
pub use closed_loop::ClosedLoop;
pub use compensator::{Compensation, Compensator, NullCompensator};
pub use error_rate::{
    Conditional, ErrorRate, FeedbackError, Measured, ModelAided, OfState, Redundant,
};
pub use gradient_descent::GradientDescent;
pub use guarded::Guarded;
pub use mode::LearningMode;
pub use monitor::{Monitor, Verdict};
pub use neuro_fuzzy::NeuroFuzzy;
pub use recursive_least_squares::RecursiveLeastSquares;
pub use rule::{AdaptationRule, NullRule};
pub use sliding_mode::SlidingMode;
pub use switching::Switching;
pub use watchdog::{Watch, Watchdog};
