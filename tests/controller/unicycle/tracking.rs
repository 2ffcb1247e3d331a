//! A robot that does as it is told, against the curve it follows and the closed form of the linear error dynamics.

use brunovsky::{
    controller::unicycle::Direction,
    trajectory::{Circle, FigureEight, Line, Trajectory},
};
use nalgebra::SVector;

use super::{Drives, Planar, Robot, flc, on, order, refusing, run};
use crate::support::error_dynamics;

const BOTH: [Direction; 2] = [Direction::Forward, Direction::Reverse];
const DRIVES: [Drives; 2] = [Drives::Held, Drives::Ramped];
const LAMBDA: f64 = 1.5;

fn circle(rate: f64) -> impl Fn(f64) -> Planar {
    let circle = Circle::new([1.0, -2.0], 2.0, rate, 0.4).unwrap();
    move |t| circle.references(t)
}

/// A steady turn is a constant input, which the hold reproduces: what is left is rounding, which the loop damps, and that of the four
/// Runge–Kutta steps a period, (ωh/4)⁴/2880 ≈ 1e-13 of the speed.
#[test]
fn started_on_a_circle_it_stays_there_with_its_rate_and_speed() {
    for (direction, rate) in BOTH.into_iter().flat_map(|d| [(d, 0.6), (d, -0.6)]) {
        for drives in DRIVES {
            let start = on(&circle(rate)(0.0), direction);
            let controller = refusing(flc(LAMBDA), direction);
            for step in run(Robot::exact(drives), controller, circle(rate), start, 0.05, 30.0) {
                assert!(step.distance() < 1e-10, "{} at {}", step.distance(), step.t);
                approx::assert_abs_diff_eq!(step.command.omega, rate, epsilon = 1e-9);
                let v = direction.sign::<f64>() * 2.0 * 0.6;
                approx::assert_abs_diff_eq!(step.command.v, v, epsilon = 1e-9);
            }
        }
    }
}

#[test]
fn started_on_a_line_it_stays_there_without_turning() {
    let line = Line::new([1.0, 2.0], [-0.6, 0.8]).unwrap();
    for (direction, drives) in BOTH.into_iter().flat_map(|d| DRIVES.map(|drives| (d, drives))) {
        let start = on(&line.references(0.0), direction);
        let controller = refusing(flc(LAMBDA), direction);
        let steps =
            run(Robot::exact(drives), controller, |t| line.references(t), start, 0.05, 30.0);
        for step in steps {
            // Positions up to 24 are rounded, and λ²/v ≈ 2 of that is steered.
            assert!(step.distance() < 1e-12 && step.command.omega.abs() < 1e-11);
            approx::assert_abs_diff_eq!(step.command.v, direction.sign::<f64>(), epsilon = 1e-11);
        }
    }
}

/// The input is held while the reference moves on, so the distance from it is of first order in the period.
#[test]
fn started_on_a_figure_eight_it_is_off_by_the_first_order_of_the_period() {
    for rate in [0.5, -0.5] {
        let eight = FigureEight::new(2.0, 1.0, rate).unwrap();
        for (direction, drives) in BOTH.into_iter().flat_map(|d| DRIVES.map(|drives| (d, drives))) {
            let farthest = |h: f64| {
                let start = on(&eight.references(0.0), direction);
                let controller = refusing(flc(LAMBDA), direction);
                let steps =
                    run(Robot::exact(drives), controller, |t| eight.references(t), start, h, 25.0);
                let turned = steps[steps.len() / 50].command.omega;
                // ω_d·|ṙ|² = −ω³·a·b·(4·cos τ·sin 2τ − 2·cos 2τ·sin τ) with τ = ωt is even in ω, and negative for a small τ: out of
                // the crossing, either lobe is entered by a turn to the right.
                assert!(turned < 0.0, "{turned}");
                steps.iter().map(super::Step::distance).fold(0.0, f64::max)
            };
            let measured = order(farthest, 0.01);
            assert!((measured - 1.0).abs() < 0.1, "order {measured}");
        }
    }
}

/// The loop is linear in the position: from any offset, each axis obeys ë + 2λ·ė + λ²·e = 0, up to the first order of the hold.
#[test]
fn an_offset_decays_like_the_linear_error_dynamics_of_each_axis() {
    let gains = SVector::from([LAMBDA * LAMBDA, 2.0 * LAMBDA]);
    for (direction, rate) in BOTH.into_iter().flat_map(|d| [(d, 0.6), (d, -0.6)]) {
        for drives in DRIVES {
            let deviation = |h: f64| {
                let mut start = on(&circle(rate)(0.0), direction);
                start += SVector::from([0.2, -0.15, 0.1, 0.05]);
                let controller = refusing(flc(LAMBDA), direction);
                let steps = run(Robot::exact(drives), controller, circle(rate), start, h, 6.0);
                let from = steps[0].e;
                let off = steps.iter().step_by(10).flat_map(|step| {
                    [0, 1].map(|i| (step.e[i] - error_dynamics(&gains, &from[i], step.t)).norm())
                });
                off.fold(0.0, f64::max)
            };
            let measured = order(deviation, 0.004);
            assert!((measured - 1.0).abs() < 0.1, "order {measured}");
        }
    }
}
