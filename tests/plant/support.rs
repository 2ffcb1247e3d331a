//! What the modules of this room share.

use approx::assert_abs_diff_eq;
use brunovsky::{
    Scalar,
    integrators::{Integrator, Rk4},
    plant::Plant,
};
use nalgebra::SVector;

/// `value` in the scalar type of the check.
pub fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// The state after `steps` Runge–Kutta steps over `duration` from t = 0 under a constant input.
pub fn flow<P, const NX: usize, const NU: usize>(
    plant: &P,
    x: impl Into<SVector<P::Scalar, NX>>,
    u: impl Into<SVector<P::Scalar, NU>>,
    duration: P::Scalar,
    steps: u32,
) -> SVector<P::Scalar, NX>
where
    P: Plant<NX, NU>,
{
    let u = u.into();
    Rk4.integrate(|t, x| plant.derivative(t, x, &u), nalgebra::zero(), &x.into(), duration, steps)
        .unwrap()
}

/// Every entry of `found` is within `roundings` units of rounding of `expected`, relative to the larger of 1 and the
/// largest entry expected.
pub fn assert_equal_to_rounding<T: Scalar, const N: usize>(
    found: &SVector<T, N>,
    expected: &SVector<T, N>,
    roundings: f64,
) {
    let scale = expected.amax().max(T::one());
    let epsilon = T::default_epsilon() * num::<T>(roundings) * scale;
    assert_abs_diff_eq!(found, expected, epsilon = epsilon);
}

/// The exponent p for which the error falls like (size)ᵖ, from the errors at a size and at half of it.
pub fn order(at_size: f64, at_half: f64) -> f64 {
    (at_size / at_half).log2()
}
