//! What the runner costs beside a plain parallel map over the same experiment: order, failures and the generator of each run.

use std::hint::black_box;

use brunovsky::{
    Error,
    ensemble::{Ensemble, Run, rand::RngExt},
    plant::Pendulum,
    prelude::*,
};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

const RUNS: u64 = 1000;

/// A pendulum of random mass under FLC for so many samples: some 1 µs each.
fn experiment(mut run: Run, samples: usize) -> Result<[f64; 1], Error> {
    let believed = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
    let true_one = Pendulum::new(run.random_range(0.8..1.2), 0.5, 0.1, 9.81)?;
    let flc = FeedbackLinearization::new(believed, Gains::from_lambda(4.0)?);
    let setpoint = |_| Reference::setpoint(1.0);
    let mut last = 0.0;
    for sample in Simulation::new(&true_one, flc, setpoint, [0.0, 0.0], 0.01)?.take(samples) {
        last = sample?.x[0];
    }
    Ok([last])
}

fn runner(c: &mut Criterion) {
    let mut group = c.benchmark_group("ensemble");
    for samples in [1, 100, 1000] {
        let ensemble = Ensemble::new(1, ["x"], move |run| experiment(run, samples));
        group.bench_function(BenchmarkId::new("runner", samples), |b| {
            b.iter(|| black_box(ensemble.runs(RUNS)));
        });
        group.bench_function(BenchmarkId::new("plain", samples), |b| {
            b.iter(|| {
                let outcome = |index| experiment(Run::new(1, index), samples);
                black_box((0..RUNS).into_par_iter().map(outcome).collect::<Vec<_>>())
            });
        });
    }
    group.finish();
}

criterion_group!(benches, runner);
criterion_main!(benches);
