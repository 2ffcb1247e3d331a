//! The unicycle against its geometry: arcs of radius v/ω, the chains of its position, mirror, rotation and reverse.

use brunovsky::{
    Error, Scalar,
    plant::{Decouplable, Plant, SmoothPlant, Unicycle},
};
use nalgebra::SVector;
use num_dual::Dual64;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, flow, num},
};

/// States (p_x, p_y, θ, v) and inputs (ξ, ω) of at most a few units.
fn driving() -> impl Strategy<Value = ([f64; 4], [f64; 2])> {
    let state = (-3.0..3.0_f64, -3.0..3.0_f64, -7.0..7.0_f64, -4.0..4.0_f64);
    (state.prop_map(|(x, y, theta, v)| [x, y, theta, v]), prop::array::uniform2(-5.0..5.0_f64))
}

/// A few roundings of v·ω ≤ 4·5 and ξ ≤ 5.
const ROUNDING: f64 = 8.0 * f64::EPSILON * 25.0;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// d/dt of the chains along the field, exact by dual numbers, is the next entry and at the end a(x) + B(x)·u.
    #[test]
    fn the_chains_move_as_drift_and_decoupling_matrix_say((x, u) in driving()) {
        let (x, u) = (SVector::from(x), SVector::from(u));
        let plant = Unicycle::new();
        let rate = plant.derivative(0.0, &x, &u);
        let along = x.zip_map(&rate, Dual64::new);
        let nu = plant.chain_drift(&x) + plant.decoupling_matrix(&x) * u;
        let chains = plant.chains(&x);
        for (i, chain) in Unicycle::new().chains(&along).iter().enumerate() {
            prop_assert!(chain[0].re == x[i] && chain[0].eps == chains[i][1]);
            prop_assert!((chain[1].eps - nu[i]).abs() <= ROUNDING, "{} {}", chain[1].eps, nu[i]);
        }
    }

    #[test]
    fn the_chain_rates_are_those_of_the_measured_derivative((x, u) in driving(), slip in prop::array::uniform2(-3.0..3.0_f64)) {
        let x = SVector::from(x);
        // A robot whose θ̇ and v̇ are not those of the model, as a sensor sees it.
        let rate = SVector::from([x[3] * x[2].cos(), x[3] * x[2].sin(), u[1] + slip[1], u[0] + slip[0]]);
        let found = Unicycle::new().chain_rates(&x, &rate);
        let along = x.zip_map(&rate, Dual64::new);
        for (i, chain) in Unicycle::new().chains(&along).iter().enumerate() {
            prop_assert!((found[i] - chain[1].eps).abs() <= 2.0 * ROUNDING);
        }
    }

    /// What differentiation finds in ṗ = v·(cos θ, sin θ), θ̇ = ω, v̇ = ξ is the law that was written by hand.
    #[test]
    fn its_equations_have_the_chains_and_the_decoupling_matrix_by_hand((x, u) in driving()) {
        prop_assume!(x[3].abs() > 1e-3);
        let (x, plant) = (SVector::from(x), Unicycle::new());
        let chain = plant.linearized::<2>(x).unwrap();
        let found = chain.linearization(&x).unwrap();
        prop_assert_eq!(found.chains, plant.chains(&x));
        prop_assert_eq!(found.drift, plant.chain_drift(&x));
        // Sine, cosine and a product, each rounded.
        prop_assert!((found.matrix - plant.decoupling_matrix(&x)).amax() <= 1e-15 * 4.0);
        let rate = plant.derivative(0.0, &x, &u.into());
        prop_assert!((chain.chain_rates(&x, &rate) - plant.chain_rates(&x, &rate)).amax() <= ROUNDING);
    }

    /// Each coordinate still has an input that acts on it, along θ, but both have the same.
    #[test]
    fn where_it_stands_its_decoupling_matrix_is_singular((x, _) in driving()) {
        let refused = Unicycle::new().relative_degree([x[0], x[1], x[2], 0.0]).unwrap_err();
        prop_assert!(matches!(refused, Error::IllConditioned { name: "B(x)", .. }), "{refused}");
    }

    #[test]
    fn the_determinant_of_the_decoupling_matrix_is_the_speed((x, _) in driving()) {
        let determinant = Unicycle::new().decoupling_matrix(&x.into()).determinant();
        // v·cos² θ + v·sin² θ adds two numbers of one sign.
        prop_assert!((determinant - x[3]).abs() <= 4.0 * f64::EPSILON * x[3].abs());
    }

    #[test]
    fn a_mirrored_robot_steered_to_the_other_side_moves_along_the_mirrored_path((x, u) in driving()) {
        let mirrored = |x: [f64; 4]| SVector::from([x[0], -x[1], -x[2], x[3]]);
        let rate = Unicycle::new().derivative(0.0, &x.into(), &u.into());
        let other = Unicycle::new().derivative(0.0, &mirrored(x), &[u[0], -u[1]].into());
        // The sine is odd and the cosine even to the last bit.
        prop_assert_eq!(other, mirrored(rate.into()));
    }

    #[test]
    fn a_turned_robot_moves_along_the_turned_path((x, u) in driving(), turn in -7.0..7.0_f64) {
        let rate = Unicycle::new().derivative(0.0, &x.into(), &u.into());
        let turned = SVector::from([x[0], x[1], x[2] + turn, x[3]]);
        let other = Unicycle::new().derivative(0.0, &turned, &u.into());
        let (sin, cos) = turn.sin_cos();
        let expected = [cos * rate[0] - sin * rate[1], sin * rate[0] + cos * rate[1], u[1], u[0]];
        // θ + turn < 16 is rounded, and the sine follows.
        assert_equal_to_rounding(&other, &expected.into(), 32.0);
    }

    #[test]
    fn a_robot_facing_backwards_in_reverse_moves_as_one_driving_forward((x, u) in driving()) {
        let rate = Unicycle::new().derivative(0.0, &x.into(), &u.into());
        let reversed = SVector::from([x[0], x[1], x[2] + core::f64::consts::PI, -x[3]]);
        let other = Unicycle::new().derivative(0.0, &reversed, &[-u[0], u[1]].into());
        assert_equal_to_rounding(&other, &[rate[0], rate[1], u[1], -u[0]].into(), 32.0);
    }
}

