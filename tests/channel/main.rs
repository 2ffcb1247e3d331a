//! Channels: what arrives of a signal, against the definition of each.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/precisions.rs"]
mod precisions;

mod bias;
mod dead_zone;
mod delay;
mod every;
mod lag;
mod noise;
mod quantization;
mod rate_limit;
mod saturation;

use brunovsky::{
    Scalar,
    channel::Channel,
    nalgebra::{self, SVector},
};
use precisions::at_f32_and_f64;

/// `value` in the scalar type of the check.
fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// What arrives of `signal`, and the channel afterwards is dropped.
fn arrived<T: Scalar, C: Channel<T, N>, const N: usize>(
    channel: &C,
    signal: [f64; N],
) -> SVector<T, N> {
    channel.passed(&SVector::from(signal.map(num)), T::one()).unwrap().1
}

/// Everything that arrives of a row of signals, one a period of `dt`.
fn all_arrived<T: Scalar>(mut channel: impl Channel<T, 1>, signals: &[f64], dt: f64) -> Vec<T> {
    let mut period = |signal: &f64| {
        let (next, arrived) = channel.passed(&SVector::from([num::<T>(*signal)]), num(dt)).unwrap();
        channel = next;
        arrived[0]
    };
    signals.iter().map(&mut period).collect()
}
