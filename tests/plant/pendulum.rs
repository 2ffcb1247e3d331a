//! The pendulum against mechanics: energy, equilibria, and the period from the arithmetic-geometric mean.

use brunovsky::{
    Error, Scalar,
    plant::{Pendulum, Plant},
};
use nalgebra::SVector;
use num_dual::Dual64;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, flow, num, order},
};

const GRAVITY: f64 = 9.81;
const LENGTH: f64 = 0.7;

fn undamped<T: Scalar>() -> Pendulum<T> {
    Pendulum::new(num(1.3), num(LENGTH), T::zero(), num(GRAVITY)).unwrap()
}

/// √(g/l), the angular frequency of small oscillations.
fn small_angle_frequency() -> f64 {
    (GRAVITY / LENGTH).sqrt()
}

/// T = 2π·√(l/g)/AGM(1, cos(θ₀/2)), Gauss's closed form of the elliptic integral.
fn period(amplitude: f64) -> f64 {
    let (mut a, mut g) = (1.0, (amplitude / 2.0).cos());
    // The mean converges quadratically: six rounds exhaust the digits of f64 for cos(θ₀/2) > 0.01.
    for _ in 0..6 {
        (a, g) = ((a + g) / 2.0, f64::sqrt(a * g));
    }
    core::f64::consts::TAU / (small_angle_frequency() * a)
}

#[test]
fn without_damping_and_input_the_energy_drifts_only_by_the_error_of_the_integrator() {
    let plant = undamped::<f64>();
    let start = SVector::from([2.0, 1.0]);
    let drift = |steps| {
        let end = flow(&plant, start, [0.0], 7.0, steps);
        (plant.energy(&end) - plant.energy(&start)).abs()
    };
    // Rk4 has order 4, and order 5 where the errors of the energy cancel over an oscillation.
    let measured = order(drift(700), drift(1400));
    assert!((3.8..5.2).contains(&measured), "order {measured}");
    assert!(drift(22_400) < 1e-11);
}

proptest! {
    /// dE/dt = u·ω − d·ω²: the derivative of the energy along the field, exact by dual numbers.
    #[test]
    fn the_energy_changes_by_the_power_of_the_torque_and_of_the_damping(
        mass in 0.1..5.0_f64, length in 0.1..3.0_f64, damping in 0.0..2.0_f64, gravity in 0.0..20.0_f64,
        x in prop::array::uniform2(-4.0..4.0_f64), torque in -5.0..5.0_f64,
    ) {
        let plant = Pendulum::new(mass, length, damping, gravity).unwrap();
        let rate = plant.derivative(0.0, &x.into(), &[torque].into());
        let [mass, length, damping, gravity] = [mass, length, damping, gravity].map(Dual64::from);
        let along = SVector::from([Dual64::new(x[0], rate[0]), Dual64::new(x[1], rate[1])]);
        let power = Pendulum::new(mass, length, damping, gravity).unwrap().energy(&along).eps;
        let expected = torque * x[1] - damping.re * x[1] * x[1];
        // The gravity terms m·g·l·ω·sin θ ≤ 5·20·3·4 cancel, within a few roundings of their size.
        prop_assert!((power - expected).abs() <= 16.0 * f64::EPSILON * 1200.0, "{power} {expected}");
    }

    #[test]
    fn any_angle_is_an_equilibrium_under_the_torque_that_holds_it(theta in -3.0..3.0_f64) {
        let plant = undamped();
        let holding = 1.3 * GRAVITY * LENGTH * theta.sin();
        let rate = plant.derivative(0.0, &[theta, 0.0].into(), &[holding].into());
        // Two terms of at most g/l = 14 cancel.
        prop_assert!(rate[0] == 0.0 && rate[1].abs() <= 14.0 * 8.0 * f64::EPSILON);
    }
}

