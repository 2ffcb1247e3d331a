//! The figures of a control paper: a Van der Pol oscillator follows a sine, with feedback linearization alone and with learning.
//!
//! Writes one SVG and one PNG of every kind into `target/figures`.

use std::{fs, path::Path};

use brunovsky::{
    controller::{
        ClelcCommand,
        unicycle::{Direction, heading},
    },
    learning::AdaptationRule,
    plant::VanDerPol,
    plot::{BLACK, BLUE, Dash, Draw, Figure, Line, Stroke},
    prelude::*,
    simulation,
    trajectory::FigureEight,
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const OUT: &str = "target/figures";

type Learner<R> = NeuroFuzzy<FuzzyNetwork<f64, 2, 3>, BackwardDifference<f64>, R>;
type Loop<R> = Clelc<VanDerPol<f64>, Learner<R>, 2>;
type Sample = simulation::Sample<f64, Reference<f64, 2>, ClelcCommand<f64>, 2, 1>;

fn controller(alpha: f64) -> Result<Loop<SlidingMode<f64, Fixed>>, Error> {
    let flc = FeedbackLinearization::new(VanDerPol::new(1.0)?, Gains::from_lambda(2.0)?);
    let rule = SlidingMode::new(alpha)?.with_antecedents(Fixed);
    let network = FuzzyNetwork::evenly_spaced([1.0, 2.0])?;
    Ok(Clelc::new(flc, NeuroFuzzy::new(network, BackwardDifference::new(), rule)))
}

/// The uncertainty Δ(t), which no controller knows.
fn uncertainty(t: f64) -> f64 {
    if t < 5.0 { 0.0 } else { 4.0 * (1.3 * t).sin() }
}

/// One run from `start`, with white noise of the deviation `noise` on Δ.
fn run<R: AdaptationRule<FuzzyNetwork<f64, 2, 3>> + Clone>(
    controller: &mut Loop<R>,
    start: [f64; 2],
    period: f64,
    noise: f64,
    seed: u64,
) -> Result<Vec<Sample>, Error> {
    let gusts: Vec<f64> =
        StandardNormal.sample_iter(ChaCha8Rng::seed_from_u64(seed)).take(400).collect();
    let gust = |t: f64| gusts.get((t / 0.05) as usize).map_or(0.0, |gust| noise * gust);
    let plant =
        Uncertain::matched(VanDerPol::new(1.0)?, |t: f64, _x: &_, _u: &_| uncertainty(t) + gust(t));
    let wave = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
    Simulation::new(&plant, controller, wave, start, period)?.until(15.0)?.collect()
}

fn signal(run: &[Sample], f: impl Fn(&Sample) -> f64) -> Vec<(f64, f64)> {
    run.iter().map(|sample| (sample.t, f(sample))).collect()
}

fn save(name: &str, figure: &impl Draw) -> Result<(), brunovsky::plot::Error> {
    let file = Path::new(OUT).join(name);
    figure.save(file.with_extension("svg"))?;
    figure.save(file.with_extension("png"))
}

fn main() -> anyhow::Result<()> {
    fs::create_dir_all(OUT)?;

    // FLC is CLELC that hardly learns.
    let mut learning = controller(30.0)?;
    let untaught = *learning.compensator().network();
    let flc = run(&mut controller(1e-9)?, [1.0, 0.0], 0.01, 0.0, 0)?;
    let clelc = run(&mut learning, [1.0, 0.0], 0.01, 0.0, 0)?;

    let states = [0, 1].map(|i| {
        Figure::over_time(["position x₁", "velocity x₂ in 1/s"][i])
            .event(5.0, "Δ sets in")
            .line(Line::new("FLC", signal(&flc, |s| s.x[i])))
            .line(Line::new("CLELC", signal(&clelc, |s| s.x[i])))
            .line(Line::reference(signal(&clelc, |s| s.reference.r[i])))
    });
    save("states", &states)?;

    let shares = clelc.iter().map(|s| (s.t, s.command.u_b, s.command.u_n));
    let [signals, part] = Figure::shares("1/s²", shares, 0.5)?;
    let signals = signals.y_range(-6.0..6.0).line(
        Line::new("−Δ", signal(&clelc, |s| -uncertainty(s.t)))
            .stroke(Stroke::new(BLACK, Dash::Dashed).width(1.2)),
    );
    let shares = [signals.event(5.0, "Δ sets in"), part];
    save("shares", &shares)?;

    let free = VanDerPol::new(1.0)?;
    let field = |x, y| {
        let rate = free.derivative(0.0, &SVector::from([x, y]), &SVector::zeros());
        (rate[0], rate[1])
    };
    let mut portrait = Figure::phase_plane("x₁", "x₂ in 1/s").field(-3.0..3.0, -4.0..4.0, field);
    for (name, start) in [("from inside", [0.1, 0.0]), ("from outside", [-2.8, 3.5])] {
        let mut x = SVector::from(start);
        let mut points = vec![(x[0], x[1])];
        for _ in 0..1500 {
            x = Rk4.integrate(|t, x| free.derivative(t, x, &SVector::zeros()), 0.0, &x, 0.01, 1)?;
            points.push((x[0], x[1]));
        }
        portrait = portrait.path(Line::new(name, points));
    }
    save("phase_plane", &portrait)?;

    let rule = SlidingMode::new(30.0)?;
    let learner = NeuroFuzzy::new(untaught, BackwardDifference::new(), rule);
    let base = *learning.base();
    let mut flowing = Clelc::new(base, learner);
    run(&mut flowing, [1.0, 0.0], 0.01, 0.0, 0)?;
    let memberships =
        Figure::memberships("error e₂ in 1/s", &untaught, flowing.compensator().network(), 1)?;
    save("memberships", &memberships)?;

    let mut ensemble = Figure::over_time("error e₁").event(5.0, "Δ sets in");
    for (name, alpha) in [("FLC", 1e-9), ("CLELC", 30.0)] {
        let runs = (0..40).map(|seed| run(&mut controller(alpha)?, [1.0, 0.0], 0.01, 8.0, seed));
        let runs = runs.collect::<Result<Vec<_>, _>>()?;
        let errors = |run: &Vec<Sample>| run.iter().map(|s| s.reference.r[0] - s.x[0]).collect();
        let errors: Vec<Vec<f64>> = runs.iter().map(errors).collect();
        let times: Vec<f64> = clelc.iter().map(|s| s.t).collect();
        ensemble = ensemble.spread(name, &times, &errors, [0.05, 0.95])?;
    }
    save("ensemble", &ensemble)?;

    let eight = FigureEight::new(4.0, 2.0, 0.2)?;
    let lap = |scale: f64| {
        (0..=400).map(move |k| eight.position(f64::from(k) * 0.06) * scale).map(|r| (r[0], r[1]))
    };
    let mut plane =
        Figure::in_plane().line(Line::reference(lap(1.0))).path(Line::new("robot", lap(0.94)));
    for k in 0..6 {
        let t = f64::from(k) * 4.4;
        let at = eight.position(t) * 0.94;
        let theta = heading(&eight.references(t), Direction::Forward)?;
        plane = plane.vehicle((at[0], at[1]), theta, BLUE);
    }
    let plane = plane.point((0.0, 0.0), "crossing");
    save("in_plane", &plane)?;

    // The explicit sign chatters where αh/δ > 2.
    let delta = 0.5;
    let alphas: Vec<f64> = (1..=40).map(|i| 2.5 * f64::from(i)).collect();
    let periods: Vec<f64> = (1..=30).map(|i| 0.002 * f64::from(i)).collect();
    let variation = |alpha, period| -> Result<f64, Error> {
        let rule = SlidingMode::new(alpha)?.with_switching(Switching::Explicit { delta })?;
        let network = FuzzyNetwork::evenly_spaced([1.0, 2.0])?;
        let learner = NeuroFuzzy::new(network, BackwardDifference::new(), rule);
        let samples = run(&mut Clelc::new(base, learner), [1.0, 0.0], period, 0.0, 0)?;
        let steady = samples.iter().filter(|s| s.t > 10.0).map(|s| s.command.u_n);
        Ok(TotalVariation::of(steady)? / 5.0)
    };
    let map = Figure::heat_map(
        ["learning rate α in 1/s³", "period h in s", "log₁₀ of the variation of u_n in 1/s³"],
        &alphas,
        &periods,
        |alpha, period| variation(alpha, period).unwrap_or(f64::NAN).log10(),
    )?
    .line(
        Line::new("αh = 2δ", alphas.iter().map(|alpha| (*alpha, 2.0 * delta / alpha)))
            .stroke(Stroke::new(BLACK, Dash::Dashed)),
    );
    save("heat_map", &map)?;
    println!("The figures are in {OUT}.");
    Ok(())
}
