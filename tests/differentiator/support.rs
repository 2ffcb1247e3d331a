//! What the tests of this room share: runs over sampled signals, and figures of what comes out.

use brunovsky::{Scalar, differentiator::Differentiator};
use proptest::test_runner::{RngAlgorithm, TestRng};

pub use crate::numbers::{cases, real, ulps};

/// The same random numbers at every run.
pub fn rng() -> TestRng {
    TestRng::deterministic_rng(RngAlgorithm::XorShift)
}

pub const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// What `source` says at the samples `signal(t)`, t = 0, h, 2h, …
pub fn rates<T: Scalar>(
    mut source: impl Differentiator<Scalar = T>,
    h: f64,
    samples: u32,
    signal: impl Fn(f64) -> f64,
) -> Vec<T> {
    let y = |k: u32| real(signal(f64::from(k) * h));
    (0..samples).map(|k| source.update(y(k), real(h)).unwrap()).collect()
}

/// What `source` says once a long quiet start is over and a single sample is 1.
pub fn impulse_response<T: Scalar>(
    mut source: impl Differentiator<Scalar = T>,
    h: f64,
    samples: u32,
) -> Vec<T> {
    source.update(T::zero(), real(h)).unwrap();
    let y = |k: u32| if k == 0 { T::one() } else { T::zero() };
    (0..samples).map(|k| source.update(y(k), real(h)).unwrap()).collect()
}

/// The largest distance, over two seconds of the signal sin t, of the rates from `wanted(t)`, leaving out the first sample.
pub fn error_on_a_sine(
    source: impl Differentiator<Scalar = f64>,
    h: f64,
    wanted: impl Fn(f64) -> f64,
) -> f64 {
    let rates = rates(source, h, (2.0 / h).round() as u32, f64::sin);
    let errors =
        rates.iter().enumerate().skip(1).map(|(k, rate)| (rate - wanted(k as f64 * h)).abs());
    errors.fold(0.0, f64::max)
}

/// Where a function of one variable with one minimum has it.
pub fn is_least_at(cost: impl Fn(f64) -> f64, x: f64) -> bool {
    [0.98, 0.99, 1.01, 1.02].into_iter().all(|factor| cost(factor * x) > cost(x))
}
