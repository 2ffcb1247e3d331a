//! The guard on the two axes of the robot, whose sensor of ẋ fails.

use brunovsky::{
    controller::{
        Clelc, Controller, Measurement,
        unicycle::{Direction, Standstill, UnicycleController},
    },
    fuzzy::FuzzyNetwork,
    learning::{Guarded, Measured, NeuroFuzzy, SlidingMode, Watchdog},
    plant::{Plant, Unicycle},
    trajectory::{Circle, Trajectory},
};
use nalgebra::{Complex, SVector};

use super::{Drives, Robot, flc, on};

const LAMBDA: f64 = 1.5;
const RADIUS: f64 = 2.0;
const RATE: f64 = 0.5;
const H: f64 = 0.02;
const MU: f64 = 0.8;

/// Both axes with a guard on them around a circle, on ground on which the robot drives and turns 0.8 of what it is told. The distance from the
/// reference before the sensor of ẋ goes silent and says 0, at 30 s, and at the end, at 90 s.
fn distances(fallback: Option<f64>) -> ([f64; 2], bool) {
    let circle = Circle::new([0.0, 0.0], RADIUS, RATE, 0.0).unwrap();
    let rule = SlidingMode::new(20.0).unwrap();
    let certificate = rule.certificate(H, 2.0).unwrap();
    let patience = certificate.recovery_time(1.0, 0.05).unwrap().unwrap();
    let watchdog = Watchdog::new(certificate, 0.1, patience).unwrap();
    let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([1.0, 1.0]).unwrap();
    let guarded = Guarded::new(NeuroFuzzy::new(network, Measured, rule), watchdog);
    let guarded = fallback.map_or(guarded, |fade| guarded.with_fallback(fade).unwrap());
    let axes = flc(LAMBDA).map(|axis| Clelc::new(axis, guarded));
    let mut controller =
        UnicycleController::new(axes, Direction::Forward, 0.01, Standstill::Hold).unwrap();

    let robot = Robot { drives: Drives::Ramped, mu: MU, kappa: MU };
    let mut x = on(&circle.references(0.0), Direction::Forward);
    let mut input = SVector::zeros();
    let mut distances = [0.0; 2];
    for k in 0..4500_u32 {
        let t = f64::from(k) * H;
        let reference = circle.references(t);
        let x_dot =
            if t < 30.0 { Unicycle::new().derivative(t, &x, &input) } else { SVector::zeros() };
        let measurement = Measurement::new(x).with_rate(x_dot);
        let command = controller.update(&measurement, &reference, H).unwrap();
        let distance = (reference[0].r[0] - x[0]).hypot(reference[1].r[0] - x[1]);
        distances[usize::from(t >= 30.0)] = distance;
        input = SVector::from([(MU * command.v - x[3]) / H, MU * command.omega]);
        x = robot.after(x, [command.v, command.omega], H);
    }
    (distances, controller.axes().iter().all(|axis| axis.compensator().tripped()))
}

/// p̈ = μ·ν, as in `traction`: feedback alone stays off the circle by |1 − μ|·ω²R/|μλ² − ω² + 2iλμω|.
#[test]
fn both_axes_fall_back_to_the_distance_of_feedback_alone() {
    let dynamics = Complex::new(MU * LAMBDA * LAMBDA - RATE * RATE, 2.0 * LAMBDA * MU * RATE);
    let fed_back = (1.0 - MU) * RATE * RATE * RADIUS / dynamics.norm();
    let ([learned, failed], tripped) = distances(None);
    assert!(tripped && learned < 0.1 * fed_back && failed > fed_back);
    let ([still, guarded], tripped) = distances(Some(4.0));
    assert!(tripped && still == learned);
    approx::assert_abs_diff_eq!(guarded, fed_back, epsilon = 1e-9);
}
