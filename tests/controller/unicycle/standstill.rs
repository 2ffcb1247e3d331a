//! Where the robot stands, or nearly: refusing, holding the law as at the minimum speed, and never a NaN.

use brunovsky::{
    Error,
    controller::{
        Clelc, Controller, Measurement, Reference,
        unicycle::{Direction, Standstill, UnicycleController},
    },
    learning::{ModelAided, NullCompensator},
    trajectory::{Line, Trajectory},
};
use proptest::prelude::*;

use super::{Axis, Drives, Planar, Robot, flc, run};

const MIN_SPEED: f64 = 0.1;
const BOTH: [Direction; 2] = [Direction::Forward, Direction::Reverse];

fn controller(
    direction: Direction,
    min_speed: f64,
    standstill: Standstill,
) -> UnicycleController<f64, [Axis; 2]> {
    UnicycleController::new(flc(1.5), direction, min_speed, standstill).unwrap()
}

/// A reference one axis after the other: (r₁, ṙ₁, r̈₁).
fn planar(r: [[f64; 3]; 2]) -> Planar {
    r.map(|[r, v, a]| Reference::new([r, v], a))
}

#[test]
fn below_the_minimum_speed_it_refuses_naming_the_speed_and_changes_nothing() {
    let r = planar([[1.0, 0.5, 0.0], [0.5, 0.0, 0.2]]);
    let at = |v: f64| Measurement::new([0.0, 0.0, 0.3, v]);
    for direction in BOTH {
        let fresh = controller(direction, MIN_SPEED, Standstill::Refuse);
        let mut used = fresh;
        used.update(&at(0.5), &r, 0.1).unwrap();
        for before in [fresh, used] {
            for value in [0.0, -0.0, 0.099, -0.099, 5e-324] {
                let mut refusing = before;
                let error = refusing.update(&at(value), &r, 0.1).unwrap_err();
                assert_eq!(error, Error::Singular { name: "v", value });
                assert!(refusing == before);
            }
            for v in [MIN_SPEED, -MIN_SPEED] {
                let mut accepting = before;
                assert!(
                    accepting.update(&at(v), &r, 0.1).is_ok(),
                    "the limit itself is fast enough"
                );
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// ω = (u₂·cos θ − u₁·sin θ)/v with v = ±v_min in the direction of travel, so |ω| ≤ |u|/v_min; ξ does not depend on v.
    #[test]
    fn a_slow_robot_is_steered_as_at_the_minimum_speed(
        theta in -7.0..7.0_f64, v in -MIN_SPEED..MIN_SPEED, r in prop::array::uniform2(prop::array::uniform3(-3.0..3.0_f64)),
    ) {
        for direction in BOTH {
            let command = controller(direction, MIN_SPEED, Standstill::Hold)
                .update(&Measurement::new([0.1, -0.2, theta, v]), &planar(r), 0.1)
                .unwrap();
            let nu = command.decoupled.nu;
            let (sin, cos) = theta.sin_cos();
            let across = nu[1] * cos - nu[0] * sin;
            // ν < 25 is rounded, and divided by the minimum speed.
            let rounding = 16.0 * f64::EPSILON * 25.0;
            let steered = direction.sign::<f64>() * MIN_SPEED * command.omega;
            prop_assert!((steered - across).abs() <= rounding);
            prop_assert!(command.omega.abs() <= nu.norm() / MIN_SPEED + rounding / MIN_SPEED);
            prop_assert!((command.decoupled.u[0] - (nu[0] * cos + nu[1] * sin)).abs() <= rounding);
        }
    }

    /// Whatever the speeds, subnormal and huge ones included: a finite command, or a reason and the controller as before.
    #[test]
    fn no_speed_gives_nan(
        theta in any::<f64>(), speeds in prop::array::uniform3(prop_oneof![any::<f64>(), prop::num::f64::SUBNORMAL, Just(0.0), -1.0..1.0_f64]),
        min_speed in prop_oneof![prop::num::f64::POSITIVE, prop::num::f64::SUBNORMAL.prop_map(f64::abs)],
        hold in any::<bool>(), reverse in any::<bool>(), dt in 1e-6..1e6_f64,
    ) {
        let standstill = if hold { Standstill::Hold } else { Standstill::Refuse };
        let Ok(mut controller) = UnicycleController::new(flc(1.5), BOTH[usize::from(reverse)], min_speed, standstill) else {
            // An infinite minimum speed is refused as any other.
            return Ok(());
        };
        let r = planar([[1.0, 0.5, -0.2], [0.5, -0.7, 0.2]]);
        for v in speeds {
            let before = controller;
            match controller.update(&Measurement::new([0.0, 0.0, theta, v]), &r, dt) {
                Ok(command) => prop_assert!(command.v.is_finite() && command.omega.is_finite()),
                Err(_) => prop_assert!(controller == before),
            }
        }
    }
}

/// From rest, askew and beside the reference: it gets going, and what is left decays like e^(−1.5·t).
#[test]
fn a_robot_at_rest_gets_going_and_joins_the_reference() {
    let line = Line::new([0.3, 0.1], [0.4, 0.3]).unwrap();
    for (direction, facing) in
        [(Direction::Forward, 0.0), (Direction::Reverse, core::f64::consts::PI)]
    {
        for askew in [0.0, 0.9, -0.9] {
            let start = [0.0, 0.0, 0.6435 + facing + askew, 0.0].into();
            let holding = controller(direction, MIN_SPEED, Standstill::Hold);
            let robot = Robot::exact(Drives::Ramped);
            let steps = run(robot, holding, |t| line.references(t), start, 0.02, 40.0);
            let last = steps.last().unwrap();
            assert!(last.distance() < 1e-6, "{}", last.distance());
            approx::assert_abs_diff_eq!(last.x[3], direction.sign::<f64>() * 0.5, epsilon = 1e-6);
            assert!(steps.iter().all(|step| step.command.omega.is_finite()));
        }
    }
}

/// A robot that turns on the spot as it is told has p̈ = 0, which is what B(x)·(0, ω) says at v = 0: s = −(u_n + Δ) = 0.
///
/// Were the chains told what the input amounts to at the minimum speed, v_min·ω·n instead of v·ω·n, the whole lateral acceleration asked
/// for would appear as uncertainty, and a learning axis would wind up while the robot stands.
#[test]
fn a_robot_that_turns_on_the_spot_shows_no_uncertainty() {
    let axes = flc(1.5).map(|axis| Clelc::new(axis, NullCompensator::new(ModelAided::new())));
    let mut holding =
        UnicycleController::new(axes, Direction::Forward, MIN_SPEED, Standstill::Hold).unwrap();
    // The reference rests to the left: ξ = 0, and only ω is asked for.
    let r = planar([[0.0, 0.0, 0.0], [0.02, 0.0, 0.0]]);
    let start = [0.0; 4].into();
    let first = holding.update(&Measurement::new(start), &r, 0.1).unwrap();
    assert!(first.omega > 0.1 && first.v == 0.0);
    let x = Robot::exact(Drives::Ramped).after(start, [first.v, first.omega], 0.1);
    let second = holding.update(&Measurement::new(x), &r, 0.1).unwrap();
    for axis in second.decoupled.chains {
        approx::assert_abs_diff_eq!(axis.s, 0.0, epsilon = 1e-14);
    }
}
