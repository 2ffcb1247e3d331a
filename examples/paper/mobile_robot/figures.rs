//! The paper's eight figures: where the robot went, how far off it was, and who steered it.

use std::path::Path;

use brunovsky::plot::{BLUE, Dash, Draw, Figure, GREY, Line, ORANGE, Stroke, VERMILION};

use super::{
    ON_TRACK, Path2, Sample, YAW_RATE_LIMIT,
    data::{Row, rows},
};

const FLC: Stroke = Stroke::new(VERMILION, Dash::Dashed);
const CLELC: Stroke = Stroke::new(BLUE, Dash::Solid);
/// Noise has no room for dashes.
const NOISY_FLC: Stroke = Stroke::new(VERMILION, Dash::Solid).width(1.0);
const NOISY_CLELC: Stroke = Stroke::new(BLUE, Dash::Solid).width(1.0);
const FEEDBACK: Stroke = Stroke::new(ORANGE, Dash::Solid).width(1.0);
const COMMAND: Stroke = Stroke::new(GREY, Dash::Solid).width(1.0);

fn line(label: &str, stroke: Stroke, rows: &[Row], f: impl Fn(&Row) -> f64) -> Line {
    Line::new(label, rows.iter().map(|row| (row.t, f(row)))).stroke(stroke)
}

/// Draws all eight into `out`, and a look at the corner where FLC is farthest off.
pub fn draw(out: &Path, path: &Path2, flc: &[Sample], clelc: &[Sample]) -> anyhow::Result<()> {
    let (flc, clelc) = (rows(flc)?, rows(clelc)?);
    let route =
        |label: &str, rows: &[Row]| Line::new(label, rows.iter().map(|row| (row.px, row.py)));
    let routes = [route("FLC", &flc).stroke(FLC), route("CLELC", &clelc).stroke(CLELC)];
    let trajectory = |samples: usize, route: fn(Figure, Line) -> Figure| {
        let reference = Line::reference(clelc.iter().map(|row| (row.rx, row.ry)));
        let figure = routes.iter().cloned().fold(Figure::in_plane().line(reference), route);
        [(&flc, FLC), (&clelc, CLELC)].into_iter().fold(figure, |figure, (rows, stroke)| {
            rows.iter().step_by(samples).skip(1).fold(figure, |figure, row| {
                figure.vehicle((row.px, row.py), row.theta, stroke.colour)
            })
        })
    };
    trajectory(100, Figure::path).save(out.join("trajectory.svg"))?;
    let on_track = flc.iter().filter(|row| row.t >= ON_TRACK);
    if let Some(worst) = on_track.max_by(|a, b| a.error_true.total_cmp(&b.error_true)) {
        trajectory(10, Figure::line)
            .size(440.0, 400.0)?
            .close_up((worst.rx, worst.ry), 1.5)
            .save(out.join("corner.svg"))?;
    }

    let figure = |name: &str, label: &str, range, lines: &[Line]| {
        let figure = Figure::over_time(label).x_range(0.0..path.duration()).y_range(range);
        lines.iter().cloned().fold(figure, Figure::line).save(out.join(name))
    };
    let errors = [
        line("FLC", NOISY_FLC, &flc, |row| row.error),
        line("CLELC", NOISY_CLELC, &clelc, |row| row.error),
    ];
    figure("error.svg", "Euclidean error in m", 0.0..0.5, &errors)?;
    let both = |f: fn(&Row) -> f64| [line("FLC", FLC, &flc, f), line("CLELC", CLELC, &clelc, f)];
    let heading_error = both(|row| row.theta_r - row.theta);
    figure("heading_error.svg", "heading error in rad", -0.2..0.2, &heading_error)?;
    let reference = |f: fn(&Row) -> f64| Line::reference(clelc.iter().map(|row| (row.t, f(row))));
    let [flc_heading, clelc_heading] = both(|row| row.theta);
    let headings = [flc_heading, clelc_heading, reference(|row| row.theta_r)];
    figure("heading.svg", "heading in rad", -1.6..2.4, &headings)?;

    let shares = |b: fn(&Row) -> f64, n: fn(&Row) -> f64| {
        [line("learned u_n", NOISY_CLELC, &clelc, n), line("feedback u_b", FEEDBACK, &clelc, b)]
    };
    let u1 = shares(|row| row.u1_b, |row| row.u1_n);
    figure("u1.svg", "u₁ of CLELC in m/s²", -0.05..0.05, &u1)?;
    let u2 = shares(|row| row.u2_b, |row| row.u2_n);
    figure("u2.svg", "u₂ of CLELC in m/s²", -0.05..0.05, &u2)?;
    let speeds = [
        line("commanded", COMMAND, &clelc, |row| row.v_cmd),
        line("over ground", CLELC, &clelc, |row| row.v),
        reference(|row| row.v_r),
    ];
    figure("speed.svg", "speed of CLELC in m/s", 0.3..0.6, &speeds)?;
    let yaw_rates = [
        line("commanded", COMMAND, &clelc, |row| row.omega_cmd),
        line("of the body", CLELC, &clelc, |row| row.omega),
        reference(|row| row.omega_r),
    ];
    let range = -1.3 * YAW_RATE_LIMIT..1.3 * YAW_RATE_LIMIT;
    figure("yaw_rate.svg", "yaw rate of CLELC in rad/s", range, &yaw_rates)?;
    Ok(())
}
