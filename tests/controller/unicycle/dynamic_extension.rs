//! The law sample by sample: (ξ, ω) against eq_transformation, the integrator from ξ to v, and calls that are refused.

use brunovsky::{
    Error, Scalar,
    controller::{
        Clelc, Command, Controller, Measurement, Reference,
        unicycle::{Direction, Standstill, UnicycleController},
    },
    learning::{Measured, ModelAided, NullCompensator, SlidingMode},
    plant::IntegratorChain,
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{Axis, Planar, flc, refusing};
use crate::{
    at_f32_and_f64,
    support::{learning, num, real},
};

const LAMBDA: f64 = 1.5;

/// (r₁, ṙ₁, r̈₁) of either axis.
fn planar(r: [[f64; 3]; 2]) -> Planar {
    r.map(|[r, v, a]| Reference::new([r, v], a))
}

/// eq_transformation behind u = r̈ + 2λ·ė + λ²·e.
fn by_formula([x, y, theta, v]: [f64; 4], r: [[f64; 3]; 2]) -> [f64; 2] {
    let nu = |axis: usize, p: f64, rate: f64| {
        let [r, r_dot, r_ddot] = r[axis];
        r_ddot + 2.0 * LAMBDA * (r_dot - rate) + LAMBDA * LAMBDA * (r - p)
    };
    let (u1, u2) = (nu(0, x, v * theta.cos()), nu(1, y, v * theta.sin()));
    [u1 * theta.cos() + u2 * theta.sin(), (u2 * theta.cos() - u1 * theta.sin()) / v]
}

fn speeds() -> impl Strategy<Value = f64> {
    prop_oneof![-4.0..-0.05_f64, 0.05..4.0_f64]
}

fn references() -> impl Strategy<Value = [[f64; 3]; 2]> {
    prop::array::uniform2(prop::array::uniform3(-3.0..3.0_f64))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn acceleration_and_yaw_rate_are_those_of_the_formula(
        p in prop::array::uniform2(-3.0..3.0_f64), theta in -7.0..7.0_f64, v in speeds(), r in references(), dt in 1e-3..1.0_f64,
    ) {
        let x = [p[0], p[1], theta, v];
        let [xi, omega] = by_formula(x, r);
        // ν adds terms up to 3 + 2λ·7 + λ²·6 < 40; ω divides their rounding by |v|.
        let rounding = 32.0 * f64::EPSILON * 40.0;
        for direction in [Direction::Forward, Direction::Reverse] {
            let command = refusing(flc(LAMBDA), direction).update(&Measurement::new(x), &planar(r), dt).unwrap();
            prop_assert!((command.decoupled.u[0] - xi).abs() <= rounding);
            prop_assert!((command.omega - omega).abs() <= rounding / v.abs());
            prop_assert!((command.v - (v + xi * dt)).abs() <= rounding * (1.0 + dt));
            prop_assert_eq!(command.input(), SVector::from([command.v, command.omega]));
            prop_assert_eq!(command.omega, command.decoupled.u[1]);
        }
    }

    /// v is an integrator of its own: it goes on from the speed commanded, not from the one measured, unless the drives report theirs.
    #[test]
    fn the_speed_command_is_the_integral_of_the_acceleration(
        states in prop::collection::vec((speeds(), -7.0..7.0_f64, prop::option::of(-3.0..3.0_f64), 1e-3..0.5_f64), 1..12),
        r in references(),
    ) {
        let mut controller = refusing(flc(LAMBDA), Direction::Forward);
        let mut expected = None;
        for (v, theta, reported, dt) in states {
            let x = [0.3, -0.4, theta, v];
            let measurement = Measurement::new(x);
            let measurement = reported.map_or(measurement, |v| measurement.with_applied([v, 0.7]));
            let command = controller.update(&measurement, &planar(r), dt).unwrap();
            let from = match (expected, reported) {
                (None, _) => v,
                (Some(_), Some(reported)) => reported,
                (Some(last), None) => last,
            };
            let next = from + by_formula(x, r)[0] * dt;
            // As above, once a sample and at most twelve of them.
            prop_assert!((command.v - next).abs() <= 12.0 * 32.0 * f64::EPSILON * 40.0);
            expected = Some(command.v);
        }
    }

    #[test]
    fn pairs_and_arrays_of_the_same_law_say_the_same(
        theta in -7.0..7.0_f64, v in speeds(), r in references(), later in speeds(),
    ) {
        type Watching = Clelc<IntegratorChain<f64, 2>, NullCompensator<ModelAided<f64>>, 2>;
        let [x, y]: [Axis; 2] = flc(LAMBDA);
        let watching = |axis: Axis| -> Watching { Clelc::new(axis, NullCompensator::new(ModelAided::new())) };
        let mut array = refusing([x, y], Direction::Forward);
        let mut null = refusing([watching(x), watching(y)], Direction::Forward);
        let mut pair = refusing((x, watching(y)), Direction::Forward);
        let mut other = refusing((watching(x), y), Direction::Forward);
        for v in [v, later] {
            let at = Measurement::new([0.3, -0.4, theta, v]);
            let expected = array.update(&at, &planar(r), 0.1).unwrap().input();
            prop_assert_eq!(null.update(&at, &planar(r), 0.1).unwrap().input(), expected);
            let mixed = pair.update(&at, &planar(r), 0.1).unwrap();
            prop_assert_eq!(mixed.input(), expected);
            prop_assert_eq!(mixed.decoupled.chains.0.u, mixed.decoupled.nu[0]);
            prop_assert_eq!(mixed.decoupled.chains.1.u, mixed.decoupled.nu[1]);
            prop_assert_eq!(other.update(&at, &planar(r), 0.1).unwrap().input(), expected);
        }
    }
}

fn works_in_any_precision<T: Scalar>() {
    let (x, r) = ([0.3, -0.4, 2.1, -0.8], [[1.0, 0.5, -0.2], [0.5, -0.7, 0.2]]);
    let axis = crate::support::flc(IntegratorChain::<T, 2>::new(), LAMBDA);
    let mut controller =
        UnicycleController::new([axis; 2], Direction::Reverse, num(0.1), Standstill::Hold).unwrap();
    let reference = r.map(|[r, v, a]| Reference::new([num(r), num(v)], num(a)));
    let command =
        controller.update(&Measurement::new(x.map(num::<T>)), &reference, num(0.5)).unwrap();
    let [xi, omega] = by_formula(x, r);
    // ν < 10 is a sum of rounded terms, divided by |v| = 0.8 for ω.
    let tolerance = 32.0 * 10.0 * real(T::default_epsilon());
    approx::assert_abs_diff_eq!(real(command.v), x[3] + 0.5 * xi, epsilon = tolerance);
    approx::assert_abs_diff_eq!(real(command.omega), omega, epsilon = tolerance);
}

at_f32_and_f64! {
    one_sample_is_that_of_the_formula => works_in_any_precision,
}

fn learning_axes() -> [crate::support::Learning<IntegratorChain<f64, 2>, ModelAided<f64>, f64, 2>; 2]
{
    [learning(IntegratorChain::new(), LAMBDA, ModelAided::new(), SlidingMode::new(20.0).unwrap());
        2]
}

#[test]
fn whatever_is_refused_leaves_the_controller_as_it_was() {
    let good = Measurement::new([0.1, 0.2, 0.3, 0.8]);
    let r = planar([[0.4, 0.5, 0.1], [0.0, 0.3, -0.2]]);
    let fresh = refusing(learning_axes(), Direction::Forward);
    let mut used = fresh;
    used.update(&good, &r, 0.1).unwrap();
    used.update(&good, &r, 0.1).unwrap();
    assert!(used != fresh, "it has learned, so there is something to spoil");
    for before in [fresh, used] {
        let refused = |measurement: Measurement<f64, 4, 2>, r: Planar, dt: f64| {
            let mut controller = before;
            let error = controller.update(&measurement, &r, dt).unwrap_err();
            assert!(controller == before, "{error}");
            error
        };
        assert_eq!(refused(good, r, 0.0), Error::NotPositive { name: "dt", value: 0.0 });
        assert_eq!(refused(good, r, -0.1), Error::NotPositive { name: "dt", value: -0.1 });
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(matches!(refused(good, r, bad), Error::NonFinite { name: "dt", .. }));
            for index in 0..4 {
                let mut x = good;
                x.x[index] = bad;
                let mut rate = SVector::<f64, 4>::zeros();
                rate[index] = bad;
                for (wrong, measurement) in [("x", x), ("x_dot", good.with_rate(rate))] {
                    let error = refused(measurement, r, 0.1);
                    assert!(
                        matches!(error, Error::NonFiniteEntry { name, index: i, .. } if name == wrong && i == index)
                    );
                }
            }
            let error = refused(good.with_applied([0.0, bad]), r, 0.1);
            assert!(matches!(error, Error::NonFiniteEntry { name: "applied", index: 1, .. }));
            // The second axis fails after the first has already been updated.
            let mut second = r;
            second[1].r_n_dot = bad;
            assert!(matches!(refused(good, second, 0.1), Error::NonFinite { name: "r_n_dot", .. }));
        }
        // v is added up last: ξ ≈ 1e300 is finite, over 1e10 s it is not.
        let mut far = r;
        far[0].r_n_dot = 1e300;
        assert!(matches!(refused(good, far, 1e10), Error::NonFinite { name: "v", .. }));
    }
}

