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
            *grades = normalized(row.map(|membership| membership.distance(*e).abs()));
        }
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

/// exp(−Mₖ²/2)/Σ exp(−M²/2) for distances M ≥ 0.
///
/// The difference of squares is taken as a product, which keeps its accuracy far out. Equal distances give 1 before any
/// arithmetic, so that even distances which overflowed to infinity divide up evenly. A grade below ε is lost in the rounding of the sum.
fn normalized<T: Scalar, const K: usize>(distances: [T; K]) -> [T; K] {
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
    grades.map(|grade| grade / sum)
}
