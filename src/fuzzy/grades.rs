use nalgebra::SVector;

use super::Gaussian;
use crate::{
    Scalar,
    scalar::{constant, epsilon},
};

/// The membership grades of every input, normalized to sum to 1: exp(−Mᵢₖ²/2)/Σₖ exp(−Mᵢₖ²/2).
///
/// For each input the grades are taken relative to the nearest membership: exp((M_near² − M_ik²)/2) is 1 for the nearest and at most 1 for
/// the others, so the sums are never zero, at any distance from the centres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Grades<T, const I: usize, const K: usize>([[T; K]; I]);

impl<T: Scalar, const I: usize, const K: usize> Grades<T, I, K> {
    /// The grades of `memberships` at a finite input `e`.
    pub fn at(memberships: &[[Gaussian<T>; K]; I], e: &SVector<T, I>) -> Self {
        let mut rows = [[T::zero(); K]; I];
        for ((grades, row), e) in rows.iter_mut().zip(memberships).zip(e.iter()) {
            *grades = Relative::at(row.map(|membership| membership.distance(*e).abs())).shares();
        }
        Self(rows)
    }

    /// The grades of `rows`, each of which sums to 1.
    pub fn of(rows: [[T; K]; I]) -> Self {
        Self(rows)
    }

    /// The grades, one row an input.
    pub fn rows(&self) -> &[[T; K]; I] {
        &self.0
    }

    /// w̃ᵀṽ = Πᵢ Σₖ μ̃ᵢₖ·ν̃ᵢₖ for the outer products w̃ of these grades and ṽ of the `others`.
    pub fn dot(&self, others: &Self) -> T {
        self.0.iter().zip(&others.0).fold(T::one(), |product, (row, other)| {
            let pairs = row.iter().zip(other);
            product * pairs.fold(T::zero(), |sum, (a, b)| sum + *a * *b)
        })
    }
}

/// exp(−Mₖ²/2) for distances M ≥ 0, all relative to the largest of them.
pub(super) struct Relative<T, const K: usize> {
    /// The least M.
    pub nearest: T,
    grades: [T; K],
    /// Their sum, at least 1.
    pub sum: T,
}

impl<T: Scalar, const K: usize> Relative<T, K> {
    /// The difference of squares is taken as a product, which keeps its accuracy far out. Equal distances give 1 before any
    /// arithmetic, so that even distances which overflowed to infinity divide up evenly. A grade below ε is lost in the rounding of the sum.
    pub fn at(distances: [T; K]) -> Self {
        let nearest = distances.into_iter().reduce(T::min).unwrap_or(T::zero());
        let grades = distances.map(|m| {
            let grade = ((nearest - m) * (nearest + m) * constant(0.5)).exp();
            if m == nearest {
                T::one()
            } else if grade < epsilon() {
                T::zero()
            } else {
                grade
            }
        });
        let sum = grades.iter().fold(T::zero(), |sum, grade| sum + *grade);
        Self { nearest, grades, sum }
    }

    /// The grades, normalized to sum to 1.
    pub fn shares(&self) -> [T; K] {
        self.grades.map(|grade| grade / self.sum)
    }
}

/// Where no membership of compact support fires at `e`: all to the one whose end is the nearest, in even parts if there are several. `supports` are the
/// left end, the centre and the right end of each.
///
/// Ends are compared with each other and not by their distances, which far out are all the same number.
pub(super) fn nearest_alone<T: Scalar, const K: usize>(supports: [[T; 3]; K], e: T) -> [T; K] {
    let left_of_e = |[_, centre, _]: &[T; 3]| *centre <= e;
    let below = supports.iter().filter(|own| left_of_e(own)).map(|[_, _, right]| *right);
    let above = supports.iter().filter(|own| !left_of_e(own)).map(|[left, _, _]| *left);
    let (below, above) = (below.reduce(T::max), above.reduce(T::min));
    // Which sides of e are the nearer, if there is a membership on both.
    let (left, right) = match (below, above) {
        (Some(below), Some(above)) => (e - below <= above - e, above - e <= e - below),
        _ => (true, true),
    };
    let grades = supports.map(|own| {
        let [start, _, end] = own;
        let nearest = if left_of_e(&own) {
            left && Some(end) == below
        } else {
            right && Some(start) == above
        };
        if nearest { T::one() } else { T::zero() }
    });
    let sum = grades.iter().fold(T::zero(), |sum, grade| sum + *grade);
    grades.map(|grade| grade / sum)
}
