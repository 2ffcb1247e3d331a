//! Counts and times.

use std::{
    hint::black_box,
    sync::atomic::{AtomicU64, Ordering},
    time::{Duration, Instant},
};

use anyhow::Result;

use crate::problems::Problem;

/// How often f and ∂f/∂x were evaluated, if they are counted at all.
static RATES: AtomicU64 = AtomicU64::new(0);
static JACOBIANS: AtomicU64 = AtomicU64::new(0);

/// f, counted if asked to; which is decided at compile time.
#[inline]
pub fn rate<P: Problem<N>, const N: usize, const COUNT: bool>(x: &[f64; N]) -> [f64; N] {
    if COUNT {
        RATES.fetch_add(1, Ordering::Relaxed);
    }
    P::rate(x)
}

/// ∂f/∂x, as above. One column of N counts as 1.
#[inline]
pub fn jacobian<P: Problem<N>, const N: usize, const COUNT: bool>(
    x: &[f64; N],
    columns: usize,
) -> [[f64; N]; N] {
    if COUNT {
        JACOBIANS.fetch_add(columns as u64, Ordering::Relaxed);
    }
    P::jacobian(x)
}

/// A run of a problem at rtol: counted, or timed.
pub type Run<const N: usize> = fn(rtol: f64, count: bool) -> Result<[f64; N]>;

pub struct Contender<const N: usize> {
    pub name: &'static str,
    pub run: Run<N>,
}

pub struct Work {
    pub error: f64,
    pub rates: u64,
    /// Whole Jacobians.
    pub jacobians: f64,
}

pub fn work<P: Problem<N>, const N: usize>(run: Run<N>, rtol: f64) -> Result<Work> {
    RATES.store(0, Ordering::Relaxed);
    JACOBIANS.store(0, Ordering::Relaxed);
    let found = run(rtol, true)?;
    let end = P::end()?;
    let scale = P::scale(&end);
    let relative = (0..N).map(|i| ((found[i] - end[i]) / scale[i]).abs());
    Ok(Work {
        error: relative.fold(0.0, f64::max),
        rates: RATES.load(Ordering::Relaxed),
        jacobians: JACOBIANS.load(Ordering::Relaxed) as f64 / N as f64,
    })
}

/// The time of one run of each, in seconds: the least of forty batches of 1 ms, in turn, short enough to fall between interruptions.
pub fn times<const N: usize>(runs: &[Run<N>], rtol: f64) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; runs.len()];
    for _ in 0..40 {
        for (run, least) in runs.iter().zip(&mut least) {
            let (start, mut count) = (Instant::now(), 0);
            while start.elapsed() < Duration::from_millis(1) {
                let _ = black_box(run(black_box(rtol), false));
                count += 1;
            }
            *least = least.min(start.elapsed().as_secs_f64() / f64::from(count));
        }
    }
    least
}
