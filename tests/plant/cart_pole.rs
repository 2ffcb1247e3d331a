//! The pendulum on a cart against its equations of motion, the balance of energy, and the zero dynamics of both of its outputs.

use brunovsky::{
    Error, Scalar,
    controller::{Decoupling, FeedbackLinearization, Gains, Reference},
    differentiation::{RunningError, Smooth},
    integrators::{Integrator, Rk4},
    plant::{
        CartPole,
        CartPoleOutput::{self, Angle, Position},
        Decouplable, IntegratorChain, Pendulum, Plant, SmoothPlant,
    },
    simulation::Simulation,
};
use core::f64::consts::{FRAC_PI_2, PI};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    by_hand::{assert_as_by_hand, single},
    support::{Refusals, assert_equal_to_rounding, flow, num, power},
};

const CART: f64 = 1.2;
const POLE: f64 = 0.3;
const LENGTH: f64 = 0.6;
const FRICTION: [f64; 2] = [0.4, 0.05];
const GRAVITY: f64 = 9.81;

fn plant<T: Scalar>(output: CartPoleOutput) -> CartPole<T> {
    let [cart, pole, length, gravity] = [CART, POLE, LENGTH, GRAVITY].map(num);
    CartPole::new(cart, pole, length, FRICTION.map(num), gravity, output).unwrap()
}

/// The two equations of motion solved by Cramer's rule, mass matrix [[M + m, −m·l·cos θ], [−m·l·cos θ, m·l²]].
fn has_the_lie_derivatives_by_hand<T: Scalar>() {
    let [cart, pole, length, gravity] = [CART, POLE, LENGTH, GRAVITY].map(num::<T>);
    let [of_cart, of_pivot] = FRICTION.map(num::<T>);
    let corner = [2.0, 3.0, 2.0, 4.0];
    for output in [Position, Angle] {
        let corners = [corner.map(|x| -x), corner];
        assert_as_by_hand(&plant(output), [2], corners, |[p, theta, v, omega]| {
            let (sin, cos) = theta.sin_cos();
            let lever = RunningError::from(pole) * length;
            let total = RunningError::from(cart) + pole;
            let coupling = -(cos * lever);
            let outer = lever * length;
            // M + m·sin² θ, where (M + m)·m·l² − (m·l·cos θ)² would cancel.
            let determinant = (sin * sin * pole + cart) * outer;
            let force = -(lever * omega * omega * sin) - v * of_cart;
            let torque = lever * sin * gravity - omega * of_pivot;
            match output {
                Position => {
                    let drift = (force * outer - torque * coupling) / determinant;
                    single([p, v], drift, outer / determinant)
                }
                Angle => {
                    let drift = (torque * total - force * coupling) / determinant;
                    single([theta, omega], drift, -(coupling / determinant))
                }
            }
        });
    }
}

fn rests_upright_and_hanging<T: Scalar>() {
    let still = SVector::zeros();
    assert_eq!(plant::<T>(Angle).derivative(T::zero(), &still, &SVector::zeros()), still);
    let hanging = SVector::from([num(0.7), T::pi(), T::zero(), T::zero()]);
    let rate = plant::<T>(Angle).derivative(T::zero(), &hanging, &SVector::zeros());
    // π is rounded to T, so sin π is as small as that rounding.
    assert_equal_to_rounding(&rate, &still, 4.0 * GRAVITY / LENGTH);
}

/// The motion for `t` seconds in which the output keeps its second derivative at zero, u = −a/b at every instant.
fn at_rest<T: Scalar>(output: CartPoleOutput, x: [f64; 4], t: f64, steps: u32) -> SVector<T, 4> {
    let x = SVector::from(x.map(num::<T>));
    let plant = plant::<T>(output).linearized::<2>(x).unwrap();
    let field = |t, x: &SVector<T, 4>| {
        let input = -plant.chain_drift(x)[0] / plant.decoupling_matrix(x)[0];
        plant.derivative(t, x, &[input].into())
    };
    Rk4.integrate(field, T::zero(), &x, num(t), steps).unwrap()
}

/// With the cart held, the pole is a pendulum on a fixed pivot; that one counts its angle from hanging.
fn leaves_a_pendulum_when_the_cart_rests<T: Scalar>() {
    let [pole, length, pivot, gravity] = [POLE, LENGTH, FRICTION[1], GRAVITY].map(num::<T>);
    let pendulum = Pendulum::new(pole, length, pivot, gravity).unwrap();
    for (theta, omega) in [(1e-3, 0.0), (0.5, -1.0), (PI - 0.4, 0.0), (PI, 2.0)] {
        let found = at_rest::<T>(Position, [0.3, theta, 0.0, omega], 1.5, 3000);
        let start = [num::<T>(theta - PI), num(omega)];
        let [angle, rate] = flow(&pendulum, start, [T::zero()], num(1.5), 3000).into();
        let expected = [num(0.3), angle + T::pi(), T::zero(), rate];
        // Beside upright, rounding grows with e^(√(g/l)·t) = 430; 3000 steps round.
        assert_equal_to_rounding(&found, &SVector::from(expected), 3000.0);
    }
}

