use nalgebra::SVector;

use super::{Channel, validate};
use crate::{
    Error, Scalar,
    error::{finite_vector, positive_vector},
    scalar::constant,
};

/// A first-order lag of each signal: τᵢ·ẏᵢ + yᵢ = uᵢ, with uᵢ held over the period.
///
/// y goes exponentially from where it was to u, exactly. What arrives is its mean over the period, so that a plant that takes it for constant
/// receives the right impulse: the error of that is of second order in the period. Where it matters, give the actuators a shorter period than
/// the controller ([`Hardware::every`](crate::simulation::Hardware::every)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lag<T, const N: usize> {
    time: SVector<T, N>,
    y: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Lag<T, N> {
    /// Lags with time constants τ = `time` > 0 in seconds, at rest at 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(time: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let time = time.into();
        positive_vector("time constant", &time)?;
        Ok(Self { time, y: SVector::zeros() })
    }

    /// The same lags, starting at `y`.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn starting_at(self, y: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let y = y.into();
        finite_vector("y", &y)?;
        Ok(Self { y, ..self })
    }
}

impl<T: Scalar, const N: usize> Channel<T, N> for Lag<T, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let kept = self.time.map(|time| (-dt / time).exp());
        // The mean of e^(−t/τ) over the period; where the period is too short to tell, its value at the middle.
        let mean = self.time.map(|time| {
            let periods = dt / time;
            let short = periods * periods < T::default_epsilon();
            let half = constant::<T>(0.5);
            if short { T::one() - periods * half } else { -(-periods).exp_m1() / periods }
        });
        let toward = |share: SVector<T, N>| {
            self.y.component_mul(&share)
                + signal.component_mul(&share.map(|share| T::one() - share))
        };
        Ok((Self { y: toward(kept), ..*self }, toward(mean)))
    }
}

checked! {
    [T: Scalar, const N: usize] Lag<T, N>, [T] { time: SVector<T, N>, y: SVector<T, N> } =>
    Self::new(time).and_then(|lag| lag.starting_at(y))
}
