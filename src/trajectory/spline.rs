//! The quintic spline of least ∫|x⃛|² du through points at given knots u₁ < … < u_M.
//!
//! Between knots it is the [`Quintic`] of their states (p, v, a); p is given, and v and a make third and fourth derivative continuous.
//! Over a segment of length h with P = p₁ − p₀, these derivatives at its ends are
//!
//! ```text
//! h³·x⃛(0) =  60·P − 36·h·v₀ − 24·h·v₁ − 9·h²·a₀ + 3·h²·a₁        h³·x⃛(h) =  60·P − 24·h·v₀ − 36·h·v₁ − 3·h²·a₀ + 9·h²·a₁
//! h⁴·x⁗(0) = −360·P + 192·h·v₀ + 168·h·v₁ + 36·h²·a₀ − 24·h²·a₁    h⁴·x⁗(h) = 360·P − 168·h·v₀ − 192·h·v₁ − 24·h²·a₀ + 36·h²·a₁
//! ```
//!
//! so (−jump of x⁗, jump of x⃛) = 0, half the gradient of the integral by (v, a), is a block-tridiagonal system with symmetric positive
//! definite 2×2 pivots. An end is held at a given (v, a), or free: then x⃛ = x⁗ = 0 there.

use nalgebra::{SMatrix, SVector};

use super::{Boundary, Quintic};
use crate::{
    Error, Scalar,
    error::{finite, value},
    scalar::constant,
};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spline<T, const D: usize, const M: usize>([Knot<T, D>; M]);

/// Where the spline is at u.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Knot<T, const D: usize> {
    pub u: T,
    pub state: Boundary<T, D>,
}

/// \[v, a\] of an end, if it is held.
pub(super) type End<T, const D: usize> = Option<[SVector<T, D>; 2]>;

impl<T: Scalar, const D: usize, const M: usize> Spline<T, D, M> {
    /// Through `points` at the increasing `knots`.
    pub fn new(
        points: &[SVector<T, D>; M],
        knots: &[T; M],
        [start, end]: [End<T, D>; 2],
    ) -> Result<Self, Error> {
        let (Some(first), Some(last)) = (knots.first(), knots.last()) else {
            return Err(Error::Missing { name: "points" });
        };
        // With the mean length of a segment as the unit of u, the pivots are as well scaled as they can be.
        let unit = finite("length of the spline", *last - *first)? / constant((M - 1) as f64);
        let segment = |i: usize| {
            let h = (*knots.get(i + 1)? - *knots.get(i)?) / unit;
            Some((h, points.get(i + 1)? - points.get(i)?))
        };
        // Elimination from the front leaves (v, a)ᵢ = restᵢ − gainᵢ·(v, a)ᵢ₊₁.
        let mut eliminated = [(SMatrix::<T, 2, 2>::zeros(), SMatrix::<T, 2, D>::zeros()); M];
        let mut last = (SMatrix::zeros(), SMatrix::zeros());
        for (i, row) in eliminated.iter_mut().enumerate() {
            let held = if i == 0 { start } else { end };
            *row = match held {
                Some([v, a]) if i == 0 || i + 1 == M => {
                    let rows = [v * unit, a * unit * unit].map(|row| row.transpose());
                    (SMatrix::zeros(), SMatrix::from_rows(&rows))
                }
                _ => {
                    let before = i.checked_sub(1).and_then(segment);
                    let before =
                        before.map_or_else(Side::none, |(h, p)| Side::new(h, p, -T::one()));
                    let after =
                        segment(i).map_or_else(Side::none, |(h, p)| Side::new(h, p, T::one()));
                    let pivot = before.own + after.own - before.other * last.0;
                    let inverse = pivot.try_inverse().ok_or_else(|| Error::Singular {
                        name: "determinant of a pivot of the spline",
                        value: value(pivot.determinant()),
                    })?;
                    let right = before.right + after.right - before.other * last.1;
                    (inverse * after.other, inverse * right)
                }
            };
            last = *row;
        }
        let origin = Boundary::rest([T::zero(); D]);
        let mut spline = Self([Knot { u: T::zero(), state: origin }; M]);
        let mut next = SMatrix::<T, 2, D>::zeros();
        let given = knots.iter().zip(points).zip(&eliminated);
        for (knot, ((u, point), (gain, rest))) in spline.0.iter_mut().zip(given).rev() {
            next = rest - gain * next;
            let velocity = next.row(0).transpose() / unit;
            let acceleration = next.row(1).transpose() / unit / unit;
            *knot = Knot { u: *u, state: Boundary { position: *point, velocity, acceleration } };
        }
        for pair in spline.0.windows(2) {
            if let [from, to] = pair {
                Quintic::new(from.state, to.state, to.u - from.u)?;
            }
        }
        Ok(spline)
    }

    /// The points that it goes through.
    #[cfg(feature = "serde")]
    pub fn points(&self) -> [[T; D]; M] {
        self.0.map(|knot| knot.state.position.into())
    }

    pub fn ends(&self) -> Option<[&Knot<T, D>; 2]> {
        Some([self.0.first()?, self.0.last()?])
    }

    /// Where segment `i` begins, and its polynomial in u from there; `None` for i + 1 ≥ M.
    pub fn segment(&self, i: usize) -> Option<(T, Quintic<T, D>)> {
        let (from, to) = (self.0.get(i)?, self.0.get(i + 1)?);
        Some((from.u, Quintic::between(from.state, to.state, to.u - from.u)))
    }
}

/// The number of the segment that `at` lies in, when segment i begins at `starts[i]`: the first below the range, the last beyond.
pub(super) fn locate<T: Scalar>(starts: &[T], at: T) -> usize {
    match starts {
        [_, inner @ .., _] => inner.partition_point(|start| *start <= at),
        _ => 0,
    }
}

/// What one segment contributes to the two equations of the knot at one of its ends.
struct Side<T, const D: usize> {
    /// The coefficients of the (v, a) of this knot.
    own: SMatrix<T, 2, 2>,
    /// The coefficients of the (v, a) at the other end.
    other: SMatrix<T, 2, 2>,
    /// The right-hand side.
    right: SMatrix<T, 2, D>,
}

impl<T: Scalar, const D: usize> Side<T, D> {
    /// For a segment of length `h` over the difference `p`: `sign` is 1 if it comes after the knot and −1 before.
    fn new(h: T, p: SVector<T, D>, sign: T) -> Self {
        let n = constant::<T>;
        let (h2, h3) = (h * h, h * h * h);
        let (v, cross, a) = (n(192.0) / h3, sign * n(36.0) / h2, n(9.0) / h);
        let own = SMatrix::<T, 2, 2>::new(v, cross, cross, a);
        let (v, cross, a) = (n(168.0) / h3, sign * n(24.0) / h2, n(-3.0) / h);
        let other = SMatrix::<T, 2, 2>::new(v, -cross, cross, a);
        let weights = SVector::<T, 2>::new(n(360.0) / (h3 * h), sign * n(60.0) / h3);
        Self { own, other, right: weights * p.transpose() }
    }

    /// Beyond an end there is none.
    fn none() -> Self {
        Self { own: SMatrix::zeros(), other: SMatrix::zeros(), right: SMatrix::zeros() }
    }
}
