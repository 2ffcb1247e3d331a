//! A robot whose tracks slip: what feedback alone leaves, what learning takes over, and what it is told about saturated drives.

use brunovsky::{
    controller::{Clelc, Controller, Measurement, unicycle::Direction},
    learning::{ModelAided, NullCompensator, SlidingMode},
    plant::IntegratorChain,
    trajectory::{Circle, FigureEight, Trajectory},
};
use nalgebra::{Complex, SVector};

use super::{Drives, Planar, Robot, Step, flc, on, order, refusing, run};
use crate::support::learning;

const LAMBDA: f64 = 1.5;
const RADIUS: f64 = 2.0;
const RATE: f64 = 0.5;

fn circle(t: f64) -> Planar {
    Circle::new([0.0, 0.0], RADIUS, RATE, 0.0).unwrap().references(t)
}

/// The greatest distance from `reference` after the transient, which e^(−1.2·25) has taken below 1e-11.
fn remaining<D>(steps: &[Step<D>]) -> f64 {
    steps.iter().filter(|step| step.t >= 25.0).map(Step::distance).fold(0.0, f64::max)
}

fn slipping(mu: f64, kappa: f64) -> Robot {
    Robot { drives: Drives::Ramped, mu, kappa }
}

/// With μ = κ the robot gets p̈ = μ·ν whatever its heading, so ë + 2λμ·ė + μλ²·e = (1 − μ)·r̈: around a circle, r̈ = −ω²R·e^(iωt) in the
/// complex plane, the distance is |1 − μ|·ω²R/|μλ² − ω² + 2iλμω|.
#[test]
fn feedback_alone_stays_off_a_circle_by_the_closed_form() {
    for mu in [0.8, 1.25] {
        let dynamics = Complex::new(mu * LAMBDA * LAMBDA - RATE * RATE, 2.0 * LAMBDA * mu * RATE);
        let expected = f64::abs(1.0 - mu) * RATE * RATE * RADIUS / dynamics.norm();
        // A steady turn is a constant input, which the hold reproduces: the period does not matter.
        for h in [0.02, 0.1] {
            let controller = refusing(flc(LAMBDA), Direction::Forward);
            let start = on(&circle(0.0), Direction::Forward);
            let found = remaining(&run(slipping(mu, mu), controller, circle, start, h, 40.0));
            // The Runge–Kutta steps leave (ωh/4)⁴/2880 = 1e-11 of a circle of 2 m.
            approx::assert_abs_diff_eq!(found, expected, epsilon = 1e-9);
        }
    }
}

/// The learned term is Δ of one period before, so what is left of it is |ν̇|·(1 − μ)·h, and the distance goes to zero with the period:
/// whatever feedback alone leaves, a short enough period leaves less.
#[test]
fn learning_brings_the_distance_down_with_the_period() {
    let eight = FigureEight::new(2.0, 1.0, 0.4).unwrap();
    let references: [&dyn Fn(f64) -> Planar; 2] = [&circle, &|t| eight.references(t)];
    for (mu, kappa) in [(0.8, 0.8), (0.8, 0.7), (1.2, 0.9)] {
        for reference in references {
            let start = on(&reference(0.0), Direction::Forward);
            let robot = slipping(mu, kappa);
            let learned = |h: f64| {
                let rule = SlidingMode::new(20.0).unwrap();
                let axes = [learning(IntegratorChain::new(), LAMBDA, ModelAided::new(), rule); 2];
                let controller = refusing(axes, Direction::Forward);
                remaining(&run(robot, controller, reference, start, h, 45.0))
            };
            let measured = order(learned, 0.02);
            assert!((measured - 1.0).abs() < 0.15, "order {measured}");
            let controller = refusing(flc(LAMBDA), Direction::Forward);
            let fed_back = remaining(&run(robot, controller, reference, start, 0.02, 45.0));
            assert!(learned(0.02) < fed_back, "{} {fed_back}", learned(0.02));
        }
    }
}

/// The loop with drives that turn by no more than 0.3 rad/s and drive no faster than 1 m/s, watched by [`ModelAided`]: the greatest
/// distance of s from −Δ, the mean of both ends of the last period, where Δ = (μ − 1)·ξ·t + (κ − 1)·v·ω·n with the ξ and ω that were applied.
///
/// Without the report, the applied input is taken to be the command.
fn farthest_from_uncertainty(h: f64, reported: bool) -> f64 {
    let robot = slipping(0.8, 0.7);
    let axes = flc(LAMBDA).map(|axis| Clelc::new(axis, NullCompensator::new(ModelAided::new())));
    let mut controller = refusing(axes, Direction::Forward);
    let mut x = on(&circle(0.0), Direction::Forward);
    let (mut applied, mut asked, mut before) = ([x[3], 0.0], x[3], x);
    let (mut farthest, mut saturated) = (0.0_f64, [0, 0]);
    for k in 0..(6.0 / h).round() as u32 {
        let measurement = Measurement::new(x);
        let measurement = if reported { measurement.with_applied(applied) } else { measurement };
        let command = controller.update(&measurement, &circle(f64::from(k) * h), h).unwrap();
        let xi = (applied[0] - asked) / h;
        let delta = |x: SVector<f64, 4>| {
            let (sin, cos) = x[2].sin_cos();
            let (along, across) = (-0.2 * xi, -0.3 * x[3] * applied[1]);
            [along * cos - across * sin, along * sin + across * cos]
        };
        // In the first period the drives went from the speed over ground to the speed of the tracks.
        if k > 1 {
            for (i, axis) in command.decoupled.chains.iter().enumerate() {
                let expected = -0.5 * (delta(before)[i] + delta(x)[i]);
                farthest = farthest.max((axis.s - expected).abs());
            }
        }
        asked = applied[0];
        applied = [command.v.clamp(-1.0, 1.0), command.omega.clamp(-0.3, 0.3)];
        saturated[0] += u32::from(applied[0] != command.v);
        saturated[1] += u32::from(applied[1] != command.omega);
        before = x;
        x = robot.after(x, applied, h);
    }
    assert!(saturated.iter().all(|&samples| samples > 10), "{saturated:?}");
    farthest
}

#[test]
fn saturated_drives_that_report_their_speed_and_rate_do_not_disturb_what_is_learned_from() {
    // The mean of the two ends of a period is its mean up to the second order.
    let measured = order(|h| farthest_from_uncertainty(h, true), 0.02);
    assert!((measured - 2.0).abs() < 0.2, "order {measured}");
}

#[test]
fn saturated_drives_that_report_nothing_are_taken_for_uncertainty() {
    // What was cut off, (κ·)v·(ω − 0.3) and ξ, does not vanish with the period.
    assert!(farthest_from_uncertainty(0.005, false) > 0.1);
}
