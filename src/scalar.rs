//! The number type that everything is generic over.

use nalgebra::RealField;

/// A real number: `f32`, `f64`, or a dual number when derivatives through the loop are wanted.
///
/// Implemented for every `Copy` type with nalgebra's [`RealField`]; there is nothing to implement by hand.
pub trait Scalar: RealField + Copy {}

impl<T: RealField + Copy> Scalar for T {}

/// The constant `value` in the scalar type of the surrounding law.
pub(crate) fn constant<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// The spacing of the scalar type's numbers at 1.
pub(crate) fn epsilon<T: Scalar>() -> T {
    T::default_epsilon()
}

/// `x` after a step of `step` ≥ 0 toward zero; once there, −0, the number that changes no sum.
pub(crate) fn faded<T: Scalar>(x: T, step: T) -> T {
    let left = x.abs() - step;
    if left > T::zero() { left.copysign(x) } else { -T::zero() }
}
