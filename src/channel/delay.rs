use nalgebra::SVector;

use super::{Channel, validate};
use crate::{Error, Scalar, error::finite_vector};

/// A transport delay of D periods: what arrives was sent D calls before, and until then what the channel was filled with.
///
/// A computation that takes D ticks is a delay of D on the side of the actuators, if those run at every tick.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Delay<T, const N: usize, const D: usize> {
    /// The signals on their way; the oldest is at `oldest`.
    line: [SVector<T, N>; D],
    oldest: usize,
}

impl<T: Scalar, const N: usize, const D: usize> Delay<T, N, D> {
    /// A delay that is filled with zeros.
    pub fn new() -> Self {
        Self { line: [SVector::zeros(); D], oldest: 0 }
    }

    /// The same delay, filled with `signal`: for a sensor, what it showed before.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn starting_at(self, signal: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let signal = signal.into();
        finite_vector("signal", &signal)?;
        Ok(Self { line: [signal; D], oldest: 0 })
    }
}

impl<T: Scalar, const N: usize, const D: usize> Default for Delay<T, N, D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Scalar, const N: usize, const D: usize> Channel<T, N> for Delay<T, N, D> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let mut next = *self;
        // Without a place to wait it arrives at once.
        let Some(place) = next.line.get_mut(self.oldest) else { return Ok((next, *signal)) };
        let arrived = core::mem::replace(place, *signal);
        next.oldest = if self.oldest + 1 < D { self.oldest + 1 } else { 0 };
        Ok((next, arrived))
    }
}

checked! {
    [T: Scalar, const N: usize, const D: usize] Delay<T, N, D>, [T]
    { line: Array<SVector<T, N>, D> = Array(*line), oldest: usize } =>
    known("delayed signal", line.0.iter().flatten().copied()).and_then(|()| {
        if oldest < D.max(1) {
            Ok(Self { line: line.0, oldest })
        } else {
            Err(Error::NotBelow { name: "oldest", value: oldest as f64, limit: D as f64 })
        }
    })
}
