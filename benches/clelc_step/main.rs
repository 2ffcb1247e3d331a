//! One step of CLELC, beside a plain transcription of the same law, at several sizes in f32 and f64.
//!
//! The figure to read is the ratio of the two in one run; times alone say more about the machine.

mod textbook;

use std::hint::black_box;

use brunovsky::{
    fuzzy::{Grid, Inputs},
    plant::IntegratorChain,
    prelude::*,
};
use criterion::{Criterion, criterion_group, criterion_main};
use textbook::Textbook;

/// Small enough for the memberships to stay where the plain formulas keep their accuracy.
const ALPHA: f64 = 2.0;
const LAMBDA: f64 = 3.0;
const PERIOD: f64 = 0.01;

fn real<T: Scalar>(value: f64) -> T {
    brunovsky::nalgebra::convert(value)
}

/// States along a smooth path, off every centre at the start.
fn states<T: Scalar, const N: usize>() -> Vec<SVector<T, N>> {
    let state =
        |k: usize| SVector::from_fn(|i, _| real(0.3 + 0.5 * (0.02 * k as f64 + i as f64).sin()));
    (0..512).map(state).collect()
}

fn clelc<T: Scalar, const N: usize, const K: usize>()
-> Result<impl FnMut(&SVector<T, N>) -> Result<T, Error>, Error>
where
    Inputs<N>: Grid,
{
    let flc = FeedbackLinearization::new(
        IntegratorChain::<T, N>::new(),
        Gains::from_lambda(real(LAMBDA))?,
    );
    let network = FuzzyNetwork::<T, N, K>::evenly_spaced([real(2.0); N])?;
    let learner =
        NeuroFuzzy::new(network, BackwardDifference::new(), SlidingMode::new(real(ALPHA))?);
    let mut clelc = Clelc::new(flc, learner);
    let rest = Reference::setpoint(real(0.0));
    Ok(move |x: &SVector<T, N>| Ok(clelc.update(&Measurement::new(*x), &rest, real(PERIOD))?.u))
}

fn size<T: Scalar, const N: usize, const K: usize>(
    criterion: &mut Criterion,
    name: &str,
) -> Result<(), Error>
where
    Inputs<N>: Grid,
{
    let states = states::<T, N>();
    let mut group = criterion.benchmark_group(format!("{name}, I = {N}, K = {K}"));

    // Two implementations are worth comparing only if they compute the same.
    let (mut ours, mut plain) =
        (clelc::<T, N, K>()?, Textbook::<T>::new(N, K, LAMBDA, ALPHA, PERIOD, 2.0));
    let tolerance = T::default_epsilon().sqrt();
    for x in &states {
        let (ours, plain) = (ours(x)?, plain.update(x.as_slice()));
        assert!(
            (ours - plain).abs() <= tolerance * (T::one() + ours.abs()),
            "{ours} is not {plain}"
        );
    }

    let mut k = 0;
    group.bench_function("brunovsky", |bencher| {
        bencher.iter(|| {
            k = (k + 1) % states.len();
            ours(black_box(&states[k]))
        });
    });
    group.bench_function("textbook", |bencher| {
        bencher.iter(|| {
            k = (k + 1) % states.len();
            plain.update(black_box(states[k].as_slice()))
        });
    });
    group.finish();
    Ok(())
}

fn all(criterion: &mut Criterion) {
    let outcome = size::<f64, 2, 3>(criterion, "f64")
        .and_then(|()| size::<f32, 2, 3>(criterion, "f32"))
        .and_then(|()| size::<f64, 3, 3>(criterion, "f64"))
        .and_then(|()| size::<f32, 3, 3>(criterion, "f32"))
        .and_then(|()| size::<f64, 3, 5>(criterion, "f64"))
        .and_then(|()| size::<f32, 3, 5>(criterion, "f32"));
    if let Err(error) = outcome {
        eprintln!("{error}");
    }
}

criterion_group!(benches, all);
criterion_main!(benches);
