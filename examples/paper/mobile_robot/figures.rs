//! The paper's eight figures: where the robot went, how far off it was, and who steered it.

use std::path::Path;

use brunovsky::trajectory::Trajectory;
use plotters::style::RGBColor;

use super::{
    ON_TRACK, Path2, Sample, YAW_RATE_LIMIT,
    data::{Row, rows},
};
use crate::plot::{BLACK, BLUE, GREY, Line, Pose, VERMILION, close_up, in_plane, over_time};

fn line<'a>(label: &'a str, colour: RGBColor, rows: &[Row], f: impl Fn(&Row) -> f64) -> Line<'a> {
    Line::new(label, colour, rows.iter().map(|row| (row.t, f(row))).collect())
}

/// A pose every `samples` samples.
fn poses(rows: &[Row], samples: usize, colour: RGBColor) -> impl Iterator<Item = Pose> {
    let pose = move |row: &Row| Pose { at: (row.px, row.py), heading: row.theta, colour };
    rows.iter().step_by(samples).map(pose)
}

/// Draws all eight into `out`, and a look at the corner where FLC is farthest off.
pub fn draw(out: &Path, path: &Path2, flc: &[Sample], clelc: &[Sample]) -> anyhow::Result<()> {
    let (flc, clelc) = (rows(flc)?, rows(clelc)?);
    let position = |rows: &[Row], f: fn(&Row) -> (f64, f64)| rows.iter().map(f).collect::<Vec<_>>();
    let reference = position(&clelc, |row| (row.rx, row.ry));
    let trajectory = [
        Line::new("reference", BLACK, reference).dashed(),
        Line::new("FLC", VERMILION, position(&flc, |row| (row.px, row.py))),
        Line::new("CLELC", BLUE, position(&clelc, |row| (row.px, row.py))),
    ];
    let robots = |samples| -> Vec<Pose> {
        poses(&flc, samples, VERMILION).chain(poses(&clelc, samples, BLUE)).collect()
    };
    let (start, end) = (path.position(0.0), path.position(path.duration()));
    let marks = [("start", (start[0], start[1])), ("end", (end[0], end[1]))];
    in_plane(&out.join("trajectory.svg"), &trajectory, &robots(100), &marks)?;
    let on_track = flc.iter().filter(|row| row.t >= ON_TRACK);
    if let Some(worst) = on_track.max_by(|a, b| a.error_true.total_cmp(&b.error_true)) {
        let file = out.join("corner.svg");
        close_up(&file, &trajectory, &robots(10), (worst.rx, worst.ry), 1.5)?;
    }

    let time = 0.0..path.duration();
    let figure = |name: &str, label: &str, range, lines: &[Line]| {
        over_time(&out.join(name), label, time.clone(), range, lines)
    };
    let both =
        |f: fn(&Row) -> f64| [line("FLC", VERMILION, &flc, f), line("CLELC", BLUE, &clelc, f)];
    figure("error.svg", "Euclidean error in m", 0.0..0.5, &both(|row| row.error))?;
    figure(
        "heading_error.svg",
        "heading error in rad",
        -0.2..0.2,
        &both(|row| row.theta_r - row.theta),
    )?;
    let [flc_heading, clelc_heading] = both(|row| row.theta);
    let reference = line("reference", BLACK, &clelc, |row| row.theta_r).dashed();
    figure("heading.svg", "heading in rad", -1.6..2.4, &[flc_heading, clelc_heading, reference])?;

    let shares = |b: fn(&Row) -> f64, n: fn(&Row) -> f64| {
        [line("learned u_n", BLUE, &clelc, n), line("feedback u_b", VERMILION, &clelc, b)]
    };
    figure("u1.svg", "u1 of CLELC in m/s²", -0.05..0.05, &shares(|row| row.u1_b, |row| row.u1_n))?;
    figure("u2.svg", "u2 of CLELC in m/s²", -0.05..0.05, &shares(|row| row.u2_b, |row| row.u2_n))?;
    let speeds = [
        line("commanded", GREY, &clelc, |row| row.v_cmd),
        line("over ground", BLUE, &clelc, |row| row.v),
        line("reference", BLACK, &clelc, |row| row.v_r).dashed(),
    ];
    figure("speed.svg", "speed of CLELC in m/s", 0.3..0.6, &speeds)?;
    let yaw_rates = [
        line("commanded", GREY, &clelc, |row| row.omega_cmd),
        line("of the body", BLUE, &clelc, |row| row.omega),
        line("reference", BLACK, &clelc, |row| row.omega_r).dashed(),
    ];
    let range = -1.3 * YAW_RATE_LIMIT..1.3 * YAW_RATE_LIMIT;
    figure("yaw_rate.svg", "yaw rate of CLELC in rad/s", range, &yaw_rates)
}
