//! The classical Runge–Kutta method against its amplification factor and Simpson's rule.

use brunovsky::{
    Scalar,
    integrators::{Integrator, Rk4},
};
use nalgebra::SVector;
use proptest::prelude::*;

proptest! {
    /// On ẋ = p·x a step multiplies by the start of the exponential series, z = p·h.
    #[test]
    fn a_linear_step_is_the_series_of_the_exponential_up_to_fourth_order(p in -5.0..5.0_f64, h in 0.01..1.0_f64) {
        let z: f64 = p * h;
        let found = Rk4.step(|_, x| x * p, 0.0, &SVector::from([1.0]), h)[0];
        let terms = [1.0, z, z.powi(2) / 2.0, z.powi(3) / 6.0, z.powi(4) / 24.0];
        let size: f64 = terms.iter().map(|term: &f64| term.abs()).sum();
        prop_assert!((found - terms.iter().sum::<f64>()).abs() <= 16.0 * f64::EPSILON * size);
    }

    /// Without x the method is Simpson's rule h/6·(f(t) + 4·f(t + h/2) + f(t + h)).
    #[test]
    fn a_quadrature_is_simpsons_rule(t in -3.0..3.0_f64, h in 0.01..1.0_f64) {
        let f = |t: f64| (1.7 * t).sin().exp();
        let found = Rk4.step(|t, _: &SVector<f64, 1>| SVector::from([f(t)]), t, &SVector::zeros(), h)[0];
        let simpson = h / 6.0 * (f(t) + 4.0 * f(t + h / 2.0) + f(t + h));
        prop_assert!((found - simpson).abs() <= 8.0 * f64::EPSILON * simpson);
    }
}

fn looks_at_both_ends_and_twice_at_the_middle<T: Scalar>() {
    let num = nalgebra::convert::<f64, T>;
    let mut times = Vec::new();
    let start = SVector::<T, 1>::from([num(2.0)]);
    let end = Rk4.step(
        |t, x| {
            times.push(t);
            *x
        },
        num(3.0),
        &start,
        T::zero(),
    );
    assert_eq!(end, start, "a step of no length goes nowhere");
    assert_eq!(times.len(), 4);
    times.clear();
    Rk4.step(
        |t, x| {
            times.push(t);
            *x
        },
        num(3.0),
        &start,
        num(0.5),
    );
    assert_eq!(times, [3.0, 3.25, 3.25, 3.5].map(num));
}

#[test]
fn four_evaluations_two_of_them_at_the_middle_at_f32() {
    looks_at_both_ends_and_twice_at_the_middle::<f32>();
}

#[test]
fn four_evaluations_two_of_them_at_the_middle_at_f64() {
    looks_at_both_ends_and_twice_at_the_middle::<f64>();
}
