//! What the modules of this room share.

use brunovsky::{Scalar, trajectory::Trajectory};
use nalgebra::SVector;
use proptest::prelude::*;

pub const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Waypoints of a drive with bends to both sides, unevenly spaced.
pub const WINDING: [[f64; 2]; 6] =
    [[0.0, 0.0], [2.0, 0.5], [3.0, 2.0], [5.0, 2.5], [6.5, 1.0], [9.0, 1.5]];

/// `value` in the scalar type of the check.
pub fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// `points` in the scalar type of the check.
pub fn nums<T: Scalar, const D: usize, const M: usize>(points: [[f64; D]; M]) -> [[T; D]; M] {
    points.map(|point| point.map(num))
}

/// `count` random cases; failures are shown and not written to a file.
pub fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

/// Every entry of `found` is within `roundings` units of rounding of `expected`, relative to the larger of 1 and the largest entry
/// expected.
#[track_caller]
pub fn assert_equal_to_rounding<T: Scalar, const N: usize>(
    found: SVector<T, N>,
    expected: SVector<T, N>,
    roundings: f64,
) {
    let within = T::default_epsilon() * num(roundings) * expected.amax().max(T::one());
    // Not `>`: NaN has to fail.
    assert!((found - expected).amax() <= within, "{found} is not {expected} within {within}");
}

/// The same for all derivatives in two jets.
#[track_caller]
pub fn assert_jets_equal<T: Scalar, const N: usize, const K: usize>(
    found: [SVector<T, N>; K],
    expected: [SVector<T, N>; K],
    roundings: f64,
) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert_equal_to_rounding(found, expected, roundings);
    }
}

/// The exponent p for which the error falls like (size)ᵖ, from the errors at a size and at half of it.
pub fn order(at_size: f64, at_half: f64) -> f64 {
    (at_size / at_half).log2()
}

/// ∫f over \[from, to\] by the three-point Gauss–Legendre rule on `panels` parts: exact for polynomials of degree 5, order 6.
pub fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64, panels: u32) -> f64 {
    let half = (to - from) / f64::from(2 * panels);
    let panel = |j: u32| {
        let middle = from + half * f64::from(2 * j + 1);
        let reach = half * 0.6_f64.sqrt();
        half / 9.0 * (5.0 * f(middle - reach) + 8.0 * f(middle) + 5.0 * f(middle + reach))
    };
    (0..panels).map(panel).sum()
}

/// `inner` with nothing but its derivatives: what it knows in closed form is hidden.
pub struct Hidden<R>(pub R);

impl<R: Trajectory<D>, const D: usize> Trajectory<D> for Hidden<R> {
    type Scalar = R::Scalar;

    fn derivatives(&self, t: R::Scalar, out: &mut [SVector<R::Scalar, D>]) {
        self.0.derivatives(t, out);
    }
}