#[test]
fn a_minimum_speed_that_is_not_positive_is_refused_by_name() {
    let new =
        |speed| UnicycleController::new(flc(1.0), Direction::Forward, speed, Standstill::Hold);
    for value in [0.0, -0.0, -0.1] {
        assert_eq!(new(value).unwrap_err(), Error::NotPositive { name: "min_speed", value });
    }
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(new(bad), Err(Error::NonFinite { name: "min_speed", .. })));
    }
}

#[test]
fn reset_forgets_the_speed_command_and_what_was_learned() {
    let fresh = refusing(learning_axes(), Direction::Reverse);
    let mut used = fresh;
    let r = planar([[0.4, 0.5, 0.1], [0.0, 0.3, -0.2]]);
    let at = |v: f64| Measurement::new([0.1, 0.2, 0.3, v]);
    let first = used.update(&at(-0.8), &r, 0.1).unwrap();
    used.update(&at(-0.7), &r, 0.1).unwrap();
    used.reset();
    assert!(used == fresh);
    assert_eq!(used.update(&at(-0.8), &r, 0.1).unwrap(), first);
}

/// On a circle as driven, ṗ̈ = B·(0, ω) with the ω that the drives report, so a sensor for ẋ shows no uncertainty: s = −u_n = 0, at
/// the first sample as at any other.
#[test]
fn a_robot_that_is_already_turning_shows_no_uncertainty_at_the_first_sample() {
    let [theta, v, omega] = [0.3_f64, 0.8, 0.5];
    let axis = flc(LAMBDA)[0];
    let watching = Clelc::new(axis, NullCompensator::new(Measured));
    let mut controller = refusing([watching; 2], Direction::Forward);
    let r = planar([[0.1, v * theta.cos(), 0.0], [0.2, v * theta.sin(), 0.0]]);
    let at = Measurement::new([0.1, 0.2, theta, v])
        .with_rate([v * theta.cos(), v * theta.sin(), omega, 0.0])
        .with_applied([v, omega]);
    let command = controller.update(&at, &r, 0.1).unwrap();
    for axis in command.decoupled.chains {
        approx::assert_abs_diff_eq!(axis.s, 0.0, epsilon = 1e-14);
    }
}
