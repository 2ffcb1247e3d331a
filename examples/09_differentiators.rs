//! Which differentiator at which noise? Two signals whose derivatives are known, and then the loop that learns from ė_n.
//!
//! Every law is told the same: the period, the standard deviation σ of the noise, and the bound L on |ÿ|. Each turns them into its parameters
//! by its own rule (`for_noise`), or has none. The second orders are told of a bound on |y⃛| of the same size instead, which the signal "±" breaks.

use brunovsky::{
    differentiator::{Differentiator, HighGain, RobustExact, Tracking},
    learning::{ErrorRate, OfState},
    plant::ThirdOrder,
    prelude::*,
};
use comfy_table::Table;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const PERIOD: f64 = 0.01;

/// y and ẏ at time t, with |ÿ| ≤ 1.
type Signal = fn(f64) -> (f64, f64);

fn sine(t: f64) -> (f64, f64) {
    t.sin_cos()
}

/// ÿ = ±1, two seconds each: ẏ is a triangle, and y⃛ is not bounded.
fn alternating(t: f64) -> (f64, f64) {
    let (half, phase) = ((t / 2.0).floor(), t % 2.0);
    let sign = if half % 2.0 == 0.0 { 1.0 } else { -1.0 };
    (sign * phase * (phase - 2.0) / 2.0, sign * (phase - 1.0))
}

fn noise(random: &mut ChaCha8Rng, sigma: f64) -> f64 {
    let normal: f64 = StandardNormal.sample(random);
    sigma * normal
}

/// What comes out of a differentiator: RMS error, the delay that explains most of it, and total variation over that of ẏ.
fn judge(
    mut source: impl Differentiator<Scalar = f64>,
    signal: Signal,
    sigma: f64,
) -> Result<[f64; 3], Error> {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let time = |k: u32| f64::from(k) * PERIOD;
    let mut rates = Vec::new();
    for k in 0..8000 {
        let y = signal(time(k)).0 + noise(&mut random, sigma);
        rates.push((time(k), source.update(y, PERIOD)?));
    }
    // The start is no part of it.
    let late = &rates[2000..];
    let square =
        |delay: f64| late.iter().map(|(t, rate)| (rate - signal(t - delay).1).powi(2)).sum::<f64>();
    let delays = (-20..200).map(|quarter| f64::from(quarter) * PERIOD / 4.0);
    let delay = delays.min_by(|a, b| square(*a).total_cmp(&square(*b))).unwrap_or(f64::NAN);
    let variation = TotalVariation::of(late.iter().map(|(_, rate)| *rate))?;
    let least = TotalVariation::of(late.iter().map(|(t, _)| signal(*t).1))?;
    Ok([(square(0.0) / late.len() as f64).sqrt(), delay, variation / least])
}

fn signals() -> Result<(), Error> {
    let mut table = Table::new();
    table.load_preset(comfy_table::presets::ASCII_MARKDOWN);
    table.set_header([
        "σ",
        "differentiator",
        "sin t: RMS",
        "delay/h",
        "TV",
        "±: RMS",
        "delay/h",
        "TV",
    ]);
    for sigma in [1e-5, 1e-4, 1e-3, 1e-2, 1e-1] {
        let mut add = |name: &str, results: [Result<[f64; 3], Error>; 2]| -> Result<(), Error> {
            let mut row = vec![format!("{sigma}"), name.to_owned()];
            for result in results {
                let [rms, delay, variation] = result?;
                row.extend([
                    format!("{rms:.4}"),
                    format!("{:.1}", delay / PERIOD),
                    format!("{variation:.1}"),
                ]);
            }
            table.add_row(row);
            Ok(())
        };
        macro_rules! both {
            ($name:expr, $source:expr) => {{
                let source = $source;
                add($name, [judge(source.clone(), sine, sigma), judge(source, alternating, sigma)])?
            }};
        }
        both!("backward difference", BackwardDifference::new());
        both!("filtered difference", FilteredDifference::for_noise(sigma, 1.0)?);
        both!("tracking", Tracking::for_noise(sigma, 1.0, PERIOD)?);
        both!("high-gain, order 1", HighGain::<_, 2>::for_noise(sigma, 1.0, PERIOD)?);
        both!("high-gain, order 2", HighGain::<_, 3>::for_noise(sigma, 1.0, PERIOD)?);
        both!("robust exact, order 1", RobustExact::first_order(1.0)?);
        both!("robust exact, order 2", RobustExact::second_order(1.0)?);
    }
    println!(
        "RMS error of ẏ, its delay in periods of {PERIOD} s, total variation over that of ẏ\n\n{table}\n"
    );
    Ok(())
}

