//! Quintics: boundary conditions, the classical polynomial, optimality, time scaling.

use brunovsky::{
    Error, Scalar,
    trajectory::{Boundary, Quintic, Trajectory},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{NOT_FINITE, assert_equal_to_rounding, assert_jets_equal, cases, integral, num},
};

fn state() -> impl Strategy<Value = [[f64; 2]; 3]> {
    prop::array::uniform3(prop::array::uniform2(-3.0..3.0_f64))
}

fn quintic<T: Scalar>(from: [[f64; 2]; 3], to: [[f64; 2]; 3], duration: f64) -> Quintic<T, 2> {
    let boundary = |[p, v, a]: [[f64; 2]; 3]| Boundary::new(p.map(num), v.map(num), a.map(num));
    Quintic::new(boundary(from), boundary(to), num(duration)).unwrap()
}

/// p₀ + (p₁ − p₀)·(10τ³ − 15τ⁴ + 6τ⁵) and its rate 30τ²·(1 − τ)²/T.
fn follows_the_classical_polynomial<T: Scalar>() {
    let [start, end] = [[1.0, -2.0], [3.0, 1.0]].map(|p: [f64; 2]| p.map(num::<T>));
    let rest = Quintic::rest_to_rest(start, end, num(4.0)).unwrap();
    let (start, way) = (SVector::from(start), SVector::from(end) - SVector::from(start));
    for i in 0..=64 {
        let tau = f64::from(i) / 64.0;
        let done = tau.powi(3) * (10.0 - 15.0 * tau + 6.0 * tau * tau);
        let rate = 30.0 * (tau * (1.0 - tau)).powi(2) / 4.0;
        let [r, v] = rest.jet(num(4.0 * tau));
        assert_equal_to_rounding(r, start + way * num::<T>(done), 64.0);
        assert_equal_to_rounding(v, way * num::<T>(rate), 256.0);
    }
    for t in [-1.0, 5.0] {
        let expected = if t < 0.0 { start } else { end.into() };
        let zero = SVector::zeros();
        assert_eq!(rest.jet(num(t)), [expected, zero, zero, zero]);
    }
}

fn refuses_parameters_by_name<T: Scalar>() {
    let rest = Boundary::rest([T::zero(); 2]);
    for value in [0.0, -1.0] {
        let refused = Error::NotPositive { name: "duration", value };
        assert_eq!(Quintic::new(rest, rest, num(value)), Err(refused));
    }
    for bad in NOT_FINITE {
        let error = Quintic::new(rest, rest, num(bad)).unwrap_err();
        assert!(matches!(error, Error::NonFinite { name: "duration", .. }));
        let away = Boundary::rest([T::zero(), num(bad)]);
        for ends in [(rest, away), (away, rest)] {
            let error = Quintic::new(ends.0, ends.1, T::one()).unwrap_err();
            assert!(matches!(error, Error::NonFiniteEntry { name: "position", index: 1, .. }));
        }
    }
    // Finite ends whose difference is not.
    let huge = num::<T>(if T::default_epsilon() > num(1e-10) { 3e38 } else { 1e308 });
    let error = Quintic::rest_to_rest([-huge], [huge], T::one()).unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "coefficients", .. }));
}

at_f32_and_f64! {
    from_rest_to_rest_it_is_the_classical_polynomial => follows_the_classical_polynomial,
    parameters_out_of_range_are_refused_by_name => refuses_parameters_by_name,
}

