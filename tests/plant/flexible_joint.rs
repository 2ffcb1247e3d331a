//! The flexible joint against Spong's derivatives, the balance of energy, and the modes of a spring between two masses.

use brunovsky::{
    Error, Scalar,
    differentiation::{RunningError, Smooth},
    plant::{FlexibleJoint, Plant, SmoothPlant},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    by_hand::{assert_as_by_hand, single},
    support::{Refusals, assert_equal_to_rounding, flow, num, power},
};

const LINK: f64 = 1.3;
const MOTOR: f64 = 0.4;
const STIFFNESS: f64 = 20.0;
const WEIGHT: f64 = 11.0;

fn joint<T: Scalar>() -> FlexibleJoint<T> {
    FlexibleJoint::new(num(LINK), num(MOTOR), num(STIFFNESS), num(WEIGHT)).unwrap()
}

/// q̈ = −w/I·sin q − k/I·(q − θ), q⃛ = −w/I·cos q·q̇ − k/I·(q̇ − θ̇), and once more.
fn has_the_lie_derivatives_of_spong<T: Scalar>() {
    let [i, j, k, w] = [LINK, MOTOR, STIFFNESS, WEIGHT].map(num::<T>);
    let corner = [3.0, 4.0, 3.0, 4.0];
    assert_as_by_hand(&joint(), [4], [corner.map(|x| -x), corner], |[q, v, theta, theta_dot]| {
        let number = RunningError::from;
        let (pull, spring, drive) = (number(w) / i, number(k) / i, number(k) / j);
        let (sin, cos) = q.sin_cos();
        let stretch = q - theta;
        let acceleration = -(pull * sin) - spring * stretch;
        let jerk = -(pull * cos * v) - spring * (v - theta_dot);
        let drift = pull * sin * (v * v + pull * cos + spring)
            + spring * stretch * (spring + drive + pull * cos);
        single([q, v, acceleration, jerk], drift, spring / j)
    });
}

/// At every equilibrium the state stays as it is under the torque that belongs to it.
fn rests_at_every_angle<T: Scalar>() {
    for q in [-2.0, 0.0, 0.4, 1.5, 3.0] {
        let (x, torque) = joint().equilibrium(num::<T>(q));
        let rate = joint().derivative(T::zero(), &x, &[torque].into());
        // w·sin q and k·(q − θ), of at most 11 N·m and with θ of at most 4 rad, over the moments of inertia.
        assert_equal_to_rounding(&rate, &SVector::zeros(), 8.0 * STIFFNESS * 4.0 / MOTOR);
    }
}

/// Without weight the centre of both inertias moves on by itself, and the stretch swings with ω² = k·(1/I + 1/J).
fn swings_about_its_common_centre_without_weight<T: Scalar>() {
    let joint = FlexibleJoint::new(num::<T>(LINK), num(MOTOR), num(STIFFNESS), T::zero()).unwrap();
    let ([q, v, theta, rate], t) = ([0.3, -0.5, -0.2, 1.0], 0.7);
    let found = flow(&joint, [q, v, theta, rate].map(num::<T>), [T::zero()], num(t), 4000);
    let total = LINK + MOTOR;
    let (speed, centre) = ((LINK * v + MOTOR * rate) / total, (LINK * q + MOTOR * theta) / total);
    let omega = (STIFFNESS * (1.0 / LINK + 1.0 / MOTOR)).sqrt();
    let (sin, cos) = (omega * t).sin_cos();
    let stretch = (q - theta) * cos + (v - rate) / omega * sin;
    let stretch_dot = (v - rate) * cos - (q - theta) * omega * sin;
    let at = |share: f64| [centre + speed * t + share * stretch, speed + share * stretch_dot];
    let ([q, v], [theta, rate]) = (at(MOTOR / total), at(-LINK / total));
    // Rk4 leaves (ωh)⁴/120·ωt ≈ 2e-13 of the phase; 4000 steps round.
    assert_equal_to_rounding(&found, &SVector::from([q, v, theta, rate].map(num::<T>)), 4000.0);
}

