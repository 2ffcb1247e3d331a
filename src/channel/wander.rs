use nalgebra::SVector;
use rand::Rng;

use super::{Channel, noise::normal, validate};
use crate::{
    Error, Scalar,
    error::{finite_vector, not_negative_vector, positive},
};

/// A slow error of each signal: uᵢ ↦ uᵢ + wᵢ, where wᵢ is a first-order Gauss–Markov process, as of a gyroscope's bias or a GNSS position.
///
/// w has standard deviation `deviation` at all times and the autocorrelation e^(−|t|/τ); it is exact at every period, however it changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wander<T, G, const N: usize> {
    deviation: SVector<T, N>,
    time: T,
    /// w before the next period, in units of its deviation.
    at: SVector<T, N>,
    random: G,
}

impl<T: Scalar, G: Rng + Clone, const N: usize> Wander<T, G, N> {
    /// Processes with standard deviation `deviation` ≥ 0 in the units of each signal and time constant τ = `time` > 0 in seconds. Where they
    /// start is drawn from `random` as well, so that no time is needed to become stationary.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(deviation: impl Into<SVector<T, N>>, time: T, mut random: G) -> Result<Self, Error> {
        let deviation = deviation.into();
        not_negative_vector("deviation", &deviation)?;
        Ok(Self {
            deviation,
            time: positive("time constant", time)?,
            at: normal(&mut random),
            random,
        })
    }
}

impl<T: Scalar, G: Rng + Clone, const N: usize> Channel<T, N> for Wander<T, G, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let mut random = self.random.clone();
        let kept = (-dt / self.time).exp();
        // 1 − kept², without its cancellation where little is new.
        let fresh = (-(-(dt + dt) / self.time).exp_m1()).sqrt();
        let at = self.at * kept + normal::<T, G, N>(&mut random) * fresh;
        let arrived = signal + self.deviation.component_mul(&at);
        finite_vector("signal + wander", &arrived)?;
        Ok((Self { at, random, ..*self }, arrived))
    }
}

checked! {
    [T: Scalar, G, const N: usize] Wander<T, G, N>, [T, G; G: Rng + Clone]
    { deviation: SVector<T, N>, time: T, at: SVector<T, N>, random: G } =>
    deviation.iter().try_for_each(|size| not_negative("deviation", *size).map(|_| ())).and_then(|()| {
        known("wander", at.iter().copied())?;
        Ok(Self { deviation, time: positive("time constant", time)?, at, random })
    })
}
