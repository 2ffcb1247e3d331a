//! Euler's method against its formula and its amplification factor.

use brunovsky::{
    Scalar,
    integrators::{Euler, Integrator},
};
use nalgebra::SVector;
use proptest::prelude::*;

proptest! {
    /// On ẋ = p·x a step multiplies by the start of the exponential series: 1 + z, z = p·h.
    #[test]
    fn a_linear_step_is_the_series_of_the_exponential_up_to_first_order(p in -5.0..5.0_f64, h in 0.01..1.0_f64) {
        let z: f64 = p * h;
        let found = Euler.step(|_, x| x * p, 0.0, &SVector::from([1.0]), h)[0];
        prop_assert!((found - (1.0 + z)).abs() <= 4.0 * f64::EPSILON * (1.0 + z.abs()));
    }
}

/// h·f(t, x) is taken at the start of the step: t = 3, x = (2, 5) and h = ½ are exact in any scalar.
fn looks_only_at_the_start<T: Scalar>() {
    let num = nalgebra::convert::<f64, T>;
    let mut calls = 0;
    let found = Euler.step(
        |t, x: &SVector<T, 2>| {
            calls += 1;
            SVector::from([t * x[1], x[0]])
        },
        num(3.0),
        &SVector::from([2.0, 5.0].map(num)),
        num(0.5),
    );
    assert_eq!(found, SVector::from([9.5, 6.0].map(num)));
    assert_eq!(calls, 1);
}

#[test]
fn one_evaluation_at_the_start_of_the_step_at_f32() {
    looks_only_at_the_start::<f32>();
}

#[test]
fn one_evaluation_at_the_start_of_the_step_at_f64() {
    looks_only_at_the_start::<f64>();
}
