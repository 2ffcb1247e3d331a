//! `integrate` repeats `step` and refuses what is not finite.

use brunovsky::{
    Error, Scalar,
    integrators::{Euler, Heun, Integrator, Rk4},
};
use nalgebra::SVector;
use proptest::prelude::*;

fn field<T: Scalar>(t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
    SVector::from([x[1], -x[0].sin() + t.cos()])
}

/// Step j starts at t + j·h with h = duration/steps: the same operations, so the same bits.
fn repeats_the_step<I: Integrator, T: Scalar>(method: &I, t: f64, duration: f64, steps: u32) {
    let num = nalgebra::convert::<f64, T>;
    let (t, duration) = (num(t), num(duration));
    let start = SVector::from([0.3, -0.8].map(num));
    let h = duration / num(f64::from(steps));
    let repeated =
        (0..steps).fold(start, |x, j| method.step(field, t + h * num(f64::from(j)), &x, h));
    let integrated = method.integrate(field, t, &start, duration, steps);
    assert_eq!(integrated, Ok(repeated));
}

proptest! {
    #[test]
    fn integration_is_repeated_stepping(t in -5.0..5.0_f64, duration in 0.01..3.0_f64, steps in 1..40_u32) {
        repeats_the_step::<_, f32>(&Euler, t, duration, steps);
        repeats_the_step::<_, f64>(&Euler, t, duration, steps);
        repeats_the_step::<_, f32>(&Heun, t, duration, steps);
        repeats_the_step::<_, f64>(&Heun, t, duration, steps);
        repeats_the_step::<_, f32>(&Rk4, t, duration, steps);
        repeats_the_step::<_, f64>(&Rk4, t, duration, steps);
    }
}

/// Single precision reaches its own rounding: a whole turn of the harmonic oscillator in 200 steps, where the formula's own error
/// 200·(2π/200)⁵/120 = 5e-8 is below one unit of rounding.
#[test]
fn at_f32_the_error_is_that_of_rounding() {
    let turn = |_: f32, x: &SVector<f32, 2>| SVector::from([x[1], -x[0]]);
    let end =
        Rk4.integrate(turn, 0.0, &SVector::from([1.0, 0.0]), core::f32::consts::TAU, 200).unwrap();
    let rounding = 200.0 * f32::EPSILON;
    approx::assert_abs_diff_eq!(end, SVector::from([1.0, 0.0]), epsilon = rounding);
}

/// The number of evaluations of f that three steps take.
fn evaluations(method: &impl Integrator) -> u32 {
    let mut count = 0;
    let counted = |t: f64, x: &SVector<f64, 2>| {
        count += 1;
        field(t, x)
    };
    method.integrate(counted, 0.0, &SVector::zeros(), 1.0, 3).unwrap();
    count
}

#[test]
fn the_cost_is_the_stated_one() {
    assert_eq!(evaluations(&Euler), 3);
    assert_eq!(evaluations(&Heun), 3 * 2);
    assert_eq!(evaluations(&Rk4), 3 * 4);
}

fn refuses_bad_arguments<T: Scalar>(method: &impl Integrator) {
    let num = nalgebra::convert::<f64, T>;
    let x = SVector::from([1.0, 2.0].map(num));
    let integrate =
        |t: f64, duration: f64, steps| method.integrate(field, num(t), &x, num(duration), steps);
    for value in [0.0, -0.5] {
        let refused = Err(Error::NotPositive { name: "duration", value });
        assert_eq!(integrate(0.0, value, 3), refused);
    }
    let refused = Err(Error::NotPositive { name: "steps", value: 0.0 });
    assert_eq!(integrate(0.0, 1.0, 0), refused);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let duration = integrate(0.0, bad, 3).unwrap_err();
        assert!(matches!(duration, Error::NonFinite { name: "duration", .. }));
        let t = integrate(bad, 1.0, 3).unwrap_err();
        assert!(matches!(t, Error::NonFinite { name: "t", .. }));
        let start = SVector::from([T::one(), num(bad)]);
        let state = method.integrate(field, T::zero(), &start, T::one(), 3).unwrap_err();
        assert!(matches!(state, Error::NonFiniteEntry { name: "x", index: 1, .. }));
    }
}

/// A step that would end beyond the range of the scalar is not taken: the field is never asked for such a time.
fn refuses_a_time_beyond_the_range<T: Scalar>(method: &impl Integrator) {
    let most = T::max_value().unwrap();
    let still = |t: T, _: &SVector<T, 1>| {
        assert!(t.is_finite());
        SVector::zeros()
    };
    for (t, duration, steps) in [(most, most, 1), (most, most, 3), (T::zero(), most, 3)] {
        // Three thirds of the greatest number may round to more than it.
        let found = method.integrate(still, t, &SVector::zeros(), duration, steps);
        assert!(t.is_zero() || matches!(found, Err(Error::NonFinite { name: "t", .. })));
    }
}

/// ẋ = x² from 1 has a pole at t = 1. A step past it at least squares x, so a dozen more leave the range of any scalar.
fn reports_a_blow_up<T: Scalar>(method: &impl Integrator) {
    let num = nalgebra::convert::<f64, T>;
    let square = |_: T, x: &SVector<T, 1>| x.map(|x| x * x);
    let start = SVector::from([T::one()]);
    assert!(method.integrate(square, T::zero(), &start, num(0.5), 50).is_ok());
    let error = method.integrate(square, T::zero(), &start, num(5.0), 50);
    assert!(matches!(error, Err(Error::NonFiniteEntry { name: "x", index: 0, .. })));
}

/// A field that fails in its second entry after a while is found at the first bad step.
fn reports_a_field_that_fails(method: &impl Integrator) {
    let mut steps_seen = 0;
    let failing = |t: f64, _: &SVector<f64, 2>| {
        steps_seen += 1;
        SVector::from([0.0, if t > 0.5 { f64::NAN } else { 0.0 }])
    };
    let error = method.integrate(failing, 0.0, &SVector::zeros(), 1.0, 10);
    assert!(matches!(error, Err(Error::NonFiniteEntry { name: "x", index: 1, .. })));
    assert!(steps_seen <= 7 * 4, "it stops there");
}

macro_rules! methods {
    ($($module:ident: $method:expr),+ $(,)?) => {
        $(mod $module {
            use super::*;

            #[test]
            fn a_time_beyond_the_range_is_refused() {
                refuses_a_time_beyond_the_range::<f32>(&$method);
                refuses_a_time_beyond_the_range::<f64>(&$method);
            }

            #[test]
            fn arguments_out_of_range_are_refused_by_name() {
                refuses_bad_arguments::<f32>(&$method);
                refuses_bad_arguments::<f64>(&$method);
            }

            #[test]
            fn a_state_that_leaves_the_range_of_the_scalar_is_an_error() {
                reports_a_blow_up::<f32>(&$method);
                reports_a_blow_up::<f64>(&$method);
                reports_a_field_that_fails(&$method);
            }
        })+
    };
}

methods! {
    euler: Euler,
    heun: Heun,
    rk4: Rk4,
}
