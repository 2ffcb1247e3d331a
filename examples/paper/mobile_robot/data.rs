//! The CSV files of the robot study.

use std::path::Path;

use brunovsky::controller::unicycle::{
    Direction, Heading, feedforward_speed, feedforward_yaw_rate,
};
use serde::Serialize;

use super::{
    GROUND, Sample,
    merits::{error, error_true},
};

/// One control sample; `px`, `py`, `theta`, `v`, `omega` are true, `gx`, `gy` what the GNSS had.
#[derive(Serialize)]
pub struct Row {
    pub t: f64,
    pub rx: f64,
    pub ry: f64,
    pub px: f64,
    pub py: f64,
    pub gx: f64,
    pub gy: f64,
    pub theta_r: f64,
    pub theta: f64,
    pub error: f64,
    pub error_true: f64,
    pub v_r: f64,
    pub v: f64,
    pub omega_r: f64,
    pub omega: f64,
    pub v_cmd: f64,
    pub omega_cmd: f64,
    pub u1_b: f64,
    pub u1_n: f64,
    pub u2_b: f64,
    pub u2_n: f64,
}

/// The rows of a run.
pub fn rows(run: &[Sample]) -> Result<Vec<Row>, brunovsky::Error> {
    let mut heading = Heading::new(Direction::Forward);
    let row = |sample: &Sample| {
        let reference = &sample.reference;
        let traction = GROUND.traction(sample.x[0], sample.x[1]);
        let [first, second] = sample.command.asked.decoupled.chains;
        Ok(Row {
            t: sample.t,
            rx: reference[0].r[0],
            ry: reference[1].r[0],
            px: sample.x[0],
            py: sample.x[1],
            gx: sample.seen.x[0],
            gy: sample.seen.x[1],
            theta_r: heading.update(reference)?,
            theta: sample.x[2],
            error: error(sample),
            error_true: error_true(sample),
            v_r: feedforward_speed(reference, Direction::Forward),
            v: traction.longitudinal * sample.x[3],
            omega_r: feedforward_yaw_rate(reference)?,
            omega: traction.yaw * sample.x[4],
            v_cmd: sample.u[0],
            omega_cmd: sample.u[1],
            u1_b: first.u_b,
            // The null compensator answers −0, which changes no sum; +0 makes 0 of it.
            u1_n: first.u_n + 0.0,
            u2_b: second.u_b,
            u2_n: second.u_n + 0.0,
        })
    };
    run.iter().map(row).collect()
}

/// Writes a run as CSV.
pub fn write(path: &Path, run: &[Sample]) -> anyhow::Result<()> {
    let mut file = csv::Writer::from_path(path)?;
    for row in rows(run)? {
        file.serialize(row)?;
    }
    file.flush()?;
    Ok(())
}
