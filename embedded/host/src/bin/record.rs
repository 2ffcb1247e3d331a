//! Makes the recordings: both studies in closed loop, the robot on slipping ground; into the folder named on the command line.

use std::{env, fs, path::Path};

use anyhow::Context;
use brunovsky::{
    nalgebra::SVector,
    plant::{ThirdOrder, TrackedRobot, Traction},
    prelude::*,
    trajectory::{FigureEight, Trajectory},
};
use replay::{Real, Robot, Study, ThirdOrderLoop};

/// Drives `plant` by the study's controller over `samples` periods of `h`: the rows that the controller saw. `row` is what it sees of t and x,
/// `input` what the plant receives.
fn record<S: Study, P, const NX: usize, const NU: usize>(
    plant: &P,
    mut x: SVector<Real, NX>,
    h: Real,
    samples: u16,
    row: impl Fn(Real, &SVector<Real, NX>) -> S::Row,
    input: impl Fn(S::Shown) -> SVector<Real, NU>,
) -> Result<Vec<u8>, Error>
where
    P: Plant<NX, NU, Scalar = Real>,
{
    let mut study = S::start()?;
    let mut recording = Vec::new();
    for k in 0..samples {
        let t = Real::from(k) * h;
        let seen = row(t, &x);
        recording.extend(seen.as_ref().iter().flat_map(|number| number.to_le_bytes()));
        let u = input(study.update(&seen)?);
        x = Rk4.integrate(|t, x| plant.derivative(t, x, &u), t, &x, h, 10)?;
    }
    Ok(recording)
}

fn third_order() -> Result<Vec<u8>, Error> {
    let uncertainty = |t: Real, _: &_, _: &_| if t < 10.0 { 0.0 } else { 5.0 * t.sin() };
    let plant = Uncertain::matched(ThirdOrder::new(), uncertainty);
    let x0 = SVector::from([1.0, -1.0, -10.0]);
    record::<ThirdOrderLoop, _, 3, 1>(
        &plant,
        x0,
        0.01,
        2000,
        |_, x| (*x).into(),
        |[u, _, _]| SVector::from([u]),
    )
}

fn robot() -> Result<Vec<u8>, Error> {
    let ground = |x: Real, y: Real| Traction {
        longitudinal: 0.9 + 0.05 * (0.31 * x).sin(),
        yaw: 0.6 + 0.12 * (0.27 * y).cos(),
        side: 0.1,
    };
    let robot = TrackedRobot::new(0.3, ground)?;
    let eight = FigureEight::new(12.0, 6.0, 0.03)?;
    let see = |t: Real, x: &SVector<Real, 5>| {
        let [along, across]: [Reference<Real, 2>; 2] = eight.references(t);
        [
            x[0],
            x[1],
            x[2],
            x[3],
            along.r[0],
            along.r[1],
            along.r_n_dot,
            across.r[0],
            across.r[1],
            across.r_n_dot,
        ]
    };
    let x0 = SVector::from([0.0, 1.0, 0.7, 0.4, 0.0]);
    let drive = |[v, omega, ..]: [Real; 6]| SVector::from([v, omega]);
    record::<Robot, _, 5, 2>(&robot, x0, 0.2, 1050, see, drive)
}

fn main() -> anyhow::Result<()> {
    let folder = env::args().nth(1).context("name a folder for the recordings")?;
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;
    fs::write(folder.join("third_order"), third_order()?)?;
    fs::write(folder.join("robot"), robot()?)?;
    Ok(())
}