/// RMS of x₁ and total variation of u a second, for t from 10 to 30 s under Δ = 5·sin t, with noise on the measured x₃.
fn closed_loop(
    source: impl ErrorRate<f64, 3> + Clone,
    sigma: f64,
    seed: u64,
) -> Result<[f64; 2], Error> {
    let model = ThirdOrder::new();
    let plant = Uncertain::matched(model, |t: f64, _x: &_, _u: &_| 5.0 * t.sin());
    let network = FuzzyNetwork::<_, 3, 3>::evenly_spaced([2.0, 2.0, 20.0])?;
    let learner = NeuroFuzzy::new(network, source, SlidingMode::new(25.0)?);
    let mut clelc =
        Clelc::new(FeedbackLinearization::new(model, Gains::from_lambda(3.0)?), learner);

    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let (mut x, mut u) = (SVector::from([1.0, -1.0, -10.0]), SVector::zeros());
    let (mut square, mut variation) = (0.0, TotalVariation::default());
    for k in 0..3000_u32 {
        let t = f64::from(k) * PERIOD;
        let seen = x + SVector::from([0.0, 0.0, noise(&mut random, sigma)]);
        let command = clelc.update(
            &Measurement::new(seen).with_applied(u),
            &Reference::setpoint(0.0),
            PERIOD,
        )?;
        u = SVector::from([command.u]);
        if t >= 10.0 {
            square += x[0] * x[0];
            variation.push(command.u)?;
        }
        x = Rk4.integrate(|t, x: &_| plant.derivative(t, x, &u), t, &x, PERIOD, 4)?;
    }
    Ok([(square / 2000.0).sqrt(), variation.value() / 20.0])
}

fn loops() -> Result<(), Error> {
    let sigmas = [1e-4, 1e-3, 1e-2, 1e-1];
    let mut table = Table::new();
    table.load_preset(comfy_table::presets::ASCII_MARKDOWN);
    table.set_header(
        [vec!["ė_n from".to_owned()], sigmas.map(|sigma| format!("σ = {sigma}")).to_vec()].concat(),
    );
    macro_rules! row {
        ($name:expr, |$sigma:ident| $source:expr) => {{
            let mut row = vec![$name.to_owned()];
            for $sigma in sigmas {
                let [mut rms, mut variation] = [0.0; 2];
                for seed in 0..4 {
                    let run = closed_loop($source, $sigma, seed)?;
                    (rms, variation) = (rms + run[0] / 4.0, variation + run[1] / 4.0);
                }
                row.push(format!("{rms:.5} / {variation:.0}"));
            }
            table.add_row(row);
        }};
    }
    // Once transients are over, Δ is what moves: |Δ̇| ≤ 5.
    let bound = 5.0;
    row!("e_n: backward difference", |_sigma| BackwardDifference::new());
    row!("e_n: filtered difference", |sigma| FilteredDifference::for_noise(sigma, bound)?);
    row!("e_n: tracking", |sigma| Tracking::for_noise(sigma, bound, PERIOD)?);
    row!("e_n: high-gain, order 1", |sigma| HighGain::<_, 2>::for_noise(sigma, bound, PERIOD)?);
    row!("e_n: robust exact, order 1", |_sigma| RobustExact::first_order(bound)?);
    row!("x_n: high-gain, order 1", |sigma| OfState::new(HighGain::<_, 2>::for_noise(
        sigma, bound, PERIOD
    )?));
    row!("model: backward difference", |_sigma| ModelAided::new());
    row!("model: filtered difference", |sigma| ModelAided::through(FilteredDifference::for_noise(
        sigma, bound
    )?));
    row!("model: tracking", |sigma| ModelAided::through(Tracking::for_noise(
        sigma, bound, PERIOD
    )?));
    row!("model: high-gain, order 1", |sigma| ModelAided::through(HighGain::<_, 2>::for_noise(
        sigma, bound, PERIOD
    )?));
    row!("model: high-gain, order 2", |sigma| ModelAided::through(HighGain::<_, 3>::for_noise(
        sigma, bound, PERIOD
    )?));
    row!("model: robust exact, order 1", |_sigma| ModelAided::through(RobustExact::first_order(
        bound
    )?));
    row!("model: robust exact, order 2", |_sigma| ModelAided::through(RobustExact::second_order(
        bound
    )?));
    println!(
        "CLELC (α = 25, set-valued) under Δ = 5·sin t, noise σ on x₃: RMS of x₁ / total variation of u a second\n\n{table}"
    );
    Ok(())
}

fn main() -> Result<(), Error> {
    signals()?;
    loops()
}