fn rests_hanging_and_upright<T: Scalar>() {
    let plant = undamped::<T>();
    let (origin, input) = (SVector::zeros(), SVector::zeros());
    assert_eq!(plant.derivative(T::zero(), &origin, &input), origin);
    // π is rounded to T, so sin π is as small as that rounding.
    let upright = SVector::from([T::pi(), T::zero()]);
    let rate = plant.derivative(T::zero(), &upright, &input);
    assert_equal_to_rounding(&rate, &SVector::zeros(), 4.0 * GRAVITY / LENGTH);
    assert_eq!(plant.energy(&origin), T::zero());
    let lifted = num::<T>(2.0 * 1.3 * GRAVITY * LENGTH);
    approx::assert_relative_eq!(
        plant.energy(&upright),
        lifted,
        max_relative = T::default_epsilon() * num(8.0)
    );
}

/// From (θ₀, 0): at a quarter period θ = 0 and ω = −2·√(g/l)·sin(θ₀/2) by conservation of energy, at half a period −θ₀, at a whole
/// one θ₀.
fn swings_with_the_period_of_gauss<T: Scalar>() {
    for amplitude in [0.1, 1.0, 2.0, 3.0] {
        let t = period(amplitude);
        let after = |part: f64| {
            flow(
                &undamped::<T>(),
                [num::<T>(amplitude), T::zero()],
                [T::zero()],
                num(t * part),
                8000,
            )
        };
        let fastest = -2.0 * small_angle_frequency() * (amplitude / 2.0).sin();
        // Rk4 leaves (h·√(g/l))⁴/120 ≈ 1e-14 of ω; 8000 steps round as often, mostly to either side, and an error near the upright
        // position grows e^(√(g/l)·T/4) ≈ 100 times on the way down.
        let roundings = 2e4;
        let states = [(0.25, [0.0, fastest]), (0.5, [-amplitude, 0.0]), (1.0, [amplitude, 0.0])];
        for (part, expected) in states {
            let expected = SVector::from(expected.map(num::<T>));
            assert_equal_to_rounding(&after(part), &expected, roundings);
        }
    }
}

at_f32_and_f64! {
    it_rests_hanging_and_upright => rests_hanging_and_upright,
    it_swings_with_the_period_of_the_arithmetic_geometric_mean => swings_with_the_period_of_gauss,
}

#[test]
fn small_swings_approach_the_harmonic_ones_with_the_cube_of_the_amplitude() {
    let t = 2.0;
    let deviation = |amplitude: f64| {
        let found = flow(&undamped(), [amplitude, 0.0], [0.0], t, 4000);
        (found[0] - amplitude * (small_angle_frequency() * t).cos()).abs()
    };
    let measured = order(deviation(0.1), deviation(0.05));
    assert!((measured - 3.0).abs() < 0.02, "order {measured}");
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    type Bad = fn(f64) -> Result<Pendulum<f64>, Error>;
    let positive: [(&str, Bad); 2] = [
        ("mass", |v| Pendulum::new(v, 1.0, 0.1, 9.81)),
        ("length", |v| Pendulum::new(1.0, v, 0.1, 9.81)),
    ];
    let not_negative: [(&str, Bad); 2] = [
        ("damping", |v| Pendulum::new(1.0, 1.0, v, 9.81)),
        ("gravity", |v| Pendulum::new(1.0, 1.0, 0.1, v)),
    ];
    for (name, new) in positive {
        for value in [0.0, -0.0, -1.0] {
            assert_eq!(new(value), Err(Error::NotPositive { name, value }));
        }
    }
    for (name, new) in not_negative {
        assert!(new(0.0).is_ok());
        let value = -1e-300;
        assert_eq!(new(value), Err(Error::Negative { name, value }));
    }
    for (name, new) in positive.into_iter().chain(not_negative) {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let error = new(value).unwrap_err();
            assert!(matches!(error, Error::NonFinite { name: found, .. } if found == name));
        }
    }
}
