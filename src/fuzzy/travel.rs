use nalgebra::SVector;

use super::{Gaussian, grades::Grades};
use crate::{
    Scalar,
    scalar::{constant, epsilon},
};

/// Memberships on the move: the input that they travel with, how far the flow of the antecedents has taken them, and the consequents with them.
///
/// By the flow d = d₀·e^{−T} and M² = M₀² + 2T, with one T for all memberships of an input. Nothing but T changes, so the
/// differences of M², and with them the normalized grades, are constant to the last bit however long the flow goes on.
///
/// All moves of the consequents then go along one w̃. Nothing but their sum is stored, so a step costs the same for any number of rules, and no
/// rounding of any consequent adds up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Travel<T, const I: usize, const K: usize> {
    /// The input that the memberships are given relative to, so that d₀ = −c₀.
    pub at: SVector<T, I>,
    /// How they fire there, on all of the way.
    pub grades: Grades<T, I, K>,
    /// w̃ᵀw̃.
    pub norm_squared: T,
    /// u_n when the travel began.
    pub start: T,
    /// How far the consequents have moved along w̃ since then.
    pub moved: T,
    /// T, for each input.
    pub flowed: [Flowed<T>; I],
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Flowed<T> {
    pub by: T,
    pub least: T,
    pub most: T,
}

impl<T: Scalar, const I: usize, const K: usize> Travel<T, I, K> {
    /// The start of a travel at the input `at`, with `memberships` relative to it; M² is to stay between `floor` and `ceiling`.
    pub fn new(
        at: SVector<T, I>,
        memberships: &[[Gaussian<T>; K]; I],
        floor: T,
        ceiling: T,
    ) -> Self {
        // What σ = |d|/|M| adds to the range of d, M² between the bounds.
        let spread = ceiling.max(floor.recip());
        let flowed = memberships.each_ref().map(|row| Flowed::within(row, floor, ceiling, spread));
        let grades = Grades::at(memberships, &SVector::zeros());
        let norm_squared = grades.dot(&grades);
        Self { at, grades, norm_squared, start: T::zero(), moved: T::zero(), flowed }
    }

    /// u_n at the input that the memberships travel with: there the network is an integrator.
    pub fn output(&self) -> T {
        self.start + self.moved * self.norm_squared
    }

    /// Moves every M²/2 by `tau`, or as far as the bounds of its input allow.
    pub fn flow(&mut self, tau: T) {
        for flowed in &mut self.flowed {
            flowed.by = (flowed.by + tau).max(flowed.least).min(flowed.most);
        }
    }

    /// `memberships` as the flow has made them, still relative to the input.
    pub fn flowed(&self, memberships: &[[Gaussian<T>; K]; I]) -> [[Gaussian<T>; K]; I] {
        let mut rows = *memberships;
        for (row, flowed) in rows.iter_mut().zip(&self.flowed) {
            *row = row.map(|membership| membership.flowed(flowed.by));
        }
        rows
    }
}

impl<T: Scalar> Flowed<T> {
    /// No flow yet, and as much to come as keeps M² within the bounds, by more than its rounding above 0, and d, 1/d and `spread` times them below
    /// ε⁻⁴, well inside the range of `T`.
    ///
    /// An input below the floor from the start is at the singularity of the law already: its memberships do not flow.
    fn within<const K: usize>(row: &[Gaussian<T>; K], floor: T, ceiling: T, spread: T) -> Self {
        let zero = T::zero();
        let squares = row.map(|membership| membership.distance(zero) * membership.distance(zero));
        let (lowest, highest) = extremes(&squares);
        if lowest < floor {
            return Self { by: zero, least: zero, most: zero };
        }
        let (nearest, farthest) = extremes(&row.map(|membership| membership.centre().abs()));
        let extreme = farthest.max(nearest.recip()) * spread;
        let room = -epsilon::<T>().ln();
        // Where d takes no more than ε^(−1/2) of it there is no need to ask how much.
        let reach = if extreme * extreme * epsilon() < T::one() {
            room * constant(3.5)
        } else {
            (room * constant(4.0) - extreme.ln()).max(zero)
        };
        let half = constant::<T>(0.5);
        let vanishing = lowest * (epsilon::<T>() * constant(4.0) - half);
        let (_, least) = extremes(&[(floor - lowest) * half, vanishing, -reach]);
        let (most, _) = extremes(&[(ceiling - highest) * half, reach]);
        Self { by: zero, least, most: most.max(zero) }
    }
}

/// The least and the greatest of `values`, which are not NaN.
fn extremes<T: Scalar>(values: &[T]) -> (T, T) {
    let [first, rest @ ..] = values else { return (T::zero(), T::zero()) };
    rest.iter().fold((*first, *first), |(least, most), value| {
        (if *value < least { *value } else { least }, if *value > most { *value } else { most })
    })
}