/// With the pole held at θ the cart accelerates with −g·tan θ.
fn leaves_a_drifting_cart_when_the_pole_rests<T: Scalar>() {
    let t = 2.0;
    for theta in [0.0_f64, 0.2, -0.7] {
        let found = at_rest::<T>(Angle, [0.3, theta, 0.8, 0.0], t, 100);
        let fall = -GRAVITY * theta.tan();
        let end = [0.3 + 0.8 * t + 0.5 * fall * t * t, theta, 0.8 + fall * t, 0.0];
        // Rk4 is exact for a parabola; 100 steps round.
        assert_equal_to_rounding(&found, &SVector::from(end.map(num::<T>)), 1000.0);
    }
}

at_f32_and_f64! {
    its_lie_derivatives_are_those_of_the_equations_of_motion => has_the_lie_derivatives_by_hand,
    it_rests_upright_and_hanging => rests_upright_and_hanging,
    while_the_cart_rests_the_pole_swings_as_a_pendulum => leaves_a_pendulum_when_the_cart_rests,
    while_the_pole_rests_the_cart_drifts => leaves_a_drifting_cart_when_the_pole_rests,
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_energy_changes_by_the_power_of_the_force_and_of_friction(
        x in prop::array::uniform4(-4.0..4.0_f64), force in -20.0..20.0_f64,
    ) {
        let x = SVector::from(x);
        let dual = plant(Position);
        let rate = plant(Position).derivative(0.0, &x, &[force].into());
        let found = power(|x| dual.energy(x), &x, &rate);
        let expected = force * x[2] - FRICTION[0] * x[2] * x[2] - FRICTION[1] * x[3] * x[3];
        // Powers of up to 20 N·4 m/s.
        prop_assert!((found - expected).abs() <= 64.0 * f64::EPSILON * 100.0, "{found} {expected}");
    }

    #[test]
    fn its_outputs_have_relative_degree_2_and_zero_dynamics_of_order_2(
        p in -2.0..2.0_f64, theta in -1.5..1.5_f64, v in -2.0..2.0_f64, omega in -4.0..4.0_f64,
    ) {
        for output in [Position, Angle] {
            let found = plant::<f64>(output).relative_degree([p, theta, v, omega]).unwrap();
            prop_assert_eq!((found.degrees, found.zero_dynamics()), ([2], 2));
        }
    }

    #[test]
    fn a_pole_that_lies_flat_is_out_of_reach_of_the_cart(
        p in -2.0..2.0_f64, v in -2.0..2.0_f64, omega in -4.0..4.0_f64,
    ) {
        // cos(π/2) is a rounding error of π/2, and is recognized as one.
        let refused = plant::<f64>(Angle).relative_degree([p, FRAC_PI_2, v, omega]).unwrap_err();
        let undefined = matches!(refused, Error::UndefinedRelativeDegree { output: 0, order: 1, .. });
        prop_assert!(undefined, "{refused}");
        prop_assert_eq!(plant::<f64>(Position).relative_degree([p, FRAC_PI_2, v, omega]).unwrap().degrees, [2]);
    }
}

/// The state after ten seconds in which the position of the cart follows a step of 0.5 m, from an angle of the pole.
fn after_a_step(theta: f64) -> SVector<f64, 4> {
    let start = [0.0, theta, 0.0, 0.0];
    let plant = plant::<f64>(Position).linearized::<2>(start).unwrap();
    let gains = Gains::from_lambda(3.0).unwrap();
    let flc = Decoupling::new(&plant, [FeedbackLinearization::new(IntegratorChain::new(), gains)]);
    let reference = |_| [Reference::setpoint(0.5)];
    let run = Simulation::new(&plant, flc, reference, start, 0.005).unwrap();
    run.until(10.0).unwrap().last().unwrap().unwrap().x
}

/// What RelativeDegree says of zero dynamics, seen from outside: the output is as good in both cases.
#[test]
fn the_cart_arrives_whether_its_zero_dynamics_are_stable_or_not() {
    let (hanging, upright) = (after_a_step(PI), after_a_step(0.0));
    for x in [hanging, upright] {
        // e^(−3·10)·(1 + 30) m, and the hold of 5 ms.
        assert!((x[0] - 0.5).abs() < 1e-3 && x[2].abs() < 1e-2, "{x}");
    }
    // Hanging, it swings at √(g/l) and the friction of the pivot has taken away e^(−d·t/(2·m·l²)) ≈ 0.9.
    assert!((hanging[1] - PI).abs() < 0.5, "{hanging}");
    // From upright it has fallen over.
    assert!(upright[1].abs() > FRAC_PI_2, "{upright}");
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    fn new(p: [f64; 3], friction: [f64; 2], gravity: f64) -> Result<CartPole<f64>, Error> {
        CartPole::new(p[0], p[1], p[2], friction, gravity, Angle)
    }
    Refusals(&[
        ("cart", |v| new([v, POLE, LENGTH], FRICTION, GRAVITY)),
        ("pole", |v| new([CART, v, LENGTH], FRICTION, GRAVITY)),
        ("length", |v| new([CART, POLE, v], FRICTION, GRAVITY)),
    ])
    .all_are_positive();
    Refusals(&[
        ("friction of the cart", |v| new([CART, POLE, LENGTH], [v, 0.0], GRAVITY)),
        ("friction of the pivot", |v| new([CART, POLE, LENGTH], [0.0, v], GRAVITY)),
        ("gravity", |v| new([CART, POLE, LENGTH], FRICTION, v)),
    ])
    .none_is_negative();
}
