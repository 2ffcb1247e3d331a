//! Closed-loop error learning: what it equals, what it learns, its symmetries, its failures, and derivatives through it.

mod derivatives;
mod equivalence;
mod failures;
mod gain_margin;
mod learned;
mod symmetry;
