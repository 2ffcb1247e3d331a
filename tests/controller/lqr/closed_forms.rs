use brunovsky::{
    Error, Scalar,
    controller::{
        Gains,
        lqr::{self, Weights},
    },
};
use nalgebra::SMatrix;
use proptest::prelude::*;

use super::chain;
use crate::{
    at_f32_and_f64,
    support::{num, real},
};

fn assert_close<T: Scalar>(found: T, expected: f64, roundings: f64) {
    let found = real(found);
    let tolerance = roundings * real(T::default_epsilon()) * expected.abs();
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected}");
}

/// K = (√(q₁/r), √(q₂/r + 2·√(q₁/r))), and P from P·B = r·Kᵀ: p₁₂ = r·k₁, p₂₂ = r·k₂, p₁₁ = r·k₁·k₂.
fn is_a_mass<T: Scalar>(q1: f64, q2: f64, r: f64) {
    let (a, b) = chain::<T, 2>();
    let weights = Weights::diagonal([num::<T>(q1), num(q2)], [num::<T>(r)]).unwrap();
    let regulator = lqr::continuous(&a, &b, &weights).unwrap();
    let k1 = (q1 / r).sqrt();
    let k2 = (q2 / r + 2.0 * k1).sqrt();
    let expected = [(0, 0, r * k1 * k2), (0, 1, r * k1), (1, 0, r * k1), (1, 1, r * k2)];
    for (i, j, p) in expected {
        assert_close(regulator.value[(i, j)], p, 1000.0);
    }
    assert_close(regulator.gain[0], k1, 1000.0);
    assert_close(regulator.gain[1], k2, 1000.0);
    let gains = Gains::<T, 2>::lqr([num::<T>(q1), num(q2)], num(r)).unwrap();
    assert_eq!(*gains.as_vector(), regulator.gain.transpose());
}

fn holds_for_a_mass<T: Scalar>() {
    for q1 in [1e-6, 0.3, 1.0, 50.0, 1e4] {
        for (q2, r) in [(0.0, 1.0), (0.7, 1e-2), (30.0, 10.0), (2.0, 1e6)] {
            is_a_mass::<T>(q1, q2, r);
        }
    }
}

/// Poles at 10 and 3·10⁻⁵, then at 10³ and 10⁻⁸: f32 does not tell them from one that rests, and says so.
#[test]
fn poles_far_apart_are_found_or_refused() {
    is_a_mass::<f64>(1e-6, 1e3, 10.0);
    is_a_mass::<f64>(1e-10, 1e6, 1.0);
    let refused = Gains::<f32, 2>::lqr([1e-10, 1e6], 1.0);
    assert!(matches!(refused, Err(Error::NotStabilizable { .. })), "{refused:?}");
}

/// a·2p − p²·b²/r + q = 0: b·k = a + √(a² + q·b²/r), the eigenvalue is the other root.
fn holds_in_one_dimension<T: Scalar>() {
    for a in [-3.0_f64, -1e-3, 0.0, 0.5, 20.0] {
        for (b, q, r) in [(1.0, 1.0, 1.0), (-0.2, 5.0, 0.1), (10.0, 1e-3, 2.0)] {
            let one = |x: f64| SMatrix::<T, 1, 1>::from([[num(x)]]);
            let weights = Weights::new(one(q), one(r)).unwrap();
            let regulator = lqr::continuous(&one(a), &one(b), &weights).unwrap();
            let root = (a * a + q * b * b / r).sqrt();
            // Where a < 0 the sum cancels; its product with the other root does not.
            let k = if a > 0.0 { (a + root) / b } else { q * b / r / (root - a) };
            // q·b²/r that is lost beside a² is lost: as many ulps as a² is larger.
            let lost = 1.0 + a * a / (q * b * b / r);
            assert_close(regulator.gain[0], k, 100.0 * lost);
        }
    }
}

/// b²p² + (r − a²r − q·b²)·p − q·r = 0 in steps.
fn holds_in_one_dimension_in_steps<T: Scalar>() {
    for a in [-1.5_f64, 0.0, 0.5, 1.0, 4.0] {
        for (b, q, r) in [(1.0, 1.0, 1.0), (-0.5, 2.0, 0.5), (2.0, 0.1, 3.0)] {
            let one = |x: f64| SMatrix::<T, 1, 1>::from([[num(x)]]);
            let weights = Weights::new(one(q), one(r)).unwrap();
            let regulator = lqr::discrete(&one(a), &one(b), &weights).unwrap();
            let half = 0.5 * (a * a * r + q * b * b - r);
            let p = (half + (half * half + b * b * q * r).sqrt()) / (b * b);
            assert_close(regulator.value[0], p, 1000.0);
            assert_close(regulator.gain[0], a * b * p / (r + b * b * p), 1000.0);
        }
    }
}

