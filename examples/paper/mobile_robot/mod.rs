//! The robot study: a tracked robot on slipping ground follows a path under the limits of its drives.
//!
//! The robot of the paper and its field are not to be had; the plant is a simulated one whose motion differs from the unicycle that
//! the controller knows by traction, side slip and drive lag, and whose sensors are noisy.

use std::{fs, path::Path};

use brunovsky::{
    channel::{Ideal, Saturation},
    controller::{
        ChainControllers, ClelcCommand, Limited, LimitedCommand,
        unicycle::{Direction, Standstill, UnicycleCommand, UnicycleController},
    },
    learning::{AdaptationRule, Compensator, ErrorRate},
    plant::{IntegratorChain, TrackedRobot},
    prelude::*,
    simulation::{self, Hardware},
    trajectory::{ConstantSpeed, Trajectory},
};

use crate::claims::Claim;

mod claims;
mod data;
mod figures;
mod ground;
mod merits;
mod random;
mod sensors;
mod tables;

use ground::{GROUND, Ground};
pub use random::run as run_random;
use sensors::Accuracy;

const EXPERIMENT: &str = "mobile-robot";
const LAMBDA: f64 = 0.3;
const ALPHA: f64 = 5.0;
/// The paper's boundary layer.
const DELTA: f64 = 0.05;
/// The boundary layer that the noise of this robot's speed asks for: a difference of it over one period has a standard deviation of
/// √2·0.01 m/s / 0.2 s = 0.07 m/s², and αh/(αh + δ) of each s is learned at once.
const RECOMMENDED_DELTA: f64 = 2.0;
const PERIOD: f64 = 0.2;
const SPEED: f64 = 0.4;
const YAW_RATE: f64 = 0.035;
const YAW_RATE_LIMIT: f64 = 0.1;
const SEEDS: u64 = 20;
/// From here on the robot counts as on track: twelve time constants 1/λ after its start beside the path.
const ON_TRACK: f64 = 40.0;
/// How far beside the path the robot starts, in m.
const OFFSET: f64 = 1.0;

type Path2 = ConstantSpeed<f64, 2, 9>;
type Axes = [ClelcCommand<f64>; 2];
type Decided = LimitedCommand<UnicycleCommand<f64, Axes>, f64, 2>;
type Sample =
    simulation::Sample<f64, [Reference<f64, 2>; 2], Decided, 5, 2, Measurement<f64, 4, 2>>;

/// Straight, a left turn, a right turn, a left turn, straight: scaled until its sharpest turn needs `yaw_rate` in rad/s.
fn path(yaw_rate: f64) -> Result<Path2, Error> {
    let shape = [
        [0.0, 0.0],
        [12.0, 0.0],
        [22.0, 5.0],
        [26.0, 16.0],
        [36.0, 24.0],
        [47.0, 18.0],
        [50.0, 6.0],
        [60.0, 0.0],
        [72.0, 0.0],
    ];
    let plain = ConstantSpeed::new(shape, SPEED)?;
    let sharpest = plain.limits(0.0, plain.duration())?.yaw_rate;
    let scale = sharpest.ok_or(Error::Missing { name: "yaw rate of the path" })? / yaw_rate;
    ConstantSpeed::new(shape.map(|point| point.map(|p| p * scale)), SPEED)
}

/// CLELC with `compensator` on the chain of one axis.
fn axis<C: Compensator<f64, 2>>(
    compensator: C,
) -> Result<Clelc<IntegratorChain<f64, 2>, C, 2>, Error> {
    let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(LAMBDA)?);
    Ok(Clelc::new(flc, compensator))
}

/// Feedback linearization alone, with s on record.
fn flc() -> Result<impl ChainControllers<f64, 2, 2, Commands = Axes> + Copy + Send + Sync, Error> {
    let axis = axis(NullCompensator::new(BackwardDifference::new()))?;
    Ok([axis; 2])
}

/// CLELC on both axes.
fn clelc<E, R>(
    error_rate: E,
    rule: R,
) -> Result<impl ChainControllers<f64, 2, 2, Commands = Axes> + Copy + Send + Sync, Error>
where
    E: ErrorRate<f64, 2> + Copy + Send + Sync,
    R: AdaptationRule<FuzzyNetwork<f64, 2, 3>> + Copy + Send + Sync,
{
    let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([2.0 * OFFSET, SPEED])?;
    let axis = axis(NeuroFuzzy::new(network, error_rate, rule))?;
    Ok([axis; 2])
}

/// The sliding-mode rule with the paper's α.
fn rule(switching: Switching<f64>) -> Result<SlidingMode<f64>, Error> {
    SlidingMode::new(ALPHA)?.with_switching(switching)
}

/// What a run is made under, beside its path and its noise.
#[derive(Clone, Copy)]
struct Field {
    ground: Ground,
    accuracy: Accuracy,
    /// The limit on |ω| in rad/s.
    limit: f64,
    /// How far beside the path the robot starts, in m.
    offset: f64,
}

/// The study's own.
fn field() -> Field {
    let accuracy = Accuracy::rtk(0.04);
    Field { ground: GROUND, accuracy, limit: YAW_RATE_LIMIT, offset: OFFSET }
}

/// One run along `path` with the noise of `seed` and the controllers `axes`.
fn simulate(
    axes: impl ChainControllers<f64, 2, 2, Commands = Axes>,
    path: &Path2,
    field: Field,
    seed: u64,
) -> Result<Vec<Sample>, Error> {
    let robot = TrackedRobot::new(0.3, |x, y| field.ground.traction(x, y))?;
    let controller = UnicycleController::new(axes, Direction::Forward, 0.05, Standstill::Hold)?;
    let limits = Saturation::new([0.0, -field.limit], [2.0 * SPEED, field.limit])?;
    let limited = Limited::new(controller, limits);
    let hardware = Hardware::new(field.accuracy.sensors(seed)?, Ideal);
    let start = [0.0, field.offset, 0.0, SPEED, 0.0];
    Simulation::with_hardware(&robot, hardware, limited, |t| path.references(t), start, PERIOD)?
        .until(path.duration())?
        .collect()
}

/// Runs the study, prints its tables, writes data and figures into `out`.
pub fn run(out: &Path) -> anyhow::Result<Vec<Claim>> {
    fs::create_dir_all(out)?;
    let path = path(YAW_RATE)?;
    let field = field();
    let recommended = rule(Switching::Implicit { delta: RECOMMENDED_DELTA })?;
    let flc = simulate(flc()?, &path, field, 0)?;
    let clelc = simulate(clelc(ModelAided::new(), recommended)?, &path, field, 0)?;
    for (name, run) in [("flc", &flc), ("clelc", &clelc)] {
        data::write(&out.join(name).with_extension("csv"), run)?;
    }
    figures::draw(out, &path, &flc, &clelc)?;
    let settings = tables::settings(&path, field)?;
    println!(
        "Mobile robot, h = {PERIOD} s, mean over {SEEDS} seeds, on track from {ON_TRACK} s on\n"
    );
    println!("{}\n", tables::of_settings(&settings));
    println!(
        "Policies against windup: true error in m and share of time with ω limited, or how many runs diverged\n"
    );
    println!("{}\n", tables::policies(&path, field)?);
    claims::judge(&flc, &clelc, &path, &settings)
}
