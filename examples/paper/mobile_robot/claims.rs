//! What the paper says about its robot, claim by claim.

use super::{
    DELTA, EXPERIMENT, Path2, SPEED, Sample, YAW_RATE_LIMIT,
    data::{Row, rows},
    merits::mean_on_track,
    tables::Settings,
};
use crate::claims::Claim;

/// The paper's mean Euclidean errors on track, in m: FLC, CLELC, and its earlier controllers on the same robot.
const FLC: f64 = 0.12;
const CLELC: f64 = 0.03;
const NMPC_WITH_TRACTION: f64 = 0.04;
/// "Approximately": half of the last digit given.
const MARGIN: f64 = 0.01;
/// What counts as zero, as a share of what it is compared with.
const BAND: f64 = 0.02;

fn claim(
    what: impl Into<String>,
    paper: impl Into<String>,
    measured: String,
    borne_out: bool,
) -> Claim {
    Claim::new(EXPERIMENT, what, paper, measured, borne_out)
}

/// Judges the paper's claims: errors over all seeds, the rest by the runs that are drawn.
pub fn judge(
    flc: &[Sample],
    clelc: &[Sample],
    path: &Path2,
    settings: &Settings,
) -> anyhow::Result<Vec<Claim>> {
    let mut claims = errors(settings);
    let (flc, clelc) = (rows(flc)?, rows(clelc)?);
    let heading = |rows: &[Row]| mean_on_track(rows, |row| (row.theta_r - row.theta).abs());
    let speed = mean_on_track(&clelc, |row| row.v);
    let fastest = clelc.iter().map(|row| row.omega_cmd.abs()).fold(0.0, f64::max);
    claims.push(claim(
        "heading error",
        "CLELC tracks the heading accurately: closer than FLC",
        format!("mean |θ_r - θ|: CLELC {:.4} rad, FLC {:.4} rad", heading(&clelc), heading(&flc)),
        heading(&clelc) < heading(&flc),
    ));
    for (axis, feedback, learned) in [
        (
            "u1",
            (|row: &Row| row.u1_b) as fn(&Row) -> f64,
            (|row: &Row| row.u1_n) as fn(&Row) -> f64,
        ),
        ("u2", |row| row.u2_b, |row| row.u2_n),
    ] {
        let feedback = mean_on_track(&clelc, |row| feedback(row).abs());
        let learned = mean_on_track(&clelc, |row| learned(row).abs());
        let measured = format!("mean |u_b| = {feedback:.4}, mean |u_n| = {learned:.4} m/s²");
        claims.push(claim(
            format!("the learned term leads in {axis}"),
            "|u_n| larger than |u_b|",
            measured.clone(),
            learned > feedback,
        ));
        claims.push(claim(
            format!("the feedback in {axis} converges to zero"),
            "|u_b| = 0, to 2 % of |u_n|",
            measured,
            feedback <= BAND * learned,
        ));
    }
    claims.push(claim(
        "linear velocity",
        "changes around the constant reference",
        format!("mean over ground {speed:.4} m/s, reference {SPEED} m/s"),
        (speed - SPEED).abs() <= BAND * SPEED,
    ));
    claims.push(claim(
        "angular velocity",
        format!("limited to ±{YAW_RATE_LIMIT} rad/s"),
        format!("max |ω| commanded = {fastest:.4} rad/s over {:.0} s", path.duration()),
        fastest <= YAW_RATE_LIMIT,
    ));
    Ok(claims)
}

fn errors(settings: &Settings) -> Vec<Claim> {
    let Settings { flc, explicit, paper, recommended, .. } = settings;
    vec![
        claim(
            "mean Euclidean error of FLC",
            format!("{FLC} m (the ground is calibrated to this)"),
            format!("{:.4} m", flc.error),
            (flc.error - FLC).abs() <= MARGIN,
        ),
        claim(
            format!("mean Euclidean error of CLELC, δ = {DELTA}, implicit sign"),
            format!("{CLELC} m"),
            format!("{:.4} m, {} runs diverged", paper.error, paper.diverged),
            paper.diverged == 0 && paper.error <= CLELC,
        ),
        claim(
            "mean Euclidean error of CLELC, recommended settings",
            format!("{CLELC} m"),
            format!("{:.4} m, {} runs diverged", recommended.error, recommended.diverged),
            recommended.diverged == 0 && recommended.error <= CLELC,
        ),
        claim(
            format!("mean Euclidean error of CLELC, δ = {DELTA}, the paper's explicit sign"),
            format!("{CLELC} m"),
            format!("{:.4} m, {} runs diverged", explicit.error, explicit.diverged),
            explicit.diverged == 0 && explicit.error <= CLELC,
        ),
        claim(
            "CLELC beside predictive control on the same robot",
            format!("more accurate than NMPC with estimated traction, {NMPC_WITH_TRACTION} m"),
            format!("{:.4} m", paper.error),
            paper.error < NMPC_WITH_TRACTION,
        ),
    ]
}
