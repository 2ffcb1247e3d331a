//! Elementary functions in the scalar's own precision.
//!
//! On a microcontroller with a single-precision floating-point unit, `libm` computes `sinf`, `cosf` and `hypotf` in software with double
//! precision. These stay in `f32`:
//!
//! | function | for `f32` | error |
//! |---|---|---|
//! | [`sin_cos`], [`sin`], [`cos`] | [`wide`]: reduction in three parts, polynomials of degree 7 and 8 | 1.2·10⁻⁷ absolute for \|x\| ≤ 8192, beyond that of an x half an ulp off |
//! | [`hypot`] | \|max\|·√(1 + (min/max)²) | 2 ulp |
//!
//! They are used without the feature `std`, and with the feature `reproducible`. Otherwise, and for every other scalar, the functions of
//! [`RealField`](nalgebra::RealField) are taken; those that are missing here (`exp`, `ln`, `sqrt`, `atan2`) need no double precision.
//!
//! A plant of one's own that runs in `f32` on such a machine should take them too.

use core::any::TypeId;

use crate::Scalar;

/// Whether the functions of the platform are not to be used.
const PORTABLE: bool = cfg!(any(feature = "reproducible", not(feature = "std")));

/// sin x and cos x, x in rad.
pub fn sin_cos<T: Scalar>(x: T) -> (T, T) {
    if !is_single::<T>() {
        return x.sin_cos();
    }
    let (sin, cos) = wide::f32x4::splat(reduced(single(x))).sin_cos();
    let [sin, ..] = sin.to_array();
    let [cos, ..] = cos.to_array();
    (T::from_subset(&sin), T::from_subset(&cos))
}

/// sin x, x in rad.
pub fn sin<T: Scalar>(x: T) -> T {
    if is_single::<T>() { sin_cos(x).0 } else { x.sin() }
}

/// cos x, x in rad.
pub fn cos<T: Scalar>(x: T) -> T {
    if is_single::<T>() { sin_cos(x).1 } else { x.cos() }
}

/// √(x² + y²), without overflow on the way.
pub fn hypot<T: Scalar>(x: T, y: T) -> T {
    if !is_single::<T>() {
        return x.hypot(y);
    }
    let (x, y) = (x.abs(), y.abs());
    let (small, large) = if x < y { (x, y) } else { (y, x) };
    if large.is_zero() || !large.is_finite() {
        // The quotient would be 0/0 or ∞/∞.
        return large + small;
    }
    let ratio = small / large;
    large * (T::one() + ratio * ratio).sqrt()
}

fn is_single<T: Scalar>() -> bool {
    PORTABLE && TypeId::of::<T>() == TypeId::of::<f32>()
}

/// `x`, which is an `f32`, as one.
fn single<T: Scalar>(x: T) -> f32 {
    x.to_subset_unchecked()
}

/// An angle for the reduction in three parts, which is exact up to 8192 rad: larger ones come as the exact remainder of the nearest `f32` to 2π,
/// 1/35 000 000 off.
fn reduced(x: f32) -> f32 {
    if x.abs() <= 8192.0 { x } else { x % core::f32::consts::TAU }
}
