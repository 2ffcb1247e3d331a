//! Position and thrust: fourth derivatives of the position from the rotation alone, and a flight in closed loop.

use core::array;

use brunovsky::{
    Error, Scalar,
    controller::{Decoupling, FeedbackLinearization, Gains, Reference},
    differentiation::{RunningError, Smooth},
    plant::{IntegratorChain, Linearized, Plant, Quadrotor, SmoothPlant},
    simulation::Simulation,
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{INERTIA, attitude, cross, gyration};
use crate::{
    at_f32_and_f64,
    by_hand::{ByHand, assert_as_by_hand},
    support::{Refusals, assert_equal_to_rounding, flow, num},
};

const MASS: f64 = 0.9;
const GRAVITY: f64 = 9.81;

fn quadrotor<T: Scalar>() -> Quadrotor<T> {
    Quadrotor::new(num(MASS), attitude(), num(GRAVITY)).unwrap()
}

/// R·v with R = R_z(ψ)·R_y(θ)·R_x(φ), one turn after the other.
fn turned<S: Smooth<T>, T: Scalar>([phi, theta, psi]: [S; 3], [x, y, z]: [S; 3]) -> [S; 3] {
    let ((s, c), (st, ct), (sp, cp)) = (phi.sin_cos(), theta.sin_cos(), psi.sin_cos());
    let (y, z) = (y * c - z * s, y * s + z * c);
    let (x, z) = (x * ct + z * st, z * ct - x * st);
    [x * cp - y * sp, x * sp + y * cp, z]
}

/// With the thrust F·e_z in the body: m·p̈ = R·F·e_z − m·g·e_z, and each further derivative of R·v is R·(v̇ + ω × v). The yaw angle is that of the
/// attitude.
fn has_the_lie_derivatives_by_hand<T: Scalar>() {
    let corner = |size: f64, thrust: [f64; 2]| {
        [3.0, 3.0, 3.0, 2.0, 2.0, 2.0, 1.2, 1.2, 3.0, 2.0, 2.0, 2.0]
            .map(|x| x * size)
            .into_iter()
            .chain(thrust)
    };
    let corner = |size, thrust| {
        let mut corner = corner(size, thrust);
        array::from_fn(|_| corner.next().unwrap())
    };
    let corners = [corner(-1.0, [2.0, -20.0]), corner(1.0, [20.0, 20.0])];
    let (mass, gravity) = (num::<T>(MASS), num::<T>(GRAVITY));
    assert_as_by_hand(
        &quadrotor(),
        Quadrotor::<T>::DEGREES,
        corners,
        |x: [RunningError<T>; 14]| {
            let (zero, one) = (RunningError::from(T::zero()), RunningError::from(T::one()));
            let [px, py, pz, vx, vy, vz, phi, theta, psi, p, q, r, thrust, thrust_dot] = x;
            let omega = [p, q, r];
            let world =
                |body: [RunningError<T>; 3]| turned([phi, theta, psi], body).map(|f| f / mass);
            let sum = |a: [_; 3], b: [_; 3]| array::from_fn(|i| a[i] + b[i]);

            // The forces in the body, F·e_z and its derivatives in a frame at rest.
            let force = [zero, zero, thrust];
            let first = sum([zero, zero, thrust_dot], cross(omega, force));
            // Without inputs; F̈ = 0.
            let second = |accelerated: [RunningError<T>; 3]| {
                let rate = sum(cross(omega, [zero, zero, thrust_dot]), cross(accelerated, force));
                sum(rate, cross(omega, first))
            };
            let acceleration = world(force);
            let position = [px, py, pz];
            let velocity = [vx, vy, vz];
            let acceleration = [acceleration[0], acceleration[1], acceleration[2] - gravity];
            let (jerk, snap) = (world(first), world(second(gyration(omega))));

            // ψ̇ and ψ̈ as for the attitude.
            let ((s, c), (st, ct)) = (phi.sin_cos(), theta.sin_cos());
            let yaw = (q * s + r * c) / ct;
            let (roll, pitch) = (p + yaw * st, q * c - r * s);
            let [_, q_dot, r_dot] = gyration(omega);
            let yaw_drift = (q_dot * s + r_dot * c + roll * pitch) / ct + yaw * pitch * st / ct;

            // What each input does: F̈ along the thrust, the torques by ω̇ × F·e_z.
            let unit = |i: usize, size: RunningError<T>| {
                array::from_fn(|k| if k == i { size } else { zero })
            };
            let columns: [[RunningError<T>; 3]; 4] = array::from_fn(|j| match j {
                0 => world([zero, zero, one]),
                _ => world(cross(unit(j - 1, one / num::<T>(INERTIA[j - 1])), force)),
            });
            let yaw_gains =
                [zero, zero, s / ct / num::<T>(INERTIA[1]), c / ct / num::<T>(INERTIA[2])];
            ByHand {
                chains: array::from_fn(|i| match position.get(i) {
                    Some(p) => [*p, velocity[i], acceleration[i], jerk[i]],
                    None => [psi, yaw, zero, zero],
                }),
                drift: [snap[0], snap[1], snap[2], yaw_drift],
                matrix: array::from_fn(|i| {
                    array::from_fn(|j| if i < 3 { columns[j][i] } else { yaw_gains[j] })
                }),
            }
        },
    );
}

fn hovers_at_any_place_and_yaw<T: Scalar>() {
    for psi in [0.0, 0.7, -2.0] {
        let x = quadrotor::<T>().hover([0.3, -2.0, 5.0].map(num), num(psi));
        let rate = quadrotor().derivative(T::zero(), &x, &SVector::zeros());
        // F/m and g.
        assert_equal_to_rounding(&rate, &SVector::zeros(), 2.0 * GRAVITY);
    }
}

/// Without thrust it falls, and turns as it does.
fn falls_without_thrust<T: Scalar>() {
    let mut x = SVector::<f64, 14>::zeros();
    (x[2], x[3], x[5], x[11]) = (10.0, 1.5, 2.0, 0.8);
    let t = 1.2;
    let found = flow(&quadrotor(), x.map(num::<T>), [T::zero(); 4], num(t), 10);
    (x[0], x[2], x[5], x[8]) =
        (1.5 * t, 10.0 + 2.0 * t - 0.5 * GRAVITY * t * t, 2.0 - GRAVITY * t, 0.8 * t);
    // Rk4 is exact for a parabola.
    assert_equal_to_rounding(&found, &x.map(num), 40.0);
}

at_f32_and_f64! {
    its_lie_derivatives_are_those_by_hand => has_the_lie_derivatives_by_hand,
    it_hovers_at_any_place_and_yaw => hovers_at_any_place_and_yaw,
    without_thrust_it_falls => falls_without_thrust,
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 32, ..ProptestConfig::default() })]

    #[test]
    fn its_relative_degrees_leave_no_zero_dynamics(
        angles in prop::array::uniform3(-1.2..1.2_f64), omega in prop::array::uniform3(-2.0..2.0_f64),
        thrust in 1.0..20.0_f64, thrust_dot in -20.0..20.0_f64,
    ) {
        let mut x = quadrotor::<f64>().hover([0.3, -0.2, 1.0], 0.0);
        for i in 0..3 {
            (x[6 + i], x[9 + i]) = (angles[i], omega[i]);
        }
        (x[12], x[13]) = (thrust, thrust_dot);
        let found = quadrotor::<f64>().relative_degree(x).unwrap();
        prop_assert_eq!((found.degrees, found.zero_dynamics()), (Quadrotor::<f64>::DEGREES, 0));
    }
}

