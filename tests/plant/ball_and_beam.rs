//! Ball and beam against derivatives by hand, closed-form motions, and the relative degree that it does not have.

use brunovsky::{
    Error, Scalar,
    differentiation::{RunningError, Smooth},
    plant::{BallAndBeam, BoxSamples, Plant, SmoothPlant},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    by_hand::{assert_as_by_hand, single},
    support::{Refusals, assert_equal_to_rounding, flow, num},
};

const GRAVITY: f64 = 9.81;
/// B of a solid ball.
const SHARE: f64 = 5.0 / 7.0;

fn plant<T: Scalar>() -> BallAndBeam<T> {
    BallAndBeam::new(num(0.4), num(GRAVITY)).unwrap()
}

/// r̈ = B·(r·ω² − g·sin θ), r⃛ = B·(ṙ·ω² − g·cos θ·ω) + 2·B·r·ω·u.
fn has_the_lie_derivatives_of_hauser<T: Scalar>() {
    let gravity = num::<T>(GRAVITY);
    let corner = [0.5, 1.0, 1.0, 3.0];
    assert_as_by_hand(&plant(), [3], [corner.map(|x| -x), corner], |[r, v, theta, omega]| {
        let share = RunningError::from(T::one()) / (RunningError::from(num::<T>(0.4)) + T::one());
        let (sin, cos) = theta.sin_cos();
        let acceleration = share * (r * omega * omega - sin * gravity);
        let drift = share * (v * omega * omega - cos * omega * gravity);
        single([r, v, acceleration], drift, share * r * omega * num::<T>(2.0))
    });
}

/// On a beam at rest the ball rolls down as on an incline: r = r₀ + v₀·t − ½·B·g·sin θ·t².
fn rolls_down_an_incline<T: Scalar>() {
    let (theta, t) = (0.3_f64, 1.5);
    let found = flow(&plant(), [0.2, 0.7, theta, 0.0].map(num::<T>), [T::zero()], num(t), 10);
    let slope = SHARE * GRAVITY * theta.sin();
    let end = [0.2 + 0.7 * t - 0.5 * slope * t * t, 0.7 - slope * t, theta, 0.0];
    // Rk4 is exact for a parabola.
    assert_equal_to_rounding(&found, &SVector::from(end.map(num::<T>)), 40.0);
}

/// On a beam that turns steadily, r̈ = B·ω²·r − B·g·sin ωt: r = C·sin ωt + D·cosh(√B·ω·t), C = B·g/(ω²·(1 + B)).
fn is_thrown_out_by_a_turning_beam<T: Scalar>() {
    let (omega, t, size) = (1.3_f64, 1.2_f64, 0.1);
    let (c, rate) = (SHARE * GRAVITY / (omega * omega * (1.0 + SHARE)), SHARE.sqrt() * omega);
    let at = |t: f64| {
        [
            c * (omega * t).sin() + size * (rate * t).cosh(),
            c * omega * (omega * t).cos() + size * rate * (rate * t).sinh(),
            omega * t,
            omega,
        ]
    };
    let found = flow(&plant(), at(0.0).map(num::<T>), [T::zero()], num(t), 1000);
    // Rk4 leaves (ωh)⁴/120 ≈ 1e-14; a thousand steps round.
    assert_equal_to_rounding(&found, &SVector::from(at(t).map(num::<T>)), 1000.0);
}

at_f32_and_f64! {
    its_lie_derivatives_are_those_of_hauser_sastry_and_kokotovic => has_the_lie_derivatives_of_hauser,
    it_rolls_down_an_incline => rolls_down_an_incline,
    a_turning_beam_throws_it_out => is_thrown_out_by_a_turning_beam,
}

/// The decisive Lie derivative of r vanishes at x, and not close by.
fn undefined(error: Error) -> bool {
    matches!(
        error,
        Error::UndefinedRelativeDegree { output: 0, order: 2, value, rounding } if value.abs() <= rounding
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn off_the_pivot_of_a_turning_beam_the_relative_degree_is_3(
        r in 0.01..0.5_f64, v in -1.0..1.0_f64, theta in -1.0..1.0_f64, omega in 0.01..3.0_f64,
        sides in (prop::bool::ANY, prop::bool::ANY),
    ) {
        let x = [if sides.0 { r } else { -r }, v, theta, if sides.1 { omega } else { -omega }];
        let found = plant::<f64>().relative_degree(x).unwrap();
        prop_assert_eq!((found.degrees, found.zero_dynamics()), ([3], 1));
        let b = 2.0 * SHARE * r * omega;
        prop_assert!((found.smallest_gain - b).abs() <= 8.0 * f64::EPSILON * b);
    }

    #[test]
    fn at_the_pivot_and_on_a_beam_at_rest_it_has_no_relative_degree(
        r in -0.5..0.5_f64, v in -1.0..1.0_f64, theta in -1.0..1.0_f64, omega in -3.0..3.0_f64,
    ) {
        for x in [[0.0, v, theta, omega], [r, v, theta, 0.0], [0.0, v, theta, 0.0]] {
            prop_assert!(undefined(plant::<f64>().relative_degree(x).unwrap_err()));
            prop_assert!(undefined(plant::<f64>().linearized::<3>(x).unwrap_err()));
        }
    }
}

#[test]
fn no_equilibrium_can_be_linearized_with_any_order() {
    let rest = [0.0; 4];
    assert!(undefined(plant::<f64>().linearized::<2>(rest).unwrap_err()));
    assert!(undefined(plant::<f64>().linearized::<3>(rest).unwrap_err()));
    assert!(undefined(plant::<f64>().linearized::<4>(rest).unwrap_err()));
    let rest = plant::<f64>().derivative(0.0, &rest.into(), &[0.0].into());
    assert_eq!(rest, SVector::<f64, 4>::zeros());
}

/// Over a box around the equilibrium the gain comes as close to zero as |r·θ̇| does.
#[test]
fn a_box_around_the_equilibrium_has_a_gain_that_changes_its_sign() {
    let plant = plant::<f64>();
    let states = || BoxSamples::new([-0.5, -1.0, -1.0, -3.0], [0.5, 1.0, 1.0, 3.0]).unwrap();
    let found = plant.relative_degree_over(states().take(1000)).unwrap();
    let smallest = states().take(1000).map(|x| (x[0] * x[3]).abs()).fold(f64::INFINITY, f64::min);
    assert_eq!((found.degrees, found.states), ([3], 1000));
    approx::assert_relative_eq!(found.smallest_gain, 2.0 * SHARE * smallest, max_relative = 1e-14);
    let gains = states().take(1000).map(|x| x[0] * x[3]);
    assert!(gains.clone().any(|b| b > 0.0) && gains.clone().any(|b| b < 0.0));
    // The first state is the centre of the box, the equilibrium itself.
    assert_eq!(found.singular, 1);
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    Refusals(&[
        ("inertia ratio", |v| BallAndBeam::new(v, GRAVITY)),
        ("gravity", |v| BallAndBeam::new(0.4, v)),
    ])
    .none_is_negative();
}
