use super::grades::nearest_alone;
use crate::{
    Error, Scalar,
    error::{finite, positive},
    scalar::epsilon,
};

/// A triangular membership function: μ rises in a straight line from 0 at the left foot to 1 at the peak and falls to 0 at the right foot.
/// Outside of its feet it is 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triangular<T> {
    left: T,
    peak: T,
    right: T,
}

impl<T: Scalar> Triangular<T> {
    /// A membership function with its feet at `left` and `right` and its peak in between, in the units of e.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for a place that is not finite, or a flank longer than the range of `T`; [`Error::NotPositive`] for a flank that is not
    /// left < peak < right.
    pub fn new(left: T, peak: T, right: T) -> Result<Self, Error> {
        finite("left foot", left)?;
        finite("peak", peak)?;
        finite("right foot", right)?;
        positive("left flank", peak - left)?;
        positive("right flank", right - peak)?;
        Ok(Self { left, peak, right })
    }

    /// The left foot.
    pub fn left(&self) -> T {
        self.left
    }

    /// The place where the grade is 1.
    pub fn peak(&self) -> T {
        self.peak
    }

    /// The right foot.
    pub fn right(&self) -> T {
        self.right
    }

    /// The membership grade μ(e), between 0 and 1.
    pub fn grade(&self, e: T) -> T {
        if e <= self.left || e >= self.right {
            T::zero()
        } else if e < self.peak {
            (e - self.left) / (self.peak - self.left)
        } else {
            (self.right - e) / (self.right - self.peak)
        }
    }

    /// The grades of a `row` of memberships at a finite `e`, normalized to sum to 1. Where none fires, the one whose foot is the nearest does.
    pub(super) fn shares<const K: usize>(row: &[Self; K], e: T) -> [T; K] {
        let grades = row.map(|membership| membership.grade(e));
        let largest = grades.into_iter().fold(T::zero(), T::max);
        if largest.is_zero() {
            return nearest_alone(row.map(|own| [own.left, own.peak, own.right]), e);
        }
        // A grade below ε of the largest is lost in the rounding of the sum.
        let relative = grades.map(|grade| {
            let relative = grade / largest;
            if relative < epsilon() { T::zero() } else { relative }
        });
        let sum = relative.iter().fold(T::zero(), |sum, grade| sum + *grade);
        relative.map(|grade| grade / sum)
    }
}

checked! {
    [T: Scalar] Triangular<T>, [T] { left: T, peak: T, right: T } => Self::new(left, peak, right)
}
