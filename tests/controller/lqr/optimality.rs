use brunovsky::{
    Error,
    controller::lqr::{self, Regulator},
};
use nalgebra::{Complex, DMatrix, SMatrix, SVector};
use proptest::prelude::*;

use super::{Case, any_case, by_linear_equations, by_linear_equations_in_steps, eigenvalues};

/// The regulator of a plant that is well stabilizable. One that takes larger gains, with weights and entries of order 1, is hardly so, and its
/// equation is ill-conditioned, by the square of the gain and more: it may be refused.
fn regulated<const NX: usize, const NU: usize>(
    case: &Case<NX, NU>,
    found: Result<Regulator<f64, NX, NU>, Error>,
) -> Option<Regulator<f64, NX, NU>> {
    match found {
        Ok(regulator) => Some(regulator).filter(|regulator| regulator.gain.norm() < 100.0),
        Err(error) => {
            assert!(distance_to_unstabilizable(case) < 1e-3, "{error} {case:?}");
            None
        }
    }
}

/// The least singular value of (λ·I − A, B) over the eigenvalues λ of A: how far the plant is from one with a mode out of reach (Popov,
/// Belevitch, Hautus).
fn distance_to_unstabilizable<const NX: usize, const NU: usize>(case: &Case<NX, NU>) -> f64 {
    let distances = eigenvalues(&case.a).into_iter().map(|pole| {
        let pencil = DMatrix::from_fn(NX, NX + NU, |i, j| match j.checked_sub(NX) {
            Some(j) => Complex::from(case.b[(i, j)]),
            None if i == j => pole - case.a[(i, j)],
            None => Complex::from(-case.a[(i, j)]),
        });
        pencil.singular_values().min()
    });
    distances.fold(f64::MAX, f64::min)
}

/// The residual, the eigenvalues, and P as the cost matrix of u = −K·x; the cost of any other gain is larger, by the square of the difference.
fn is_optimal<const NX: usize, const NU: usize>(case: &Case<NX, NU>, other: &SMatrix<f64, NU, NX>) {
    let found = lqr::continuous(&case.a, &case.b, &case.weights);
    let Some(regulator) = regulated(case, found) else { return };
    let (k, p) = (regulator.gain, regulator.value);
    let closed = case.a - case.b * k;
    // Products in which terms cancel are less exact than large; hardly stabilizable plants have such.
    assert!(regulator.residual <= 1e-10, "{}", regulator.residual);
    assert!(eigenvalues(&closed).iter().all(|pole| pole.re < 0.0), "{closed}");
    assert_eq!(p, p.transpose());
    assert!(eigenvalues(&p).iter().all(|value| value.re >= -1e-9 * p.norm()));
    let found = by_linear_equations(&closed, &case.rate(&k));
    assert!((found - p).norm() <= 1e-6 * p.norm(), "{found} {p}");
    let cost = |step: f64| {
        let k = k + other * step;
        by_linear_equations(&(case.a - case.b * k), &case.rate(&k)).trace()
    };
    let margin = eigenvalues(&closed).iter().map(|pole| -pole.re).fold(f64::MAX, f64::min);
    let step = 1e-3 * margin / (1.0 + (case.b * other).norm());
    assert!(cost(step) >= cost(0.0) * (1.0 - 1e-6) && cost(-step) >= cost(0.0) * (1.0 - 1e-6));
}

fn is_optimal_in_steps<const NX: usize, const NU: usize>(case: &Case<NX, NU>) {
    let found = lqr::discrete(&case.a, &case.b, &case.weights);
    let Some(regulator) = regulated(case, found) else { return };
    let (k, p) = (regulator.gain, regulator.value);
    let closed = case.a - case.b * k;
    assert!(regulator.residual <= 1e-10, "{}", regulator.residual);
    assert!(eigenvalues(&closed).iter().all(|pole| pole.norm() < 1.0), "{closed}");
    assert_eq!(p, p.transpose());
    let found = by_linear_equations_in_steps(&closed, &case.rate(&k));
    assert!((found - p).norm() <= 1e-6 * p.norm(), "{found} {p}");
}

/// A state in other units, x = D·z, is the same problem: the gain is K·D, the value D·P·D.
fn does_not_depend_on_units<const NX: usize, const NU: usize>(
    case: &Case<NX, NU>,
    units: &SVector<f64, NX>,
) {
    let d = SMatrix::<f64, NX, NX>::from_diagonal(units);
    let inverse = SMatrix::<f64, NX, NX>::from_diagonal(&units.map(f64::recip));
    let Case { a, b, weights } = case;
    let other = lqr::Weights::with_cross(d * weights.q() * d, *weights.r(), d * weights.n());
    let Ok(other) = other else { panic!("{units}") };
    let Some(regulator) = regulated(case, lqr::continuous(a, b, weights)) else { return };
    let scaled = lqr::continuous(&(inverse * a * d), &(inverse * b), &other).unwrap();
    let back = scaled.gain * inverse;
    assert!(
        (back - regulator.gain).norm() <= 1e-6 * regulator.gain.norm(),
        "{scaled:?} {regulator:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn no_other_gain_costs_less(
        first in any_case::<1, 1>(), second in any_case::<2, 1>(), third in any_case::<3, 2>(), fourth in any_case::<5, 2>(),
        entries in prop::collection::vec(-1.0..1.0_f64, 10),
    ) {
        is_optimal(&first, &SMatrix::from_fn(|i, j| entries[i + j]));
        is_optimal(&second, &SMatrix::from_fn(|i, j| entries[i + j]));
        is_optimal(&third, &SMatrix::from_fn(|i, j| entries[2 * j + i]));
        is_optimal(&fourth, &SMatrix::from_fn(|i, j| entries[2 * j + i]));
        is_optimal_in_steps(&first);
        is_optimal_in_steps(&second);
        is_optimal_in_steps(&third);
        is_optimal_in_steps(&fourth);
    }

    #[test]
    fn units_do_not_matter(
        second in any_case::<2, 1>(), third in any_case::<3, 2>(), powers in prop::array::uniform3(-4.0..4.0_f64),
    ) {
        let units = powers.map(|power| 10.0_f64.powf(power));
        does_not_depend_on_units(&second, &SVector::from([units[0], units[1]]));
        does_not_depend_on_units(&third, &SVector::from(units));
    }
}
