//! Pendulums of random mass and friction, from random starts, with a noisy rate: feedback linearization alone and with learning, many times.
//!
//! Each run draws a pendulum, a start and noise from its own random numbers, and puts both controllers on them. Run i is the same on any number
//! of threads and alone, so the worst of many can be looked at again.

use brunovsky::{
    ensemble::{Ensemble, Estimate, Run, rand::RngExt},
    plant::Pendulum,
    prelude::*,
};
use clap::Parser;
use rand_distr::{Distribution, Normal};

/// Runs FLC and CLELC on random pendulums.
#[derive(Parser)]
struct Arguments {
    /// How many pendulums.
    #[arg(long, default_value_t = 200)]
    runs: u64,
    /// Which ones: another seed, other pendulums.
    #[arg(long, default_value_t = 7)]
    seed: u64,
}

/// The error in rad at the samples of a run that settles in the first of its four seconds; `run` makes the noise of the rate.
fn errors(
    mut controller: impl Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>>,
    pendulum: &Pendulum<f64>,
    start: [f64; 2],
    mut run: Run,
) -> Result<Vec<(f64, f64)>, Error> {
    const DT: f64 = 0.005;
    let noise = Normal::new(0.0, 0.002).map_err(|_| Error::Missing { name: "deviation" })?;
    let reference = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
    let mut x = SVector::from(start);
    let mut errors = Vec::new();
    for k in 0..=800 {
        let t = f64::from(k) * DT;
        let seen = Measurement::new([x[0], x[1] + noise.sample(&mut run)]);
        let u = controller.update(&seen, &reference(t), DT)?.input();
        errors.push((t, t.sin() - x[0]));
        x = Rk4.integrate(|t, x| pendulum.derivative(t, x, &u), t, &x, DT, 4)?;
    }
    Ok(errors)
}

/// The RMS of the error after the first second; a pendulum that is ever more than half a turn off is lost.
fn figure(errors: &[(f64, f64)]) -> Result<f64, Error> {
    let farthest = errors.iter().map(|(_, e)| e.abs()).fold(0.0, f64::max);
    if farthest > core::f64::consts::PI {
        let limit = core::f64::consts::PI;
        return Err(Error::NotBelow { name: "error in rad", value: farthest, limit });
    }
    let settled = errors.iter().copied().filter(|(t, _)| *t >= 1.0);
    ErrorMetrics::of(settled)?.rms().ok_or(Error::Missing { name: "second sample" })
}

/// One run: the errors under FLC and under CLELC, on the same pendulum with the same noise.
fn experiment(mut run: Run) -> Result<[Vec<(f64, f64)>; 2], Error> {
    let believed = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
    let mass = run.random_range(0.5..2.0);
    let friction = run.random_range(0.0..0.3);
    let pendulum = Pendulum::new(mass, 0.5, friction, 9.81)?;
    let start = [run.random_range(-1.0..1.0), run.random_range(-1.0..1.0)];

    let flc = FeedbackLinearization::new(believed, Gains::from_lambda(4.0)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([2.0, 4.0])?;
    let rule = SlidingMode::new(200.0)?.with_switching(Switching::Implicit { delta: 2.0 })?;
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));
    Ok([errors(flc, &pendulum, start, run.clone())?, errors(clelc, &pendulum, start, run)?])
}

fn main() -> Result<(), Error> {
    let Arguments { runs, seed } = Arguments::parse();
    let names = ["RMS under FLC in rad", "RMS under CLELC in rad"];
    let ensemble = Ensemble::new(seed, names, |run| {
        let [flc, clelc] = experiment(run)?;
        Ok::<_, Error>([figure(&flc)?, figure(&clelc)?])
    });
    let results = ensemble.with_progress().runs(runs);

    println!("{runs} pendulums, seed {seed}; in brackets 95 % confidence intervals\n");
    println!(
        "                        mean                     median                   95 % quantile            worst"
    );
    let estimate = |estimate: Estimate| format!("{estimate:.4}");
    for (name, rms) in names.iter().zip(results.summaries(0.95)?) {
        let [mean, median, tail] =
            [rms.mean()?, rms.quantile(0.5)?, rms.quantile(0.95)?].map(estimate);
        let worst = rms.worst().ok_or(Error::Missing { name: "completed run" })?;
        println!(
            "{name:23} {mean:24} {median:24} {tail:24} {:.4} (run {})",
            worst.value, worst.index
        );
    }
    println!("\nfailed: {:.3}", results.failure_rate(0.95)?);
    for (index, reason) in results.failures() {
        println!("  run {index}: {reason}");
    }

    let [_, clelc] = results.summaries(0.95)?;
    let worst = clelc.worst().ok_or(Error::Missing { name: "completed run" })?;
    println!("\nThe worst run of CLELC, number {}, again:\n", worst.index);
    println!("  t in s    e under FLC   e under CLELC   (in rad)");
    let [flc, clelc] = experiment(Run::new(seed, worst.index))?;
    for ((t, flc), (_, clelc)) in flc.iter().zip(&clelc).step_by(100) {
        println!("{t:8.1} {flc:14.4} {clelc:15.4}");
    }
    Ok(())
}
