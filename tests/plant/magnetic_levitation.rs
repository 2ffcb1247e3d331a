//! Magnetic levitation against derivatives by hand, the balance of energy, and its equilibria.

use brunovsky::{
    Error, Scalar,
    differentiation::{RunningError, Smooth},
    plant::{Electromagnet, MagneticLevitation, Plant, SmoothPlant},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    by_hand::{assert_as_by_hand, single},
    support::{Refusals, assert_equal_to_rounding, flow, num, power},
};

const MASS: f64 = 0.1;
const FRICTION: f64 = 0.05;
const GRAVITY: f64 = 9.81;
const MAGNET: Electromagnet<f64> =
    Electromagnet { far: 0.02, near: 0.01, range: 0.05, resistance: 1.0 };

fn magnet<T: Scalar>() -> Electromagnet<T> {
    let Electromagnet { far, near, range, resistance } = MAGNET;
    Electromagnet { far: num(far), near: num(near), range: num(range), resistance: num(resistance) }
}

fn levitation<T: Scalar>() -> MagneticLevitation<T> {
    MagneticLevitation::new(num(MASS), num(FRICTION), num(GRAVITY), magnet()).unwrap()
}

/// With D = a + y and κ = L₀·a: ÿ = g − c/m·ẏ − κ·i²/(2m·D²), y⃛ by the product rule, and i̇ = (−R·i + κ·ẏ·i/D²)/L + v/L.
fn has_the_lie_derivatives_by_hand<T: Scalar>() {
    let [m, c, g] = [MASS, FRICTION, GRAVITY].map(num::<T>);
    let Electromagnet { far, near, range, resistance } = magnet::<T>();
    let corners = [[0.0, -0.5, -8.0], [0.2, 0.5, 8.0]];
    assert_as_by_hand(&levitation(), [3], corners, |[y, v, i]| {
        let kappa = RunningError::from(near) * range;
        let distance = y + range;
        let inductance = kappa / distance + far;
        let (second, third) = (distance.powi(2), distance.powi(3));
        let half = kappa / (m + m);
        let acceleration = -(half * i * i / second) - v * c / m + g;
        let i_dot = (kappa * v * i / second - i * resistance) / inductance;
        let twice = half + half;
        let drift =
            -(twice * i * i_dot / second) + twice * i * i * v / third - acceleration * c / m;
        single([y, v, acceleration], drift, -(twice * i / second / inductance))
    });
}

fn floats_at_every_distance<T: Scalar>() {
    for y in [0.0, 0.01, 0.05, 0.2] {
        let (x, voltage) = levitation().equilibrium(num::<T>(y));
        let rate = levitation().derivative(T::zero(), &x, &[voltage].into());
        // Pull and weight per mass are g; voltages of up to 40 V cancel over 20 mH.
        assert_equal_to_rounding(&rate, &SVector::zeros(), 8.0 * 2000.0);
        // A current of the other direction pulls alike.
        let mirrored = SVector::from([x[0], x[1], -x[2]]);
        let other = levitation().derivative(T::zero(), &mirrored, &[-voltage].into());
        assert_eq!(other, SVector::from([rate[0], rate[1], -rate[2]]));
    }
}

/// Without current the ball falls: y = y₀ + v₀·t + ½·g·t², without friction.
fn falls_without_current<T: Scalar>() {
    let free = MagneticLevitation::new(num(MASS), T::zero(), num(GRAVITY), magnet()).unwrap();
    let t = 0.3;
    let found = flow(&free, [0.01, -0.5, 0.0].map(num::<T>), [T::zero()], num(t), 10);
    let expected = [0.01 - 0.5 * t + 0.5 * GRAVITY * t * t, -0.5 + GRAVITY * t, 0.0];
    // Rk4 is exact for a parabola.
    assert_equal_to_rounding(&found, &SVector::from(expected.map(num::<T>)), 40.0);
}

at_f32_and_f64! {
    its_lie_derivatives_are_those_by_hand => has_the_lie_derivatives_by_hand,
    it_floats_at_every_distance => floats_at_every_distance,
    it_falls_without_current => falls_without_current,
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_energy_changes_by_the_power_of_the_source_and_by_what_turns_to_heat(
        y in 0.0..0.2_f64, v in -1.0..1.0_f64, i in -8.0..8.0_f64, voltage in -20.0..20.0_f64,
    ) {
        let x = SVector::from([y, v, i]);
        let dual = MagneticLevitation::new(num(MASS), num(FRICTION), num(GRAVITY), magnet()).unwrap();
        let rate = levitation().derivative(0.0, &x, &[voltage].into());
        let found = power(|x| dual.energy(x), &x, &rate);
        let expected = voltage * i - MAGNET.resistance * i * i - FRICTION * v * v;
        // Powers of up to 20 V·8 A.
        prop_assert!((found - expected).abs() <= 64.0 * f64::EPSILON * 200.0, "{found} {expected}");
    }

    #[test]
    fn its_relative_degree_is_3_under_current(y in 0.0..0.2_f64, v in -1.0..1.0_f64, i in 0.1..8.0_f64) {
        let found = levitation::<f64>().relative_degree([y, v, i]).unwrap();
        prop_assert_eq!((found.degrees, found.zero_dynamics()), ([3], 0));
    }

    #[test]
    fn without_current_it_has_no_relative_degree(y in 0.0..0.2_f64, v in -1.0..1.0_f64) {
        let refused = levitation::<f64>().relative_degree([y, v, 0.0]).unwrap_err();
        let expected = Error::UndefinedRelativeDegree { output: 0, order: 2, value: 0.0, rounding: 0.0 };
        prop_assert_eq!(refused, expected);
    }
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    fn new(m: f64, c: f64, g: f64) -> Result<MagneticLevitation<f64>, Error> {
        MagneticLevitation::new(m, c, g, MAGNET)
    }
    fn on(magnet: Electromagnet<f64>) -> Result<MagneticLevitation<f64>, Error> {
        MagneticLevitation::new(MASS, FRICTION, GRAVITY, magnet)
    }
    Refusals(&[
        ("mass", |v| new(v, FRICTION, GRAVITY)),
        ("gravity", |v| new(MASS, FRICTION, v)),
        ("far inductance", |far| on(Electromagnet { far, ..MAGNET })),
        ("near inductance", |near| on(Electromagnet { near, ..MAGNET })),
        ("range", |range| on(Electromagnet { range, ..MAGNET })),
        ("resistance", |resistance| on(Electromagnet { resistance, ..MAGNET })),
    ])
    .all_are_positive();
    Refusals(&[("friction", |v| new(MASS, v, GRAVITY))]).none_is_negative();
}