/// With a weight of x₁ alone the poles of a chain are those of Butterworth, ω = (q₁/r)^(1/2N).
fn are_butterworth<T: Scalar>() {
    for omega in [0.03_f64, 1.0, 7.0, 40.0] {
        let third = Gains::<T, 3>::lqr([num(omega.powi(6)), T::zero(), T::zero()], T::one());
        let expected = [omega.powi(3), 2.0 * omega.powi(2), 2.0 * omega];
        for (k, expected) in third.unwrap().as_vector().iter().zip(expected) {
            assert_close(*k, expected, 1000.0);
        }
        let q = [num(omega.powi(8)), T::zero(), T::zero(), T::zero()];
        let fourth = Gains::<T, 4>::lqr(q, T::one()).unwrap();
        let (middle, side) = (2.0 + 2.0_f64.sqrt(), (4.0 + 8.0_f64.sqrt()).sqrt());
        let expected = [omega.powi(4), side * omega.powi(3), middle * omega.powi(2), side * omega];
        for (k, expected) in fourth.as_vector().iter().zip(expected) {
            assert_close(*k, expected, 1000.0);
        }
    }
}

at_f32_and_f64! {
    a_mass_has_its_closed_form => holds_for_a_mass,
    one_dimension_has_its_closed_form => holds_in_one_dimension,
    one_dimension_in_steps_has_its_closed_form => holds_in_one_dimension_in_steps,
    chains_with_a_weight_of_the_output_have_butterworth_poles => are_butterworth,
}

/// Cheap control of a mass: the least cost from x₁ = 1 goes to zero as √2·r^¼, the gain to infinity as r^(−½).
#[test]
fn cheap_control_costs_next_to_nothing() {
    let (a, b) = chain::<f64, 2>();
    for power in 1..7 {
        let r = 100.0_f64.powi(-power);
        let weights = Weights::diagonal([1.0, 0.0], [r]).unwrap();
        let regulator = lqr::continuous(&a, &b, &weights).unwrap();
        assert_close(regulator.cost(&[1.0, 0.0].into()), 2.0_f64.sqrt() * r.powf(0.25), 100.0);
        assert_close(regulator.gain[0], r.powf(-0.5), 100.0);
    }
}

/// Where input is all that costs, an unstable pole is mirrored: k = 2·a/b, as far as q = 10⁻⁹ shows.
#[test]
fn expensive_control_mirrors_the_unstable_pole() {
    let one = |x: f64| SMatrix::<f64, 1, 1>::from([[x]]);
    let weights = Weights::new(one(1e-9), one(1.0)).unwrap();
    let regulator = lqr::continuous(&one(3.0), &one(0.5), &weights).unwrap();
    approx::assert_abs_diff_eq!(regulator.gain[0], 12.0, epsilon = 1e-9);
}

/// Kalman's equality for a chain: p(s)·p(−s) = s^N·(−s)^N + Σ qᵢ/r·(s·(−s))^(i−1), coefficient by coefficient.
fn factorizes<const N: usize>(q: [f64; N], r: f64) {
    let gains = Gains::lqr(q, r).unwrap();
    let mut p: Vec<f64> = gains.as_vector().iter().copied().collect();
    p.push(1.0);
    for (m, q) in q.into_iter().enumerate() {
        // The coefficient of s^(2m), and the size of what it is a sum of.
        let (mut found, mut size) = (0.0, 0.0);
        for i in 0..=2 * m {
            let j = 2 * m - i;
            if i <= N && j <= N {
                let term = p[i] * p[j];
                found += if j % 2 == 0 { term } else { -term };
                size += term.abs();
            }
        }
        let expected = if m % 2 == 0 { q / r } else { -q / r };
        assert!((found - expected).abs() <= 1e-10 * size, "{m}: {found} {expected} {p:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn the_characteristic_polynomial_is_the_spectral_factor(
        logs in prop::array::uniform6(-3.0..3.0_f64), r in -3.0..3.0_f64, absent in 1..64_u8,
    ) {
        let mut q = logs.map(|log| 10.0_f64.powf(log));
        for (i, q) in q.iter_mut().enumerate().skip(1) {
            if absent >> i & 1 == 1 {
                *q = 0.0;
            }
        }
        let r = 10.0_f64.powf(r);
        factorizes([q[0]], r);
        factorizes([q[0], q[1]], r);
        factorizes([q[0], q[1], q[2]], r);
        factorizes([q[0], q[1], q[2], q[3]], r);
        factorizes(q, r);
    }
}
