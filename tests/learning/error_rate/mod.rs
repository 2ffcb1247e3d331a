mod backward_difference;
mod conditional;
mod filtered_difference;
mod measured;
mod model_aided;
mod redundant;

use brunovsky::{Scalar, learning::ErrorRate};

use crate::support::{at_error, real};

/// What `source` says at the samples `signal(t)`, t = 0, h, 2h, …, of the last error.
fn rates<T: Scalar>(
    mut source: impl ErrorRate<T, 2>,
    h: f64,
    samples: u32,
    signal: impl Fn(f64) -> f64,
) -> Vec<T> {
    let at = |k: u32| at_error(real(signal(f64::from(k) * h)));
    (0..samples).map(|k| source.error_rate(&at(k), T::zero(), real(h)).unwrap()).collect()
}

/// The largest distance, over two seconds of the signal sin t, of the rates from `wanted(t)`, leaving out the first sample.
fn error_on_a_sine(source: impl ErrorRate<f64, 2>, h: f64, wanted: impl Fn(f64) -> f64) -> f64 {
    let rates = rates(source, h, (2.0 / h).round() as u32, f64::sin);
    let errors =
        rates.iter().enumerate().skip(1).map(|(k, rate)| (rate - wanted(k as f64 * h)).abs());
    errors.fold(0.0, f64::max)
}