/// θ = θ₀ + ω·t and p = c + (v/ω)·(sin θ, −cos θ): the centre lies to the left for v·ω > 0.
fn drives_circles_of_radius_speed_over_yaw_rate<T: Scalar>() {
    let (start, duration) = ([0.3, -0.2, 0.4], 1.5_f64);
    for v in [2.0, -2.0] {
        for omega in [1.6, -0.8] {
            let angle = start[2] + omega * duration;
            let arm = |theta: f64| [theta.sin() * v / omega, -theta.cos() * v / omega];
            let (from, to) = (arm(start[2]), arm(angle));
            let end = [start[0] + to[0] - from[0], start[1] + to[1] - from[1], angle, v];
            let x0 = [start[0], start[1], start[2], v].map(num::<T>);
            let found = flow(&Unicycle::new(), x0, [T::zero(), num(omega)], num(duration), 1000);
            // Rk4 leaves (ωh)⁴/2880 ≈ 1e-14; a thousand steps round as often.
            assert_equal_to_rounding(&found, &SVector::from(end.map(num::<T>)), 1000.0);
        }
    }
}

/// With ω = 0 it is the chain v̇ = ξ along the heading.
fn accelerates_straight_ahead<T: Scalar>() {
    let (theta, v, xi, t) = (2.5_f64, -1.0, 0.5, 3.0);
    let distance = v * t + 0.5 * xi * t * t;
    let end = [distance * theta.cos(), distance * theta.sin(), theta, v + xi * t];
    let x0 = [0.0, 0.0, theta, v].map(num::<T>);
    let found = flow(&Unicycle::new(), x0, [num(xi), T::zero()], num(t), 10);
    // Rk4 is exact for a polynomial of degree 2.
    assert_equal_to_rounding(&found, &SVector::from(end.map(num::<T>)), 40.0);
}

at_f32_and_f64! {
    it_drives_circles_of_radius_v_over_omega => drives_circles_of_radius_speed_over_yaw_rate,
    without_yaw_rate_it_accelerates_straight_ahead => accelerates_straight_ahead,
}
