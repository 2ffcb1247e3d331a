use brunovsky::{
    controller::{
        Gains,
        lqr::{self, Weights},
    },
    integrators::{Integrator, Rk4},
};
use nalgebra::{DMatrix, SMatrix, SVector};
use proptest::prelude::*;

use super::{Case, any_case, chain, eigenvalues};

/// The integrals of a mass under a held force are polynomials in h.
#[test]
fn a_held_mass_has_its_closed_form() {
    let (a, b) = chain::<f64, 2>();
    let (q1, q2, r) = (3.0, 0.7, 0.2);
    let weights = Weights::diagonal([q1, q2], [r]).unwrap();
    for h in [1e-3, 0.1, 0.9, 20.0_f64] {
        let held = lqr::held(&a, &b, &weights, h).unwrap();
        let [h2, h3, h4, h5] = [2, 3, 4, 5].map(|power| h.powi(power));
        let close = |found: &[f64], expected: &[f64]| {
            for (found, expected) in found.iter().zip(expected) {
                approx::assert_relative_eq!(*found, *expected, max_relative = 1e-14);
            }
        };
        close(held.a.as_slice(), &[1.0, 0.0, h, 1.0]);
        close(held.b.as_slice(), &[h2 / 2.0, h]);
        let (off, of_speed) = (q1 * h2 / 2.0, q1 * h3 / 3.0 + q2 * h);
        close(held.weights.q().as_slice(), &[q1 * h, off, off, of_speed]);
        close(held.weights.n().as_slice(), &[q1 * h3 / 6.0, q1 * h4 / 8.0 + q2 * h2 / 2.0]);
        close(held.weights.r().as_slice(), &[r * h + q1 * h5 / 20.0 + q2 * h3 / 3.0]);
    }
}

/// Three periods under one input are one of three times the length; three is no power of 2, so the doublings differ.
fn composes<const NX: usize, const NU: usize>(case: &Case<NX, NU>, h: f64) {
    let Case { a, b, weights } = case;
    let (short, long) =
        (lqr::held(a, b, weights, h).unwrap(), lqr::held(a, b, weights, 3.0 * h).unwrap());
    let reference = (DMatrix::from_column_slice(NX, NX, a.as_slice()) * h).exp();
    let reference = SMatrix::<f64, NX, NX>::from_column_slice(reference.as_slice());
    assert!((reference - short.a).norm() <= 1e-12 * reference.norm());
    let mut phi = SMatrix::<f64, NX, NX>::identity();
    let mut gamma = SMatrix::<f64, NX, NU>::zeros();
    let (mut q, mut r) = (SMatrix::<f64, NX, NX>::zeros(), SMatrix::<f64, NU, NU>::zeros());
    let mut n = SMatrix::<f64, NX, NU>::zeros();
    let (of_q, of_r, of_n) = (short.weights.q(), short.weights.r(), short.weights.n());
    for _ in 0..3 {
        q += phi.transpose() * of_q * phi;
        n += phi.transpose() * (of_q * gamma + of_n);
        let cross = gamma.transpose() * of_n;
        r += gamma.transpose() * of_q * gamma + cross + cross.transpose() + of_r;
        gamma = short.a * gamma + short.b;
        phi = short.a * phi;
    }
    assert!((long.a - phi).norm() <= 1e-11 * phi.norm());
    assert!((long.b - gamma).norm() <= 1e-11 * gamma.norm());
    assert!((long.weights.q() - q).norm() <= 1e-11 * q.norm());
    assert!((long.weights.n() - n).norm() <= 1e-11 * (q.norm() + n.norm()));
    assert!((long.weights.r() - r).norm() <= 1e-11 * r.norm());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

    #[test]
    fn three_short_periods_are_a_long_one(second in any_case::<2, 1>(), third in any_case::<3, 2>(), h in 0.01..1.0_f64) {
        composes(&second, h);
        composes(&third, h);
    }

    #[test]
    fn the_sampled_loop_is_stable(third in any_case::<3, 2>(), h in 0.01..0.5_f64) {
        let regulator = lqr::sampled(&third.a, &third.b, &third.weights, h).unwrap();
        let held = lqr::held(&third.a, &third.b, &third.weights, h).unwrap();
        let closed = held.a - held.b * regulator.gain;
        prop_assert!(eigenvalues(&closed).iter().all(|pole| pole.norm() < 1.0));
    }
}

