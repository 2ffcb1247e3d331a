use nalgebra::SVector;

use super::Gaussian;
use crate::{Scalar, scalar::constant};

/// Memberships on the move: the input that they travel with, how far the flow of the antecedents has taken them, and the consequents with them.
///
/// By the flow d = d₀·e^{−T} and M² = M₀² + 2T, with one T for all memberships of an input. Nothing but T is stored, so the
/// differences of M², and with them the normalized firing strengths, are constant to the last bit however long the flow goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Travel<T, const I: usize> {
    /// The input that the memberships are given relative to, so that d₀ = −c₀.
    pub at: SVector<T, I>,
    /// How far the consequents have moved along w̃.
    pub moved: T,
    /// T, for each input.
    flowed: [Flowed<T>; I],
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Flowed<T> {
    by: T,
    least: T,
    most: T,
}

impl<T: Scalar, const I: usize> Travel<T, I> {
    /// The start of a travel at the input `at`, with `memberships` relative to it; M² is to stay between `floor` and `ceiling`.
    pub fn new<const K: usize>(
        at: SVector<T, I>,
        memberships: &[[Gaussian<T>; K]; I],
        floor: T,
        ceiling: T,
    ) -> Self {
        let flowed = memberships.each_ref().map(|row| Flowed::within(row, floor, ceiling));
        Self { at, moved: T::zero(), flowed }
    }

    /// Moves every M²/2 by `tau`, or as far as the bounds of its input allow.
    pub fn flow(&mut self, tau: T) {
        for flowed in &mut self.flowed {
            flowed.by = (flowed.by + tau).max(flowed.least).min(flowed.most);
        }
    }

    /// `memberships` as the flow has made them, still relative to the input.
    pub fn flowed<const K: usize>(
        &self,
        memberships: &[[Gaussian<T>; K]; I],
    ) -> [[Gaussian<T>; K]; I] {
        let mut rows = *memberships;
        for (row, flowed) in rows.iter_mut().zip(&self.flowed) {
            *row = row.map(|membership| membership.flowed(flowed.by));
        }
        rows
    }
}

impl<T: Scalar> Flowed<T> {
    /// No flow yet, and as much to come as keeps M² within the bounds and ln d within three quarters of the range of `T`.
    ///
    /// An input below the floor from the start is at the singularity of the law already: its memberships do not flow.
    fn within<const K: usize>(row: &[Gaussian<T>; K], floor: T, ceiling: T) -> Self {
        let zero = T::zero();
        let squares = row.map(|membership| membership.distance(zero) * membership.distance(zero));
        let distances = row.map(|membership| membership.centre().abs());
        let lowest = squares.into_iter().reduce(T::min).unwrap_or(zero);
        if lowest < floor {
            return Self { by: zero, least: zero, most: zero };
        }
        let highest = squares.into_iter().reduce(T::max).unwrap_or(zero);
        let nearest = distances.into_iter().reduce(T::min).unwrap_or(zero);
        let farthest = distances.into_iter().reduce(T::max).unwrap_or(zero);
        let half = constant::<T>(0.5);
        let room = T::max_value().map_or(constant(60.0), |max| max.ln() * constant(0.75));
        Self {
            by: zero,
            least: ((floor - lowest) * half).max(farthest.ln() - room).min(zero),
            most: ((ceiling - highest) * half).min(nearest.ln() + room).max(zero),
        }
    }
}
