//! Where the sign of the learning rule chatters: a sweep over αh/δ and the noise of ẋ, with the explicit and with the implicit sign.
//!
//! Near s = 0 an explicit step of u̇_n = α·s/(|s| + δ) is s⁺ = (1 − αh/δ)·s, so theory puts the border at αh/δ = 2; beyond it s jumps between
//! ±(αh/2 − δ). The implicit sign has no border. A wide boundary layer leaves δ·B/(α − B) of s; noise adds to both.

use std::{fs, path::PathBuf};

use brunovsky::{
    ensemble::{Axis, Design, Map, Run, Sweep},
    plant::{Pendulum, Uncertain},
    plot::{BLACK, Dash, Draw, Figure, Line, Stroke},
    prelude::*,
};
use clap::Parser;
use rand_distr::{Distribution, StandardNormal};

/// Maps the closed-loop error s over αh/δ and noise.
#[derive(Parser)]
struct Arguments {
    /// Levels of αh/δ.
    #[arg(long, default_value_t = 25)]
    ratios: u32,
    /// Levels of the noise.
    #[arg(long, default_value_t = 13)]
    noises: u32,
    /// Runs at each point, with different noise.
    #[arg(long, default_value_t = 2)]
    replicas: u64,
    /// Where to write the data and the picture.
    #[arg(long, default_value = "target/stability_map")]
    out: PathBuf,
}

const ALPHA: f64 = 25.0;
const PERIOD: f64 = 0.01;
/// How far u_n can move in a period: the unit of s and of its noise here.
const REACH: f64 = ALPHA * PERIOD;

/// The torque that the controller does not know, as an acceleration in rad/s²: |Δ̇| ≤ B = 1 rad/s³.
fn delta(t: f64) -> f64 {
    t.sin()
}

/// The RMS of s = −(u_n + Δ) over the last five of ten seconds, by αh.
fn rms(switching: Switching<f64>, noise: f64, mut run: Run) -> Result<f64, Error> {
    let model = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
    let plant = Uncertain::matched(model, |t: f64, _x: &_, _u: &_| delta(t));
    let flc = FeedbackLinearization::new(model, Gains::from_lambda(3.0)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([1.0, 1.0])?;
    let rule = SlidingMode::new(ALPHA)?.with_switching(switching)?;
    let mut clelc = Clelc::new(flc, NeuroFuzzy::new(network, Measured, rule));

    let (mut x, mut u) = (SVector::from([0.0, 0.0]), SVector::from([0.0]));
    let mut metrics = ErrorMetrics::default();
    for k in 0..=1000 {
        let t = f64::from(k) * PERIOD;
        let mut rate = plant.derivative(t, &x, &u);
        let white: f64 = StandardNormal.sample(&mut run);
        rate[1] += noise * REACH * white;
        let seen = Measurement::new(x).with_rate(rate).with_applied(u);
        let command = clelc.update(&seen, &Reference::setpoint(0.5), PERIOD)?;
        if t >= 5.0 {
            metrics.push(t, (command.u_n + delta(t)) / REACH)?;
        }
        u = command.input();
        x = Rk4.integrate(|t, x| plant.derivative(t, x, &u), t, &x, PERIOD, 2)?;
    }
    metrics.rms().ok_or(Error::Missing { name: "second sample" })
}

fn map(
    design: &Design<2>,
    replicas: u64,
    switching: fn(f64) -> Switching<f64>,
) -> Result<Map<2, 1>, Error> {
    let names = ["RMS of s by αh"];
    let sweep = Sweep::new(design.clone(), replicas, 0, names, |[noise, ratio], run| {
        Ok::<_, Error>([rms(switching(REACH / ratio), noise, run)?])
    })?;
    Ok(sweep.with_progress().map())
}

/// The mean over the replicas, with the quietest noise, at the level of αh/δ that is nearest to `ratio`.
fn quiet(map: &Map<2, 1>, ratio: f64) -> Result<(f64, f64), Error> {
    let distance = |at: f64| (at / ratio).ln().abs();
    let quietest = map.cells().map(|([noise, _], _)| *noise).fold(f64::INFINITY, f64::min);
    let row = map.cells().filter(|([noise, _], _)| *noise == quietest);
    let nearest = row.min_by(|(a, _), (b, _)| distance(a[1]).total_cmp(&distance(b[1])));
    let ([_, at], runs) = nearest.ok_or(Error::Missing { name: "cell" })?;
    let [rms] = runs.summaries(0.95)?;
    Ok((*at, rms.mean()?.value))
}

fn main() -> anyhow::Result<()> {
    let Arguments { ratios, noises, replicas, out } = Arguments::parse();
    fs::create_dir_all(&out)?;
    let noise = Axis::logarithmic("noise of the rate by αh", 0.01, 1.0)?.levels(noises)?;
    let ratio = Axis::logarithmic("αh/δ", 0.25, 16.0)?.levels(ratios)?;
    let design = Design::grid([noise.clone(), ratio.clone()]);
    let explicit = map(&design, replicas, |delta| Switching::Explicit { delta })?;
    let implicit = map(&design, replicas, |delta| Switching::Implicit { delta })?;

    println!(
        "RMS of s by αh, with noise of 0.01·αh; theory: the explicit sign jumps by 1/2 − δ/(αh) beyond αh/δ = 2\n"
    );
    println!("    αh/δ   explicit   implicit   theory");
    for ratio in [0.25, 0.5, 1.0, 2.0, 2.83, 4.0, 8.0, 16.0] {
        let ((ratio, explicit), (_, implicit)) =
            (quiet(&explicit, ratio)?, quiet(&implicit, ratio)?);
        let theory = (0.5 - 1.0 / ratio).max(0.0);
        println!("{ratio:8.2} {explicit:10.3} {implicit:10.3} {theory:8.3}");
    }
    for (name, map) in [("explicit", &explicit), ("implicit", &implicit)] {
        map.write_csv(fs::File::create(out.join(name).with_extension("csv"))?, 0.95)?;
        drawn(map, ratio.values(), noise.values())?.save(out.join(name).with_extension("svg"))?;
    }
    println!("\nData and pictures are in {}.", out.display());
    Ok(())
}

/// The mean of every cell as a colour, and the border of theory.
fn drawn(map: &Map<2, 1>, ratios: &[f64], noises: &[f64]) -> Result<Figure, Error> {
    let (x, y) = (logarithms(ratios), logarithms(noises));
    let value = |x: f64, y: f64| {
        let cell = map.cells().find(|([noise, ratio], _)| [ratio.log10(), noise.log10()] == [x, y]);
        cell.and_then(|(_, runs)| mean(runs).ok()).unwrap_or(f64::NAN)
    };
    let labels = ["log₁₀ αh/δ", "log₁₀ of the noise of the rate by αh", "RMS of s by αh"];
    let border = [(2.0_f64.log10(), y[0]), (2.0_f64.log10(), y[y.len() - 1])];
    let border = Line::new("αh/δ = 2", border).stroke(Stroke::new(BLACK, Dash::Dashed));
    Ok(Figure::heat_map(labels, &x, &y, value)?.colour_range(0.0..0.5)?.line(border))
}

fn logarithms(values: &[f64]) -> Vec<f64> {
    values.iter().map(|value| value.log10()).collect()
}

fn mean(runs: &brunovsky::ensemble::Runs<1>) -> Result<f64, Error> {
    let [rms] = runs.summaries(0.95)?;
    Ok(rms.mean()?.value)
}
