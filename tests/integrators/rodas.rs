//! RODAS against its stability function, its order with time in f, and problems that explicit methods cannot afford.

use brunovsky::{
    Scalar,
    integrators::{
        Adaptive, DormandPrince, Embedded, FiniteDifferences, Jacobian, Linearization, Point,
        Rodas, Tolerance,
    },
};
use nalgebra::{Complex, SMatrix, SVector};
use proptest::prelude::*;

fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// R(z): a step of length 1 on ẋ = z·x from 1, with x in the plane.
fn stability(z: Complex<f64>) -> Complex<f64> {
    let matrix = SMatrix::<f64, 2, 2>::new(z.re, -z.im, z.im, z.re);
    let method = Rodas::with_jacobian(move |_: f64, _: &SVector<f64, 2>| Linearization {
        x: matrix,
        t: SVector::zeros(),
    });
    let x = SVector::from([1.0, 0.0]);
    let from = Point { t: 0.0, x, rate: matrix * x };
    let f = |_: f64, x: &SVector<f64, 2>| matrix * x;
    let linearization = method.linearize(f, &from, 1.0, &SVector::repeat(1.0));
    let end = method.attempt(f, &from, &linearization, 1.0).unwrap().x;
    Complex::new(end[0], end[1])
}

proptest! {
    /// A-stable: |R(z)| ≤ 1 in the left half plane, over many powers of ten.
    #[test]
    fn no_motion_of_the_left_half_plane_grows(exponent in -3.0..9.0_f64, angle in 90.0..=270.0_f64) {
        let z = Complex::from_polar(10.0_f64.powf(exponent), angle.to_radians());
        let rounding = 100.0 * f64::EPSILON * (1.0 + z.norm());
        prop_assert!(stability(z).norm() <= 1.0 + rounding.min(1e-6));
    }

    /// (1 − z/4)⁶·R(z) is a polynomial, so R equals e^z up to the fourth power: R(z) − e^z = O(z⁵).
    #[test]
    fn near_zero_it_is_the_exponential_up_to_fourth_order(angle in 0.0..360.0_f64) {
        let error = |size: f64| {
            let z = Complex::from_polar(size, angle.to_radians());
            (stability(z) - z.exp()).norm()
        };
        prop_assert!(error(0.05) < 0.05_f64.powi(5));
        let order = (error(0.1) / error(0.05)).log2();
        prop_assert!((order - 5.0).abs() < 0.2, "{order}");
    }
}

/// On the imaginary axis, the boundary of the left half plane, |R| ≤ 1 decides A-stability by the maximum principle.
#[test]
fn no_oscillation_grows() {
    for k in 0..4000 {
        let z = Complex::new(0.0, 10.0_f64.powf(f64::from(k) / 500.0 - 3.0));
        assert!(stability(z).norm() <= 1.0 + 1e-12, "{z}");
    }
}

/// L-stable: R(∞) = 0, and since it is rational R falls like 1/|z| at least.
#[test]
fn a_motion_that_is_infinitely_fast_is_gone_after_one_step() {
    for angle in [100.0_f64, 135.0, 180.0, 225.0, 260.0] {
        for size in [1e4, 1e6, 1e8] {
            let z = Complex::from_polar(size, angle.to_radians());
            assert!(stability(z).norm() * size < 100.0, "{z}");
        }
    }
}

/// ẋ = −λ·(x − φ(t)) + φ′(t) with the solution φ = sin (Prothero and Robinson, 1974): time enters f with a large derivative.
fn prothero_robinson(lambda: f64) -> impl Fn(f64, &SVector<f64, 1>) -> SVector<f64, 1> + Copy {
    move |t, x| SVector::from([-lambda * (x[0] - t.sin()) + t.cos()])
}

fn steps(method: impl Embedded<f64, 1>, lambda: f64, steps: i32) -> f64 {
    let f = prothero_robinson(lambda);
    let h = 2.0 / f64::from(steps);
    let mut x = SVector::from([0.0]);
    for k in 0..steps {
        let t = f64::from(k) * h;
        let from = Point { t, x, rate: f(t, &x) };
        let linearization = method.linearize(f, &from, h, &SVector::repeat(1e-9));
        x = method.attempt(f, &from, &linearization, h).unwrap().x;
    }
    (x[0] - 2.0_f64.sin()).abs()
}

/// With ∂f/∂t the order is 4; without, it is lost.
#[test]
fn time_in_f_is_part_of_the_linearization() {
    let exact = |t: f64, _: &SVector<f64, 1>| Linearization {
        x: SMatrix::<f64, 1, 1>::new(-5.0),
        t: SVector::from([5.0 * t.cos() - t.sin()]),
    };
    let order = |coarse: f64, fine: f64| (coarse / fine).log2();
    let exact = Rodas::with_jacobian(exact);
    let measured = order(steps(exact, 5.0, 320), steps(exact, 5.0, 640));
    assert!((measured - 4.0).abs() < 0.15, "{measured}");
    // Differences are √ε off, which shows where the error of the method is that small, and not here.
    let (found, expected) = (steps(Rodas::new(), 5.0, 40), steps(exact, 5.0, 40));
    approx::assert_relative_eq!(found, expected, max_relative = 0.01);
    let blind = Rodas::autonomous();
    let measured = order(steps(blind, 5.0, 160), steps(blind, 5.0, 320));
    assert!(measured < 2.5, "{measured}");
}

