mod elliptic;
mod network;
mod reduction;
mod uncertain_gaussian;

pub use elliptic::Elliptic;
pub use network::{IntervalFiring, IntervalNetwork};
pub use reduction::TypeReduction;
pub use uncertain_gaussian::UncertainGaussian;

use super::PerRule;

/// A membership function of interval type 2: all that is known of a grade is that it lies between a lower and an upper one.
pub trait IntervalMembership<T>: PerRule {
    /// The lower and the upper grade at a finite `e`, 0 ≤ lower ≤ upper ≤ 1.
    fn grades(&self, e: T) -> [T; 2];

    /// What each of a `row` of memberships has of their sum at a finite `e`. An implementation finds it where all grades are too small to be
    /// numbers, and says what is to be where all are 0.
    fn shares<const K: usize>(row: &[Self; K], e: T) -> Shares<T, K>;
}

/// The grades of the memberships of one input, normalized.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares<T, const K: usize> {
    /// The lower grades over their sum.
    pub lower: [T; K],
    /// The upper grades over their sum.
    pub upper: [T; K],
    /// The sum of the lower grades over that of the upper ones, between 0 and 1.
    pub ratio: T,
}