proptest! {
    #![proptest_config(cases(300))]

    /// One-sided limits at the ends: inside it is a polynomial, outside p + v·t + a·t²/2.
    #[test]
    fn it_joins_its_boundary_states_twice_continuously(from in state(), to in state(), duration in 0.5..4.0_f64) {
        let r = quintic::<f64>(from, to, duration);
        // c₅ ≤ 12·3·(1 + T + T²) ≈ 800 cancels to order 1.
        assert_jets_equal(r.jet(0.0), from.map(SVector::from), 1e4);
        assert_jets_equal(r.jet(duration), to.map(SVector::from), 1e4);
        for (t, [p, v, a]) in [(-0.75, from), (0.75, to)] {
            let [p, v, a] = [p, v, a].map(SVector::from);
            let at = if t < 0.0 { t } else { duration + t };
            let coasting = [p + v * t + a * (t * t / 2.0), v + a * t, a, SVector::zeros()];
            assert_jets_equal(r.jet(at), coasting, 64.0);
        }
    }

    /// Six conditions determine the polynomial, so a polynomial of degree 5 comes back with all its derivatives.
    #[test]
    fn any_polynomial_of_degree_five_comes_back(c in prop::array::uniform6(-1.0..1.0_f64), duration in 0.5..2.0_f64, tau in 0.0..1.0_f64) {
        let jet = |t: f64| -> [f64; 6] {
            core::array::from_fn(|k| (k..6).map(|j| {
                let falling: f64 = (0..k).map(|i| (j - i) as f64).product();
                c[j] * falling * t.powi((j - k) as i32)
            }).sum())
        };
        let ends = [0.0, duration].map(|t| {
            let jet = jet(t);
            [[jet[0], 0.0], [jet[1], 0.0], [jet[2], 0.0]]
        });
        let found = quintic::<f64>(ends[0], ends[1], duration).jet::<7>(duration * tau);
        for (found, expected) in found.into_iter().zip(jet(duration * tau).into_iter().chain([0.0])) {
            // The division by T⁵ ≥ 1/32 magnifies roundings of terms of up to 1000.
            prop_assert!((found[0] - expected).abs() <= 1e5 * f64::EPSILON, "{found} {expected}");
            prop_assert_eq!(found[1], 0.0);
        }
    }

    #[test]
    fn backwards_it_is_the_quintic_between_the_reversed_states(from in state(), to in state(), duration in 0.5..4.0_f64, tau in 0.0..1.0_f64) {
        let reversed = |[p, v, a]: [[f64; 2]; 3]| [p, v.map(|v| -v), a];
        let t = duration * tau;
        let back = quintic::<f64>(reversed(to), reversed(from), duration).jet::<4>(duration - t);
        let mut signs = [1.0, -1.0, 1.0, -1.0].into_iter();
        assert_jets_equal(back, quintic::<f64>(from, to, duration).jet::<4>(t).map(|r| r * signs.next().unwrap()), 1e5);
    }

    /// r_c(c·t) = r(t) with derivatives divided by cᵏ, if boundary velocities and accelerations are.
    #[test]
    fn slowed_down_it_takes_the_same_path(from in state(), to in state(), c in 0.5..2.0_f64, tau in -0.5..1.5_f64) {
        let slow = |[p, v, a]: [[f64; 2]; 3]| [p, v.map(|v| v / c), a.map(|a| a / (c * c))];
        let slowed = quintic::<f64>(slow(from), slow(to), 2.0 * c).jet::<4>(2.0 * c * tau);
        let expected = quintic::<f64>(from, to, 2.0).jet::<4>(2.0 * tau);
        for (k, (slowed, expected)) in slowed.into_iter().zip(expected).enumerate() {
            assert_equal_to_rounding(slowed * c.powi(k as i32), expected, 1e4);
        }
    }

    /// ∫r⃛·b⃛ = 0 for b = τ³·(1 − τ)³·(1 + q·τ), the lowest bumps that keep the boundary states: so any bump makes ∫|r⃛|² grow.
    #[test]
    fn no_admissible_bump_changes_the_jerk_to_first_order(from in state(), to in state(), q in -2.0..2.0_f64) {
        let r = quintic::<f64>(from, to, 1.0);
        let coefficients = [1.0, q - 3.0, 3.0 - 3.0 * q, 3.0 * q - 1.0, -q];
        let bump = |t: f64| -> f64 {
            (3_i32..).zip(coefficients).map(|(j, c)| c * f64::from(j * (j - 1) * (j - 2)) * t.powi(j - 3)).sum()
        };
        let first_order = integral(|t| r.jet::<4>(t)[3][0] * bump(t), 0.0, 1.0, 200);
        // |r⃛| and |b⃛| are of the order of 1000 and 100; order 6 at h = 1/200 leaves less than their roundings.
        prop_assert!(first_order.abs() < 1e-9, "{first_order}");
    }
}
