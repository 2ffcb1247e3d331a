//! The attitude: second derivatives of the angles by hand, momentum and energy of a free body, and the lock of the gimbal.

use core::f64::consts::FRAC_PI_2;

use brunovsky::{
    Error, Scalar,
    differentiation::{RunningError, Smooth},
    plant::{Decouplable, Plant, QuadrotorAttitude, SmoothPlant},
};
use nalgebra::{Rotation3, SVector};
use num_dual::Dual64;
use proptest::prelude::*;

use super::{INERTIA, attitude, gyration};
use crate::{
    at_f32_and_f64,
    by_hand::{ByHand, assert_as_by_hand},
    support::{Refusals, assert_equal_to_rounding, flow, num, order, power},
};

/// With the rates (φ̇, θ̇, ψ̇) known: ψ̈ = (q̇·sin φ + ṙ·cos φ + φ̇·θ̇)/cos θ + ψ̇·θ̇·tan θ, φ̈ = ṗ + ψ̈·sin θ + ψ̇·θ̇·cos θ and
/// θ̈ = q̇·cos φ − ṙ·sin φ − φ̇·ψ̇·cos θ, because q·cos φ − r·sin φ = θ̇ and q·sin φ + r·cos φ = ψ̇·cos θ.
fn has_the_lie_derivatives_by_hand<T: Scalar>() {
    let corner = [3.0, 1.2, 3.0, 2.0, 2.0, 2.0];
    let corners = [corner.map(|x| -x), corner];
    assert_as_by_hand(&attitude(), [2; 3], corners, |[phi, theta, psi, p, q, r]| {
        let ((s, c), (st, ct)) = (phi.sin_cos(), theta.sin_cos());
        let yaw = (q * s + r * c) / ct;
        let (roll, pitch) = (p + yaw * st, q * c - r * s);
        let second = |[p, q, r]: [RunningError<T>; 3], moving: RunningError<T>| {
            let yaw_rate =
                (q * s + r * c + roll * pitch * moving) / ct + yaw * pitch * st / ct * moving;
            let roll_rate = p + yaw_rate * st + yaw * pitch * ct * moving;
            [roll_rate, q * c - r * s - roll * yaw * ct * moving, yaw_rate]
        };
        let (zero, one) = (RunningError::from(T::zero()), RunningError::from(T::one()));
        let columns: [_; 3] = core::array::from_fn(|j| {
            let turned = |i| if i == j { one / num::<T>(INERTIA[i]) } else { zero };
            second(core::array::from_fn(turned), zero)
        });
        ByHand {
            chains: [[phi, roll], [theta, pitch], [psi, yaw]],
            drift: second(gyration([p, q, r]), one),
            matrix: core::array::from_fn(|i| columns.map(|column| column[i])),
        }
    });
}

/// About a principal axis it turns steadily, and that angle alone moves.
fn turns_steadily_about_a_principal_axis<T: Scalar>() {
    for axis in 0..3 {
        let mut x = SVector::<f64, 6>::zeros();
        x[3 + axis] = 0.7;
        let found = flow(&attitude(), x.map(num::<T>), [T::zero(); 3], num(2.0), 100);
        x[axis] = 1.4;
        // Rk4 is exact for constant rates; 100 steps round.
        assert_equal_to_rounding(&found, &x.map(num), 100.0);
    }
}

at_f32_and_f64! {
    its_lie_derivatives_are_those_by_hand => has_the_lie_derivatives_by_hand,
    it_turns_steadily_about_a_principal_axis => turns_steadily_about_a_principal_axis,
}

/// R_z(ψ)·R_y(θ)·R_x(φ).
fn rotation<T: Scalar>(x: &SVector<T, 6>) -> Rotation3<T> {
    Rotation3::from_axis_angle(&nalgebra::Vector3::z_axis(), x[2])
        * Rotation3::from_axis_angle(&nalgebra::Vector3::y_axis(), x[1])
        * Rotation3::from_axis_angle(&nalgebra::Vector3::x_axis(), x[0])
}

/// The angular momentum R·J·ω in the world.
fn momentum(x: &SVector<f64, 6>) -> SVector<f64, 3> {
    rotation(x) * SVector::from_fn(|i, _| INERTIA[i] * x[3 + i])
}

