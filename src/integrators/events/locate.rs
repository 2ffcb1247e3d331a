use core::cmp::Ordering;

use crate::{Error, Scalar, scalar::constant};

/// Where `g` leaves its `side` of zero between `a`, with the value `at_a`, and `b`, with the value `at_b`: the later end of a bracket of
/// width `tolerance`, so that g has left there, and its value.
///
/// The ITP method: interpolation, truncated towards the middle and projected on what bisection would reach. It converges faster than
/// linearly where g is smooth and needs at most one evaluation more than bisection where it is not.
///
/// # References
/// I. F. D. Oliveira, R. H. C. Takahashi, "An enhancement of the bisection method average performance preserving minmax optimality", ACM
/// Trans. Math. Softw. 47(1), 2020, with κ₁ = 0.2/(b − a), κ₂ = 2, n₀ = 1.
pub(super) fn locate<T: Scalar>(
    mut g: impl FnMut(T) -> Result<T, Error>,
    side: Ordering,
    (mut a, mut at_a): (T, T),
    (mut b, mut at_b): (T, T),
    tolerance: T,
) -> Result<(T, T), Error> {
    let half = constant::<T>(0.5);
    let truncation = constant::<T>(0.2) / (b - a);
    // Bisection halves the width; n₀ = 1 lets it be twice that.
    let mut reach = b - a;
    while b - a > tolerance {
        let middle = a + (b - a) * half;
        let interpolated = a - at_a * ((b - a) / (at_b - at_a));
        let towards = if middle < interpolated { -T::one() } else { T::one() };
        let shift = truncation * (b - a) * (b - a);
        let far = (middle - interpolated).abs() >= shift;
        let truncated = if far { interpolated + towards * shift } else { middle };
        let radius = (reach - (b - a) * half).max(T::zero());
        let near = (truncated - middle).abs() <= radius;
        let projected = if near { truncated } else { middle - towards * radius };
        let t = if projected > a && projected < b { projected } else { middle };
        if t <= a || t >= b {
            break;
        }
        let at_t = g(t)?;
        if sign(at_t) == side {
            (a, at_a) = (t, at_t);
        } else {
            (b, at_b) = (t, at_t);
        }
        reach *= half;
    }
    Ok((b, at_b))
}

/// Which side of zero a value is on; `Equal` for zero itself.
pub(super) fn sign<T: Scalar>(value: T) -> Ordering {
    value.partial_cmp(&T::zero()).unwrap_or(Ordering::Equal)
}
