//! Closed-loop error learning: what it equals, what it learns, its symmetries, its failures, and derivatives through it.

mod bounded;
mod derivatives;
mod equivalence;
mod failures;
mod faults;
mod feedback_error;
mod gain_margin;
mod guarded;
mod learned;
mod symmetry;