/// The integral of the cost along the motion itself, with the cost as one more state, is x(0)ᵀ·P·x(0).
#[test]
fn the_value_is_the_cost_of_the_motion() {
    let a = SMatrix::<f64, 2, 2>::from([[0.3, -1.0], [0.8, 0.1]]);
    let b = SMatrix::<f64, 2, 1>::from([[0.2, 1.0]]);
    let (q, r) = (SMatrix::from([[2.0, 0.3], [0.3, 1.0]]), SMatrix::from([[0.5]]));
    let n = SMatrix::from([[0.2, -0.1]]);
    let weights = Weights::with_cross(q, r, n).unwrap();
    let h = 0.4;
    let regulator = lqr::sampled(&a, &b, &weights, h).unwrap();
    for start in [[1.0, 0.0], [0.0, 1.0], [-2.0, 1.5]] {
        let mut state = SVector::from([start[0], start[1], 0.0]);
        for _ in 0..100 {
            let x = |state: &SVector<f64, 3>| SVector::from([state[0], state[1]]);
            let u = -regulator.gain * x(&state);
            let field = |_: f64, state: &SVector<f64, 3>| {
                let x = x(state);
                let rate = a * x + b * u;
                let cost = x.dot(&(q * x)) + 2.0 * x.dot(&(n * u)) + u.dot(&(r * u));
                SVector::from([rate[0], rate[1], cost])
            };
            state = Rk4.integrate(field, 0.0, &state, h, 50).unwrap();
        }
        // Rk4 in steps of 8 ms is exact to 10⁻¹⁰.
        let value = regulator.cost(&start.into());
        approx::assert_relative_eq!(state[2], value, max_relative = 1e-9);
    }
}

/// As h → 0 the gain approaches the continuous one like h, and the value like h²: the hold costs what the input lacks to the optimal one, and
/// the cost is flat there.
#[test]
fn fast_sampling_approaches_the_continuous_regulator() {
    let (a, b) = (SMatrix::from([[0.0, 2.0], [1.0, -0.3]]), SMatrix::from([[0.0, 1.0]]));
    let weights = Weights::diagonal([1.0, 0.2], [0.1]).unwrap();
    let continuous = lqr::continuous(&a, &b, &weights).unwrap();
    let apart = |h: f64| {
        let sampled = lqr::sampled(&a, &b, &weights, h).unwrap();
        assert!(sampled.value[(0, 0)] > continuous.value[(0, 0)], "holding costs");
        let (gain, value) = (sampled.gain - continuous.gain, sampled.value - continuous.value);
        [gain.norm(), value.norm()] as [f64; 2]
    };
    let ([gain, value], [half_gain, half_value]) = (apart(0.01), apart(0.005));
    let orders = [(gain / half_gain).log2(), (value / half_value).log2()];
    assert!((orders[0] - 1.0).abs() < 0.05 && (orders[1] - 2.0).abs() < 0.05, "{orders:?}");
}

#[test]
fn sampled_gains_of_a_chain_approach_those_of_the_continuous_one() {
    let q = [4.0, 1.0, 0.1];
    let continuous = Gains::lqr(q, 0.5).unwrap();
    let apart = |h: f64| {
        let sampled = Gains::sampled_lqr(q, 0.5, h).unwrap();
        (sampled.as_vector() - continuous.as_vector()).norm()
    };
    let order = (apart(0.01) / apart(0.005)).log2();
    assert!((order - 1.0).abs() < 0.05, "{order}");
}