#[test]
fn a_free_body_keeps_its_angular_momentum_in_the_world_and_its_energy() {
    let start = SVector::from([0.3, -0.2, 1.0, 1.0, -0.7, 0.5]);
    let drift = |steps| {
        let end = flow(&attitude(), start, [0.0; 3], 2.0, steps);
        let energy = attitude::<f64>().energy(&end) / attitude::<f64>().energy(&start) - 1.0;
        [(momentum(&end) - momentum(&start)).norm() / momentum(&start).norm(), energy.abs()]
    };
    let (coarse, fine) = (drift(100), drift(200));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        // Rk4 has order 4, and order 5 where errors cancel.
        let measured = order(coarse, fine);
        assert!((3.7..5.3).contains(&measured), "order {measured}");
    }
    assert!(drift(6400).into_iter().all(|drift| drift < 1e-12), "{:?}", drift(6400));
}

fn state() -> impl Strategy<Value = SVector<f64, 6>> {
    let angles = (-3.0..3.0_f64, -1.4..1.4_f64, -3.0..3.0_f64);
    (angles, prop::array::uniform3(-4.0..4.0_f64))
        .prop_map(|((phi, theta, psi), [p, q, r])| SVector::from([phi, theta, psi, p, q, r]))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Ṙ = R·[ω]×: the rotation turns at ω about the body's axes, whatever its angles do.
    #[test]
    fn the_rates_of_the_angles_are_those_of_the_rotation(x in state(), tau in prop::array::uniform3(-0.1..0.1_f64)) {
        let rate = attitude().derivative(0.0, &x, &tau.into());
        let turning = rotation(&x.zip_map(&rate, Dual64::new)).into_inner().map(|entry| entry.eps);
        let omega = nalgebra::Vector3::new(x[3], x[4], x[5]).cross_matrix();
        // The angles turn with up to 4·√2/cos 1.4 = 33 rad/s, most of which cancels.
        let off = (rotation(&x).matrix() * omega - turning).amax();
        prop_assert!(off <= 40.0 * f64::EPSILON * 33.0, "{off}");
    }

    #[test]
    fn the_energy_changes_by_the_power_of_the_torques(x in state(), tau in prop::array::uniform3(-0.1..0.1_f64)) {
        let dual = attitude();
        let found = power(|x| dual.energy(x), &x, &attitude().derivative(0.0, &x, &tau.into()));
        let expected: f64 = (0..3).map(|i| tau[i] * x[3 + i]).sum();
        // Three powers of gyration, p·q·r·J ≤ 64·0.017, cancel.
        prop_assert!((found - expected).abs() <= 32.0 * f64::EPSILON * 1.5, "{found} {expected}");
    }

    #[test]
    fn the_determinant_of_the_decoupling_matrix_is_that_of_the_angles_and_the_inertia(x in state()) {
        let plant = attitude::<f64>().linearized::<2>(SVector::zeros()).unwrap();
        let found = plant.decoupling_matrix(&x).determinant();
        let expected = 1.0 / (x[1].cos() * INERTIA.iter().product::<f64>());
        // Up to tan² 1.4 = 34 cancels beside 1.
        prop_assert!((found / expected - 1.0).abs() <= 40.0 * f64::EPSILON * 40.0, "{found} {expected}");
    }

    #[test]
    fn each_angle_has_relative_degree_2(x in state()) {
        let found = attitude::<f64>().relative_degree(x).unwrap();
        prop_assert_eq!((found.degrees, found.zero_dynamics()), ([2; 3], 0));
    }
}

/// At θ = π/2, rounded, 1/cos θ and all that acts on ψ may be rounding alone; close by, 1/cos θ = 1e9 is too much for the matrix to be inverted.
#[test]
fn the_lock_of_the_gimbal_is_refused() {
    let at = |theta| attitude::<f64>().relative_degree([0.3, theta, 0.0, 0.0, 0.0, 0.0]);
    let locked = at(FRAC_PI_2).unwrap_err();
    assert!(
        matches!(locked, Error::UndefinedRelativeDegree { output: 2, order: 1, .. }),
        "{locked}"
    );
    let close = at(FRAC_PI_2 - 1e-9).unwrap_err();
    assert!(matches!(close, Error::IllConditioned { name: "B(x)", .. }), "{close}");
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    let [x, y, z] = INERTIA;
    assert!(QuadrotorAttitude::new([x, y, z]).is_ok());
    Refusals(&[
        ("inertia about x", |v| QuadrotorAttitude::new([v, INERTIA[1], INERTIA[2]])),
        ("inertia about y", |v| QuadrotorAttitude::new([INERTIA[0], v, INERTIA[2]])),
        ("inertia about z", |v| QuadrotorAttitude::new([INERTIA[0], INERTIA[1], v])),
    ])
    .all_are_positive();
}
