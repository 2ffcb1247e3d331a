//! The link on a direct-current motor against derivatives by hand, the balance of energy, its equilibria, and the pendulum that it is with the
//! circuit open.

use brunovsky::{
    Error, Scalar,
    differentiation::{RunningError, Smooth},
    plant::{DcMotor, MotorDrivenLink, Pendulum, Plant, SmoothPlant},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    by_hand::{assert_as_by_hand, single},
    support::{Refusals, assert_equal_to_rounding, flow, num, power},
};

const INERTIA: f64 = 0.5;
const DAMPING: f64 = 0.3;
const WEIGHT: f64 = 6.0;
const MOTOR: DcMotor<f64> = DcMotor { torque: 0.9, inductance: 0.025, resistance: 5.0 };

fn motor<T: Scalar>() -> DcMotor<T> {
    let DcMotor { torque, inductance, resistance } = MOTOR;
    DcMotor { torque: num(torque), inductance: num(inductance), resistance: num(resistance) }
}

fn link<T: Scalar>() -> MotorDrivenLink<T> {
    MotorDrivenLink::new(num(INERTIA), num(DAMPING), num(WEIGHT), motor()).unwrap()
}

/// I·q⃛ = K·i̇ − d·q̈ − w·cos q·q̇ with L·i̇ = v − R·i − K·q̇.
fn has_the_lie_derivatives_by_hand<T: Scalar>() {
    let [inertia, damping, weight] = [INERTIA, DAMPING, WEIGHT].map(num::<T>);
    let DcMotor { torque, inductance, resistance } = motor::<T>();
    let corner = [4.0, 6.0, 10.0];
    assert_as_by_hand(&link(), [3], [corner.map(|x| -x), corner], |[q, rate, current]| {
        let (sin, cos) = q.sin_cos();
        let acceleration = (current * torque - rate * damping - sin * weight) / inertia;
        let current_dot = -(current * resistance + rate * torque) / inductance;
        let drift = current_dot * torque - acceleration * damping - cos * rate * weight;
        let gain = RunningError::from(torque) / inertia / inductance;
        single([q, rate, acceleration], drift / inertia, gain)
    });
}

fn rests_at_every_angle<T: Scalar>() {
    for q in [-2.0, 0.0, 0.4, 1.5, 3.0] {
        let (x, voltage) = link().equilibrium(num::<T>(q));
        let rate = link().derivative(T::zero(), &x, &[voltage].into());
        // Voltages of up to R·w/K = 34 V over L.
        assert_equal_to_rounding(&rate, &SVector::zeros(), 4.0 * 34.0 / MOTOR.inductance);
    }
}

/// Where the current stands still without a torque, i = 0, it moves as a pendulum with the same w = m·g·l and I = m·l².
fn moves_as_a_pendulum_with_the_circuit_open<T: Scalar>() {
    let (length, gravity) = (INERTIA * 9.81 / WEIGHT, 9.81);
    let mass = INERTIA / (length * length);
    let [mass, length, damping, gravity] = [mass, length, DAMPING, gravity].map(num::<T>);
    let pendulum = Pendulum::new(mass, length, damping, gravity).unwrap();
    for x in [[0.4, 1.0], [-2.0, 3.0], [3.0, -0.5]] {
        let [q, rate] = x.map(num::<T>);
        let expected = pendulum.derivative(T::zero(), &[q, rate].into(), &[T::zero()].into());
        let found = link().derivative(T::zero(), &[q, rate, T::zero()].into(), &[T::zero()].into());
        assert_equal_to_rounding(&found.fixed_rows::<2>(0).into_owned(), &expected, 16.0);
    }
}

/// A link without weight and friction is linear: after the current has settled it turns at v/K.
fn turns_at_the_idle_speed_without_a_load<T: Scalar>() {
    let idle = MotorDrivenLink::new(num(INERTIA), T::zero(), T::zero(), motor()).unwrap();
    let voltage = 12.0;
    let end = flow(&idle, [T::zero(); 3], [num::<T>(voltage)], num(120.0), 60_000);
    // The slow mode decays with λ ≈ K²/(I·R) = 0.324/s: e⁻³⁸ over the run, and what a step rounds is forgotten after 1/(λ·h) = 1500 steps.
    let expected = SVector::from([num::<T>(voltage / MOTOR.torque), T::zero()]);
    assert_equal_to_rounding(&end.fixed_rows::<2>(1).into_owned(), &expected, 1500.0);
}

at_f32_and_f64! {
    its_lie_derivatives_are_those_by_hand => has_the_lie_derivatives_by_hand,
    it_rests_at_every_angle => rests_at_every_angle,
    with_the_circuit_open_it_moves_as_a_pendulum => moves_as_a_pendulum_with_the_circuit_open,
    without_a_load_it_turns_at_the_idle_speed => turns_at_the_idle_speed_without_a_load,
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_energy_changes_by_the_power_of_the_source_and_by_what_turns_to_heat(
        q in -4.0..4.0_f64, rate in -6.0..6.0_f64, i in -10.0..10.0_f64, voltage in -40.0..40.0_f64,
    ) {
        let x = SVector::from([q, rate, i]);
        let dual = MotorDrivenLink::new(num(INERTIA), num(DAMPING), num(WEIGHT), motor()).unwrap();
        let found = power(|x| dual.energy(x), &x, &link().derivative(0.0, &x, &[voltage].into()));
        let expected = voltage * i - MOTOR.resistance * i * i - DAMPING * rate * rate;
        // Powers of up to 40 V·10 A and R·i² = 500 W.
        prop_assert!((found - expected).abs() <= 32.0 * f64::EPSILON * 1000.0, "{found} {expected}");
    }

    #[test]
    fn its_relative_degree_is_3_at_every_state(q in -4.0..4.0_f64, rate in -6.0..6.0_f64, i in -10.0..10.0_f64) {
        let found = link::<f64>().relative_degree([q, rate, i]).unwrap();
        prop_assert_eq!((found.degrees, found.zero_dynamics()), ([3], 0));
    }
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    fn on(motor: DcMotor<f64>) -> Result<MotorDrivenLink<f64>, Error> {
        MotorDrivenLink::new(INERTIA, DAMPING, WEIGHT, motor)
    }
    Refusals(&[
        ("inertia", |v| MotorDrivenLink::new(v, DAMPING, WEIGHT, MOTOR)),
        ("torque constant", |torque| on(DcMotor { torque, ..MOTOR })),
        ("inductance", |inductance| on(DcMotor { inductance, ..MOTOR })),
        ("resistance", |resistance| on(DcMotor { resistance, ..MOTOR })),
    ])
    .all_are_positive();
    Refusals(&[
        ("friction", |v| MotorDrivenLink::new(INERTIA, v, WEIGHT, MOTOR)),
        ("weight", |v| MotorDrivenLink::new(INERTIA, DAMPING, v, MOTOR)),
    ])
    .none_is_negative();
}
