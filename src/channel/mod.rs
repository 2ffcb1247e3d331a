//! Channels: what becomes of signals on their way, from a sensor to the controller or from the controller to the plant.
//!
//! | channel | what arrives |
//! |---|---|
//! | [`Ideal`] | what was sent |
//! | [`Saturation`] | each signal within its limits |
//! | [`RateLimit`] | no signal faster than its limit |
//! | [`DeadZone`] | nothing of what is near 0 |
//! | [`Lag`] | each signal behind a first-order lag |
//! | [`Delay`] | what was sent some periods ago |
//! | [`Quantization`] | the nearest multiple of a step |
//! | [`Bias`] | each signal and a constant |
//! | `Noise` (feature `random`) | each signal and white noise |
//! | `Wander` (feature `random`) | each signal and a slow Gauss–Markov process |
//! | `Dropout` (feature `random`) | now and then what arrived before |
//! | a pair `(A, B)` | B of what A lets through |
//!
//! ```
//! use brunovsky::channel::{Channel, Quantization, RateLimit, Saturation};
//! use nalgebra::SVector;
//!
//! let drive = (Saturation::symmetric([1.0])?, RateLimit::new([5.0])?);
//! let (drive, u) = drive.passed(&SVector::from([3.0]), 0.1)?;
//! assert_eq!(u[0], 0.5);
//! let (_, u) = (drive, Quantization::new([0.25])?).passed(&SVector::from([0.9]), 0.1)?;
//! assert_eq!(u[0], 1.0);
//! # Ok::<(), brunovsky::Error>(())
//! ```
//!
//! A [`Channel`] is a state machine without a clock, called once a period: the same calls give the same outputs. Each is one imperfection;
//! pairs of pairs make the instrument. Random ones draw from a generator that they are given, so what they do follows from its seed.
//!
//! Behind a controller a channel is an actuator: [`Limited`](crate::controller::Limited) tells the controller what arrived.
//! [`Hardware`](crate::simulation::Hardware) puts channels on both sides of a simulated controller.
//!
//! This module depends on nothing but [`Scalar`] and [`Error`].

mod bias;
mod dead_zone;
mod delay;
#[cfg(feature = "random")]
mod dropout;
mod ideal;
mod lag;
#[cfg(feature = "random")]
mod noise;
mod quantization;
mod rate_limit;
mod saturation;
#[cfg(feature = "random")]
mod wander;

pub use bias::Bias;
pub use dead_zone::DeadZone;
pub use delay::Delay;
#[cfg(feature = "random")]
pub use dropout::Dropout;
pub use ideal::Ideal;
pub use lag::Lag;
#[cfg(feature = "random")]
pub use noise::Noise;
pub use quantization::Quantization;
pub use rate_limit::RateLimit;
pub use saturation::Saturation;
#[cfg(feature = "random")]
pub use wander::Wander;

use nalgebra::SVector;

use crate::{
    Error, Scalar,
    error::{finite_vector, positive},
};

/// A sampled channel for N signals.
pub trait Channel<T: Scalar, const N: usize>: Clone {
    /// The channel after a period of `dt` > 0 seconds, and what arrives over it when `signal` is sent. Both are finite.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for a bad `dt`, [`Error::NonFiniteEntry`] for a bad `signal`, or for one that leaves the
    /// range of `T` on its way.
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error>;
}

/// One channel behind another.
impl<T: Scalar, A: Channel<T, N>, B: Channel<T, N>, const N: usize> Channel<T, N> for (A, B) {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        let (first, between) = self.0.passed(signal, dt)?;
        let (second, arrived) = self.1.passed(&between, dt)?;
        Ok(((first, second), arrived))
    }
}

/// Checks a call of a channel.
fn validate<T: Scalar, const N: usize>(signal: &SVector<T, N>, dt: T) -> Result<(), Error> {
    positive("dt", dt)?;
    finite_vector("signal", signal)
}
