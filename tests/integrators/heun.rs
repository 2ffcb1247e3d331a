//! Heun's method against its formula and its amplification factor.

use brunovsky::{
    Scalar,
    integrators::{Heun, Integrator},
};
use nalgebra::SVector;
use proptest::prelude::*;

proptest! {
    /// On ẋ = p·x a step multiplies by the start of the exponential series: 1 + z + z²/2, z = p·h.
    #[test]
    fn a_linear_step_is_the_series_of_the_exponential_up_to_second_order(p in -5.0..5.0_f64, h in 0.01..1.0_f64) {
        let z: f64 = p * h;
        let found = Heun.step(|_, x| x * p, 0.0, &SVector::from([1.0]), h)[0];
        let terms = [1.0, z, z * z / 2.0];
        let size: f64 = terms.iter().map(|term: &f64| term.abs()).sum();
        prop_assert!((found - terms.iter().sum::<f64>()).abs() <= 8.0 * f64::EPSILON * size);
    }
}

/// The slopes at both ends: t·x = 3·2 = 6 and (3 + ½)·(2 + 6/2) = 17.5, so x⁺ = 2 + ¼·23.5, exact in any scalar.
fn takes_the_mean_of_both_ends<T: Scalar>() {
    let num = nalgebra::convert::<f64, T>;
    let mut times = Vec::new();
    let found = Heun.step(
        |t, x: &SVector<T, 1>| {
            times.push(t);
            x * t
        },
        num(3.0),
        &SVector::from([num(2.0)]),
        num(0.5),
    );
    assert_eq!(found, SVector::from([num(7.875)]));
    assert_eq!(times, [3.0, 3.5].map(num));
}

#[test]
fn two_evaluations_at_both_ends_of_the_step_at_f32() {
    takes_the_mean_of_both_ends::<f32>();
}

#[test]
fn two_evaluations_at_both_ends_of_the_step_at_f64() {
    takes_the_mean_of_both_ends::<f64>();
}
