use nalgebra::SVector;

use super::Gaussian;
use crate::{Scalar, scalar::constant};

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

    /// w̃ᵀw̃ = Πᵢ Σₖ μ̃ᵢₖ² of their outer product w̃.
    pub fn norm_squared(&self) -> T {
        self.0.iter().fold(T::one(), |product, row| {
            product * row.iter().fold(T::zero(), |sum, grade| sum + *grade * *grade)
        })
    }
}

/// exp(−Mₖ²/2)/Σ exp(−M²/2) for distances M ≥ 0.
///
/// The difference of squares is taken as a product, which keeps its accuracy far out. Equal distances give 1 before any
/// arithmetic, so that even distances which overflowed to infinity divide up evenly.
fn normalized<T: Scalar, const K: usize>(distances: [T; K]) -> [T; K] {
    let nearest = distances.into_iter().reduce(T::min).unwrap_or(T::zero());
    let grades = distances.map(|m| {
        if m == nearest { T::one() } else { ((nearest - m) * (nearest + m) * constant(0.5)).exp() }
    });
    let sum = grades.iter().fold(T::zero(), |sum, grade| sum + *grade);
    grades.map(|grade| grade / sum)
}
