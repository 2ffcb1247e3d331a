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

/// Both axes with a guard on them around a circle, on ground on which the robot drives and turns 0.8 of what it is told. The sensor of ẋ goes
/// silent and says 0 from 30 s until 80 s, when both guards are armed again: the distance from the reference at the end of each part, the last at
/// 120 s, and whether both had tripped.
fn distances(fallback: Option<f64>) -> ([f64; 3], bool) {
    let circle = Circle::new([0.0, 0.0], RADIUS, RATE, 0.0).unwrap();
    let rule = SlidingMode::new(20.0).unwrap();
    let certificate = rule.certificate(H, 2.0).unwrap();
    let patience = certificate.recovery_time(1.0, 0.05).unwrap().unwrap();
    let watchdog = Watchdog::new(certificate, 0.1, patience).unwrap();
    let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([1.0, 1.0]).unwrap();
    let learner = NeuroFuzzy::new(network, Measured, rule);
    let guarded = Guarded::new(learner, watchdog);
    let guarded = fallback.map_or(guarded, |fade| guarded.with_fallback(fade).unwrap());
    let axes = flc(LAMBDA).map(|axis| Clelc::new(axis, guarded));
    let mut controller =
        UnicycleController::new(axes, Direction::Forward, 0.01, Standstill::Hold).unwrap();

    let robot = Robot { drives: Drives::Ramped, mu: MU, kappa: MU };
    let mut x = on(&circle.references(0.0), Direction::Forward);
    let mut input = SVector::zeros();
    let (mut distances, mut tripped) = ([0.0; 3], false);
    for k in 0..6000_u32 {
        let t = f64::from(k) * H;
        let reference = circle.references(t);
        let part = usize::from(k >= 1500) + usize::from(k >= 4000);
        let x_dot = match part {
            1 => SVector::zeros(),
            _ => Unicycle::new().derivative(t, &x, &input),
        };
        if k == 4000 {
            tripped = controller.axes().iter().all(|axis| axis.compensator().tripped());
            controller.axes_mut().iter_mut().for_each(|axis| axis.compensator_mut().rearm(learner));
        }
        let measurement = Measurement::new(x).with_rate(x_dot);
        let command = controller.update(&measurement, &reference, H).unwrap();
        let distance = (reference[0].r[0] - x[0]).hypot(reference[1].r[0] - x[1]);
        distances[part] = distance;
        input = SVector::from([(MU * command.v - x[3]) / H, MU * command.omega]);
        x = robot.after(x, [command.v, command.omega], H);
    }
    (distances, tripped)
}

/// p̈ = μ·ν, as in `traction`: feedback alone stays off the circle by |1 − μ|·ω²R/|μλ² − ω² + 2iλμω|.
#[test]
fn both_axes_fall_back_to_the_distance_of_feedback_alone() {
    let dynamics = Complex::new(MU * LAMBDA * LAMBDA - RATE * RATE, 2.0 * LAMBDA * MU * RATE);
    let fed_back = (1.0 - MU) * RATE * RATE * RADIUS / dynamics.norm();
    let ([learned, failed, _], tripped) = distances(None);
    assert!(tripped && learned < 1e-9 && failed > fed_back);
    let ([still, guarded, again], tripped) = distances(Some(4.0));
    assert!(tripped && still == learned && again < 1e-9);
    approx::assert_abs_diff_eq!(guarded, fed_back, epsilon = 1e-9);
}