#[test]
fn free_fall_has_no_relative_degree() {
    let mut x = quadrotor::<f64>().hover([0.0; 3], 0.0);
    x[12] = 0.0;
    let refused = quadrotor::<f64>().relative_degree(x).unwrap_err();
    // Sideways no input acts on p⁗ there; beside it the torques do.
    let undefined = matches!(refused, Error::UndefinedRelativeDegree { output: 0, order: 3, .. });
    assert!(undefined, "{refused}");
}

/// Each output obeys the error dynamics of its own gains: the position those of (p + λ)⁴, the yaw p² + k₄·p + k₃ from the last two entries of its gains.
#[test]
fn every_output_of_a_flight_follows_its_own_error_dynamics() {
    let (lambda, dt) = (4.0_f64, 0.001);
    let plant = quadrotor::<f64>();
    let (start, goal) = ([0.0, 0.0, 1.0], [1.0, -0.5, 1.8]);
    let from = plant.hover(start, 0.2);
    let plant =
        Linearized::<_, 14, 4, 4>::with_degrees(plant, Quadrotor::<f64>::DEGREES, from).unwrap();
    let chain = |gains| FeedbackLinearization::new(IntegratorChain::<f64, 4>::new(), gains);
    let space = chain(Gains::from_lambda(lambda).unwrap());
    // The first two entries of a padded chain are zeros: what multiplies them does nothing. p² + 8p + 16 has a double pole at −4.
    let yaw = chain(Gains::new([1.0, 8.0, 16.0, 8.0]).unwrap());
    let controller = Decoupling::new(&plant, [space, space, space, yaw]);
    let reference = |_| {
        let [x, y, z] = goal.map(Reference::setpoint);
        [x, y, z, Reference::<f64, 2>::setpoint(0.9).padded()]
    };
    let run =
        Simulation::new(&plant, controller, reference, from, dt).unwrap().substeps(1).unwrap();
    let samples = run.until(3.0).unwrap().collect::<Result<Vec<_>, _>>().unwrap();
    for sample in samples.iter().step_by(250) {
        let (t, x) = (sample.t, &sample.x);
        let l = lambda * t;
        // From rest, (p + λ)⁴·e = 0 has e = e₀·(1 + l + l²/2 + l³/6)·e^(−l).
        let left = (1.0 + l + l * l / 2.0 + l * l * l / 6.0) * (-l).exp();
        for i in 0..3 {
            let expected = goal[i] - (goal[i] - start[i]) * left;
            // A period of delay moves the response by its rate of about 1 m/s.
            assert!((x[i] - expected).abs() < 3.0 * dt, "p[{i}] = {}, not {expected} at {t}", x[i]);
        }
        let expected = 0.9 - 0.7 * (1.0 + 4.0 * t) * (-4.0 * t).exp();
        assert!((x[8] - expected).abs() < 3.0 * dt, "ψ = {}, not {expected} at {t}", x[8]);
    }
    // It has to tilt for that, so the angles were not small all the way.
    assert!(samples.iter().any(|sample| sample.x[6].hypot(sample.x[7]) > 0.1));
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    Refusals(&[("mass", |v| Quadrotor::new(v, attitude(), GRAVITY))]).all_are_positive();
    Refusals(&[("gravity", |v| Quadrotor::new(MASS, attitude(), v))]).none_is_negative();
    let found = quadrotor::<f64>().linearized::<4>(quadrotor().hover([0.0; 3], 0.0)).unwrap_err();
    assert_eq!(found, Error::RelativeDegree { output: 3, expected: 4, found: 2 });
}
