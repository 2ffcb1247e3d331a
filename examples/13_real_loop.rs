//! A pendulum whose mass is 20 % off, in the loop of a real machine: one imperfection after the other, and what each costs.
//!
//! The clock ticks every millisecond. The drive moves at every tick, the sensors are read every second one and the controller is called every tenth,
//! when nothing else is said. Every random number follows from a seed, so a row is the same at every run.

use brunovsky::{
    channel::{Channel, Delay, Dropout, Ideal, Lag, Noise, Quantization, Saturation},
    plant::Pendulum,
    prelude::*,
    simulation::Sensor,
};
use comfy_table::{Table, presets::ASCII_MARKDOWN};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const TICK: f64 = 0.001;

/// Rms of r − x₁ in mrad and total variation of the torque in N·m/s, from 5 s to 15 s.
fn follow<S, A, L, C>(hardware: Hardware<S, A, L>, controller: C) -> Result<[f64; 2], Error>
where
    S: Sensor<f64, 2, 1, Seen = Measurement<f64, 2, 1>>,
    A: Channel<f64, 1>,
    L: FnMut(u64) -> u64,
    C: Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>>,
{
    let truth = Pendulum::new(1.2, 0.5, 0.1, 9.81)?;
    let swing = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
    let run = Simulation::with_hardware(&truth, hardware, controller, swing, [0.0, 1.0], TICK)?;
    let (mut error, mut variation) = (ErrorMetrics::default(), TotalVariation::default());
    for tick in run.until(15.0)?.ticks() {
        let tick = tick?;
        if tick.t >= 5.0 {
            error.push(tick.t, tick.t.sin() - tick.x[0])?;
            variation.push(tick.u[0])?;
        }
    }
    let rms = error.rms().ok_or(Error::Missing { name: "samples" })?;
    Ok([1e3 * rms, variation.value() / 10.0])
}

/// The rms and variation of feedback linearization, and of closed-loop error learning on the same hardware.
fn both<S, A, L>(hardware: Hardware<S, A, L>) -> Result<[f64; 4], Error>
where
    S: Sensor<f64, 2, 1, Seen = Measurement<f64, 2, 1>>,
    A: Channel<f64, 1>,
    L: FnMut(u64) -> u64 + Clone,
{
    let flc =
        FeedbackLinearization::new(Pendulum::new(1.0, 0.5, 0.1, 9.81)?, Gains::from_lambda(4.0)?);
    let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([0.5, 2.0])?;
    // Noise of 0.01 rad/s looks like 0.01/0.01 s = 1 rad/s² of uncertainty.
    let rule = SlidingMode::new(10.0)?.with_switching(Switching::Implicit { delta: 1.0 })?;
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));
    let [error, variation] = follow(hardware.clone(), flc)?;
    let [learned_error, learned_variation] = follow(hardware, clelc)?;
    Ok([error, learned_error, variation, learned_variation])
}

/// Random numbers of their own for each part of the hardware.
fn random(stream: u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    random.set_stream(stream);
    random
}

fn main() -> Result<(), Error> {
    let encoder = Quantization::new([core::f64::consts::TAU / 4096.0, 0.001])?;
    let noisy = (Noise::new([0.0, 0.01], random(0))?, encoder);
    let lossy = (noisy.clone(), Dropout::new(0.1, random(1))?);
    let strong = Saturation::symmetric([12.0])?;
    let computing = (Delay::<f64, 1, 3>::new(), strong);
    let lagging = (computing, Lag::new([0.005])?);
    let shown = |channel| Sensors::of_state(channel);
    let late = {
        let mut random = random(2);
        move |_| random.random_range(0..5)
    };

    let rows = [
        ("ideal, every tick", both(Hardware::default())?),
        ("controller every 10 ms", both(Hardware::default().every(2, 10, 1)?)?),
        ("+ encoder and noisy rate", both(Hardware::new(shown(noisy), Ideal).every(2, 10, 1)?)?),
        (
            "+ 10 % of the samples lost",
            both(Hardware::new(Sensors::of_state(lossy.clone()), strong).every(2, 10, 1)?)?,
        ),
        (
            "+ 3 ms to compute",
            both(Hardware::new(Sensors::of_state(lossy.clone()), computing).every(2, 10, 1)?)?,
        ),
        (
            "+ a lag of 5 ms in the drive",
            both(Hardware::new(Sensors::of_state(lossy.clone()), lagging).every(2, 10, 1)?)?,
        ),
        (
            "+ 0 to 4 ms of jitter",
            both(Hardware::new(Sensors::of_state(lossy), lagging).every(2, 10, 1)?.late(late))?,
        ),
    ];
    let mut table = Table::new();
    table.load_preset(ASCII_MARKDOWN).set_header([
        "hardware",
        "rms FLC in mrad",
        "CLELC",
        "TV(u) FLC in N·m/s",
        "CLELC",
    ]);
    for (name, figures) in rows {
        let figures = figures.map(|figure| format!("{figure:.2}"));
        table.add_row([&[name.to_owned()][..], &figures].concat());
    }
    println!("{table}");
    Ok(())
}
