//! What the modules of this room share.

use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    integrators::{Integrator, Rk4},
    plant::Plant,
};
use nalgebra::SVector;
use num_dual::Dual64;

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

/// The rate of `energy` where the state `x` moves at `rate`, exact by dual numbers.
pub fn power<const N: usize>(
    energy: impl Fn(&SVector<Dual64, N>) -> Dual64,
    x: &SVector<f64, N>,
    rate: &SVector<f64, N>,
) -> f64 {
    energy(&x.zip_map(rate, Dual64::new)).eps
}

/// The name of a parameter, and the constructor with a value for it.
type Constructor<P> = (&'static str, fn(f64) -> Result<P, Error>);

/// A constructor that refuses a parameter says so by its name.
pub struct Refusals<P: 'static>(pub &'static [Constructor<P>]);

impl<P: 'static> Refusals<P> {
    pub fn all_are_finite(&self) {
        for (name, new) in self.0 {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let error = new(value).err().unwrap();
                assert!(matches!(error, Error::NonFinite { name: found, .. } if found == *name));
            }
        }
    }

    pub fn all_are_positive(&self) {
        self.all_are_finite();
        for &(name, new) in self.0 {
            assert!(new(1e-3).is_ok());
            for value in [0.0, -0.0, -1.0] {
                assert_eq!(new(value).err(), Some(Error::NotPositive { name, value }));
            }
        }
    }

    pub fn none_is_negative(&self) {
        self.all_are_finite();
        for &(name, new) in self.0 {
            assert!(new(0.0).is_ok());
            let value = -1e-300;
            assert_eq!(new(value).err(), Some(Error::Negative { name, value }));
        }
    }
}
