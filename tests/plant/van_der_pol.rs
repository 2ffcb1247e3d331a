//! The Van der Pol oscillator against perturbation theory, its linearization and its symmetry.

use brunovsky::{
    Error, Scalar,
    integrators::{Integrator, Rk4},
    plant::{FeedbackLinearizable, Plant, VanDerPol},
};
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, flow, num, order},
};

fn oscillator<T: Scalar>(mu: f64) -> VanDerPol<T> {
    VanDerPol::new(num(mu)).unwrap()
}

/// For μ = 0, ẍ = −x + u: a rotation about (u, 0).
fn rotates_without_mu<T: Scalar>() {
    let (t, u, x) = (2.5_f64, 0.4, [1.5, -0.5]);
    let found = flow(&oscillator::<T>(0.0), x.map(num::<T>), [num::<T>(u)], num(t), 1000);
    let (sin, cos) = t.sin_cos();
    let expected = [u + (x[0] - u) * cos + x[1] * sin, -(x[0] - u) * sin + x[1] * cos];
    // h⁴ ≈ 4e-11·(1/120) for Rk4, and 1000 steps of rounding.
    let roundings = 1e3 + 1e-12 / f64::EPSILON;
    assert_equal_to_rounding(&found, &SVector::from(expected.map(num)), roundings);
}

fn has_a_gain_of_one_and_the_stated_drift<T: Scalar>() {
    let plant = oscillator::<T>(3.0);
    let x = SVector::from([2.0, 5.0].map(num::<T>));
    // 3·(1 − 4)·5 − 2, whole numbers and therefore exact.
    assert_eq!(plant.drift(&x), num(-47.0));
    assert_eq!(plant.input_gain(&x), T::one());
}

at_f32_and_f64! {
    without_mu_it_is_the_harmonic_oscillator => rotates_without_mu,
    the_law_is_the_stated_one => has_a_gain_of_one_and_the_stated_drift,
}

/// Amplitude and period of the limit cycle: the state at two successive downward crossings of ẋ = 0, each found by Newton's
/// method on the length of a last step.
fn limit_cycle(mu: f64) -> (f64, f64) {
    let plant = oscillator::<f64>(mu);
    let field = |t: f64, x: &SVector<f64, 2>| plant.derivative(t, x, &SVector::zeros());
    let h = 0.005;
    // The transient decays like e^(−μt); e⁻³⁰ is below the error of the integrator.
    let mut x = flow(&plant, [2.0, 0.0], [0.0], 30.0 / mu, (30.0 / mu / h) as u32);
    let mut t = 0.0;
    let mut next_top = || loop {
        let before = (t, x);
        x = Rk4.step(field, t, &x, h);
        t += h;
        if before.1[1] > 0.0 && x[1] <= 0.0 {
            let mut part = h;
            for _ in 0..4 {
                let at = Rk4.step(field, before.0, &before.1, part);
                part -= at[1] / field(0.0, &at)[1];
            }
            return (before.0 + part, Rk4.step(field, before.0, &before.1, part)[0]);
        }
    };
    let (first, second) = (next_top(), next_top());
    (second.1, second.0 - first.0)
}

/// The expansions A = 2 + μ²/96 + O(μ⁴) and T/2π = 1 + μ²/16 + O(μ⁴) (Lindstedt–Poincaré).
#[test]
fn the_limit_cycle_is_that_of_perturbation_theory_to_fourth_order_in_mu() {
    let remainders = |mu: f64| {
        let (amplitude, period) = limit_cycle(mu);
        (
            (amplitude - 2.0 - mu * mu / 96.0).abs(),
            (period / core::f64::consts::TAU - 1.0 - mu * mu / 16.0).abs(),
        )
    };
    let (large, small) = (remainders(0.4), remainders(0.2));
    // The next term has μ⁶: at μ = 0.4 it moves the order by some percent.
    let (amplitude, period) = (order(large.0, small.0), order(large.1, small.1));
    assert!((amplitude - 4.0).abs() < 0.2, "order {amplitude}");
    assert!((period - 4.0).abs() < 0.2, "order {period}");
}

/// Near the origin x(t) = e^(At)·x(0) with A = [0 1; −1 μ]; the first term left out is the cube of the state.
#[test]
fn small_motions_follow_the_linearization_with_an_error_of_third_order() {
    let (mu, t) = (0.8, 3.0);
    let flow_of_a = (SMatrix::<f64, 2, 2>::new(0.0, 1.0, -1.0, mu) * t).exp();
    let deviation = |size: f64| {
        let start = SVector::from([size, -0.5 * size]);
        let found = flow(&oscillator(mu), start, [0.0], t, 6000);
        (found - flow_of_a * start).norm()
    };
    let measured = order(deviation(0.02), deviation(0.01));
    assert!((measured - 3.0).abs() < 0.02, "order {measured}");
}

proptest! {
    #[test]
    fn mirroring_the_state_and_the_input_mirrors_the_motion(
        mu in -3.0..3.0_f64, x in prop::array::uniform2(-4.0..4.0_f64), u in -5.0..5.0_f64,
    ) {
        let plant = oscillator::<f64>(mu);
        let (x, u) = (SVector::from(x), SVector::from([u]));
        // Changing signs is exact in floating point, and the law is odd term by term.
        prop_assert_eq!(plant.derivative(0.0, &-x, &-u), -plant.derivative(0.0, &x, &u));
    }
}

#[test]
fn mu_has_any_sign_and_is_finite() {
    assert!(VanDerPol::new(-2.0).is_ok());
    for mu in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = VanDerPol::new(mu).unwrap_err();
        assert!(matches!(error, Error::NonFinite { name: "mu", .. }));
    }
}
