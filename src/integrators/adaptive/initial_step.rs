use nalgebra::SVector;

use super::Point;
use crate::{Scalar, scalar::constant};

/// A first step for a method of order `order`, from the sizes of x, ẋ and ẍ in units of the tolerance, at most `longest`. It costs one
/// evaluation of f.
///
/// # References
/// E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.4, "starting step size".
pub(crate) fn initial_step<T: Scalar, const N: usize>(
    mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
    at: &Point<T, N>,
    weights: &SVector<T, N>,
    order: i32,
    longest: Option<T>,
) -> T {
    let within = |h: T| longest.map_or(h, |longest| h.min(longest));
    // Not a mean: one component that is fast among many that are not decides.
    let norm = |v: &SVector<T, N>| v.component_div(weights).norm();
    let (d0, d1) = (norm(&at.x), norm(&at.rate));
    let small = constant(1e-5);
    let ratio = d0 / d1 * constant(0.01);
    // Without sizes to compare, or with some beyond the range, any short step will do.
    let usable = d0 >= small && d1 >= small && ratio.is_finite() && ratio > T::zero();
    let h0 = within(if usable { ratio } else { constant(1e-6) });
    let rate = f(at.t + h0, &(at.x + at.rate * h0));
    let d2 = norm(&(rate - at.rate)) / h0;
    let rate = d1.max(d2);
    let h1 = if rate <= constant(1e-15) {
        (h0 * constant(1e-3)).max(constant(1e-6))
    } else {
        (constant::<T>(0.01) / rate).powf(constant(1.0 / f64::from(order)))
    };
    let h = within(h1.min(h0 * constant(100.0)));
    // Where ẍ is not finite, nothing is known but a step that is short.
    if d2.is_finite() && h > T::zero() { h } else { h0 }
}
