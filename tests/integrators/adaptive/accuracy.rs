//! The error at the end follows the tolerance.

use brunovsky::{
    Scalar,
    integrators::{DormandPrince, Embedded, Integrator, Linearization, Rk4, Rodas},
};
use nalgebra::{SMatrix, SVector};

use super::{num, pendulum, start};

fn linearization(t: f64, x: &SVector<f64, 2>) -> Linearization<f64, 2> {
    Linearization {
        x: SMatrix::<f64, 2, 2>::new(0.0, 1.0, -x[0].cos(), -0.1),
        t: SVector::from([0.0, -t.sin()]),
    }
}

/// The pendulum at 1, 2, … 12 s by 4000 steps a second of the classical method: h⁴ = 4·10⁻¹⁵.
fn reference() -> Vec<SVector<f64, 2>> {
    let mut x = SVector::from([2.0, 0.0]);
    let second = |t| {
        x = Rk4.integrate(pendulum, f64::from(t), &x, 1.0, 4000).unwrap();
        x
    };
    (0..12).map(second).collect()
}

/// The exponent of error ∝ toleranceᵉ by least squares over seven decades, with the largest error of the twelve.
fn exponent(method: impl Embedded<f64, 2> + Copy) -> f64 {
    let reference = reference();
    let points: Vec<(f64, f64)> = (4..=10)
        .map(|digits| {
            let tolerance = 10.0_f64.powi(-digits);
            let mut solver = start(method, tolerance, pendulum::<f64>, [2.0, 0.0]);
            let times = reference.iter().zip(1..);
            let errors = times.map(|(x, t)| (solver.at(f64::from(t)).unwrap() - x).norm());
            let error = errors.fold(0.0, f64::max);
            (tolerance.log10(), error.log10())
        })
        .collect();
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    covariance / points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>()
}

/// Steps with an estimate of order q are within the tolerance if h ∝ tolerance^(1/(q + 1)), and the error of a method of order q + 1 is
/// then proportional to it.
#[test]
fn the_error_is_about_proportional_to_the_tolerance() {
    let explicit = exponent(DormandPrince);
    assert!((explicit - 1.0).abs() < 0.15, "{explicit}");
    let stiff = exponent(Rodas::with_jacobian(linearization));
    assert!((stiff - 1.0).abs() < 0.15, "{stiff}");
    let differences = exponent(Rodas::new());
    assert!((differences - 1.0).abs() < 0.15, "{differences}");
}

fn a_turn<M: Embedded<T, 2>, T: Scalar>(method: M, tolerance: f64, bound: f64) {
    let oscillator = |_: T, x: &SVector<T, 2>| SVector::from([x[1], -x[0]]);
    let mut solver = start(method, tolerance, oscillator, [1.0, 0.0]);
    let end = *solver.advance(num(core::f64::consts::TAU)).unwrap();
    let error = (end - SVector::from([T::one(), T::zero()])).norm();
    assert!(error < num(bound), "{error}");
}

/// One turn of the oscillator, within a hundred times the tolerance of a step.
#[test]
fn both_methods_work_in_single_precision() {
    a_turn::<_, f32>(DormandPrince, 1e-5, 1e-3);
    a_turn::<_, f32>(Rodas::new(), 1e-4, 1e-2);
    a_turn::<_, f64>(DormandPrince, 1e-11, 1e-9);
    a_turn::<_, f64>(Rodas::new(), 1e-9, 1e-7);
}

/// An exact solution of degree 4 or less is met whatever the tolerance: the pair makes no error there, and the step grows tenfold.
#[test]
fn a_polynomial_takes_a_handful_of_steps() {
    let f = |t: f64, _: &SVector<f64, 1>| SVector::from([4.0 * t.powi(3) - 2.0 * t]);
    let mut solver = start(DormandPrince, 1e-9, f, [1.0]);
    let end = solver.advance(3.0).unwrap()[0];
    approx::assert_relative_eq!(end, 1.0 + 81.0 - 9.0, max_relative = 1e-14);
    assert!(solver.statistics().accepted < 8);
}