at_f32_and_f64! {
    its_lie_derivatives_are_those_of_spong => has_the_lie_derivatives_of_spong,
    it_rests_at_every_angle => rests_at_every_angle,
    without_weight_it_swings_about_its_common_centre => swings_about_its_common_centre_without_weight,
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_energy_changes_by_the_power_of_the_motor(
        p in prop::array::uniform4(0.1..20.0_f64), x in prop::array::uniform4(-4.0..4.0_f64), u in -9.0..9.0_f64,
    ) {
        let x = SVector::from(x);
        let joint = FlexibleJoint::new(p[0], p[1], p[2], p[3]).unwrap();
        let [i, j, k, w] = p.map(num);
        let dual = FlexibleJoint::new(i, j, k, w).unwrap();
        let found = power(|x| dual.energy(x), &x, &joint.derivative(0.0, &x, &[u].into()));
        // The powers of spring, weight and torque, 20·8·4 and 20·4 and 9·4 W, cancel but for the last.
        prop_assert!((found - u * x[3]).abs() <= 32.0 * f64::EPSILON * 1500.0, "{found} {}", u * x[3]);
    }

    #[test]
    fn mirroring_the_state_and_the_torque_mirrors_the_motion(
        x in prop::array::uniform4(-4.0..4.0_f64), u in -9.0..9.0_f64,
    ) {
        let (x, u) = (SVector::from(x), SVector::from([u]));
        // Changing signs is exact in floating point, and the law is odd term by term.
        prop_assert_eq!(joint().derivative(0.0, &-x, &-u), -joint().derivative(0.0, &x, &u));
    }

    #[test]
    fn its_relative_degree_is_4_at_every_state(x in prop::array::uniform4(-4.0..4.0_f64)) {
        let found = joint::<f64>().relative_degree(x).unwrap();
        prop_assert_eq!((found.degrees, found.zero_dynamics()), ([4], 0));
        // b = k/(I·J) everywhere.
        let b = STIFFNESS / (LINK * MOTOR);
        prop_assert!((found.smallest_gain - b).abs() <= 8.0 * f64::EPSILON * b);
    }
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    Refusals(&[
        ("link", |v| FlexibleJoint::new(v, MOTOR, STIFFNESS, WEIGHT)),
        ("motor", |v| FlexibleJoint::new(LINK, v, STIFFNESS, WEIGHT)),
        ("stiffness", |v| FlexibleJoint::new(LINK, MOTOR, v, WEIGHT)),
    ])
    .all_are_positive();
    Refusals(&[("weight", |v| FlexibleJoint::new(LINK, MOTOR, STIFFNESS, v))]).none_is_negative();
}

/// The angle of the motor is two integrators from the torque; the swinging of the link is then zero dynamics.
#[test]
fn another_output_has_another_relative_degree() {
    /// The same joint, with the angle of the motor as output.
    #[derive(Debug)]
    struct MotorSide(FlexibleJoint<f64>);

    impl SmoothPlant<4, 1> for MotorSide {
        type Scalar = f64;

        fn drift_field<S: Smooth>(&self, x: [S; 4]) -> [S; 4] {
            self.0.drift_field(x)
        }

        fn input_fields<S: Smooth>(&self, x: [S; 4]) -> [[S; 4]; 1] {
            self.0.input_fields(x)
        }

        fn outputs<S: Smooth>(&self, [_, _, theta, _]: [S; 4]) -> [S; 1] {
            [theta]
        }
    }

    let found = MotorSide(joint()).relative_degree([0.3, 0.1, 0.2, -0.4]).unwrap();
    assert_eq!((found.degrees, found.zero_dynamics()), ([2], 2));
    let refused = MotorSide(joint()).linearized::<4>([0.0; 4]).unwrap_err();
    assert_eq!(refused, Error::RelativeDegree { output: 0, expected: 4, found: 2 });
}