/// A nonlinear field with time, in units far apart, against its derivatives by hand.
fn differences_are_close_to_the_derivatives<T: Scalar>() {
    let f = |t: T, x: &SVector<T, 3>| {
        SVector::from([
            x[0] * x[1] * num(1e3) + t.sin(),
            x[0].exp() - x[2] * x[2] * num(1e-3),
            t * t * x[2] * num(1e-2) - x[1] * num(1e3),
        ])
    };
    let (t, x) = (num(2.0), SVector::from([0.5, 1e-3, -40.0].map(num)));
    let from = Point { t, x, rate: f(t, &x) };
    let weights = SVector::from([1e-4, 1e-7, 1e-2].map(num));
    let found = FiniteDifferences::new().linearize(f, &from, num(1e-3), &weights);
    let zero = T::zero();
    #[rustfmt::skip]
    let expected = SMatrix::<T, 3, 3>::new(
        x[1] * num(1e3), x[0] * num(1e3), zero,
        x[0].exp(), zero, -num::<T>(2e-3) * x[2],
        zero, -num::<T>(1e3), t * t * num(1e-2),
    );
    // A change of x by √ε·x changes terms of up to 3 by some √ε of it, with an error of ε for the curvature and of a few ε for the rounding.
    let bound = T::default_epsilon().sqrt() * num(20.0);
    for (j, column) in (found.x - expected).column_iter().enumerate() {
        assert!((column * x[j]).amax() < bound, "column {j}: {column}");
    }
    let by_time = SVector::from([t.cos(), zero, t * x[2] * num(2e-2)]);
    // Time moves by no more than h = 0.001, which is below √ε·t at f32: there the rounding is divided by less.
    let moved = (T::default_epsilon().sqrt() * t).min(num(1e-3));
    let bound = moved + T::default_epsilon() * num(20.0) / moved;
    assert!((found.t - by_time).amax() < bound, "{}", found.t);
    let none = FiniteDifferences::autonomous().linearize(f, &from, num(1e-3), &weights);
    assert_eq!((none.x, none.t), (found.x, SVector::zeros()));
}

#[test]
fn differences_are_close_to_the_derivatives_at_f32() {
    differences_are_close_to_the_derivatives::<f32>();
}

#[test]
fn differences_are_close_to_the_derivatives_at_f64() {
    differences_are_close_to_the_derivatives::<f64>();
}

/// Robertson's reaction at t = 10¹¹ by the reference solution of Hairer and Wanner (*II*, IV.10), y₁ and y₂ (y₃ = 1 − y₁ − y₂).
#[test]
fn robertsons_reaction_ends_where_the_literature_says() {
    let f = |_: f64, x: &SVector<f64, 3>| {
        let (forth, back, third) = (0.04 * x[0], 1e4 * x[1] * x[2], 3e7 * x[1] * x[1]);
        SVector::from([back - forth, forth - back - third, third])
    };
    let tolerance = Tolerance::per_component(1e-7, [1e-13, 1e-17, 1e-13]).unwrap();
    let method = Adaptive::new(Rodas::autonomous(), tolerance);
    let mut solver = method.solve(f, 0.0, [1.0, 0.0, 0.0]).unwrap();
    let end = *solver.advance(1e11).unwrap();
    approx::assert_relative_eq!(end[0], 0.2083340149701255e-7, max_relative = 1e-5);
    approx::assert_relative_eq!(end[1], 0.8333360770334713e-13, max_relative = 1e-5);
    // A linear invariant of f is one of the method.
    approx::assert_abs_diff_eq!(end.sum(), 1.0, epsilon = 1e-12);
}

/// ẋ₁ = x₂, x₂ chased by a lag of 1 µs: the explicit pair has to resolve it all the time, RODAS only at the start.
#[test]
fn a_stiff_lag_costs_the_explicit_method_many_times_more() {
    let f = |t: f64, x: &SVector<f64, 2>| SVector::from([x[1], (t.cos() - x[1]) * 1e6]);
    let tolerance = Tolerance::new(1e-6, 1e-9).unwrap();
    let mut stiff = Adaptive::new(Rodas::new(), tolerance).solve(f, 0.0, [0.0, 1.0]).unwrap();
    let mut explicit = Adaptive::new(DormandPrince, tolerance).solve(f, 0.0, [0.0, 1.0]).unwrap();
    // The lag turns cos t into cos t + 1e-6·sin t + O(1e-12), whose integral is sin t + 1e-6·(1 − cos t).
    let expected = 0.1_f64.sin() + 1e-6 * (1.0 - 0.1_f64.cos());
    for x in [stiff.advance(0.1).unwrap(), explicit.advance(0.1).unwrap()] {
        approx::assert_abs_diff_eq!(x[0], expected, epsilon = 1e-7);
    }
    let (few, many) = (stiff.statistics().evaluations, explicit.statistics().evaluations);
    assert!(many > 100 * few, "{few} against {many}");
}

/// The equations (I/(γ·h) − J)·u = … are singular at h = 4/λ on ẋ = λ·x: a rejected step, not a failure.
#[test]
fn a_singular_step_is_rejected() {
    let f = |_: f64, x: &SVector<f64, 1>| *x;
    let exact = |_: f64, _: &SVector<f64, 1>| Linearization {
        x: SMatrix::<f64, 1, 1>::new(1.0),
        t: SVector::zeros(),
    };
    let method = Rodas::with_jacobian(exact);
    let from = Point { t: 0.0, x: SVector::from([1.0]), rate: SVector::from([1.0]) };
    let linearization = method.linearize(f, &from, 4.0, &SVector::repeat(1.0));
    assert_eq!(method.attempt(f, &from, &linearization, 4.0), None);
    let settings = Adaptive::new(method, Tolerance::new(1e-6, 1e-6).unwrap());
    let mut solver = settings.with_first_step(4.0).unwrap().solve(f, 0.0, [1.0]).unwrap();
    let end = *solver.advance(5.0).unwrap();
    approx::assert_relative_eq!(end[0], 5.0_f64.exp(), max_relative = 1e-5);
    assert!(solver.statistics().rejected > 0);
}
