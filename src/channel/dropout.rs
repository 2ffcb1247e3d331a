use nalgebra::SVector;
use rand::{Rng, RngExt};

use super::{Channel, validate};
use crate::{
    Error, Scalar,
    error::{below, not_negative},
};

/// Losses: a call whose signals do not arrive leaves those that arrived last, all together.
///
/// Each call is lost with the same probability, independently of the others. The first always arrives: there is nothing before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dropout<T, G, const N: usize> {
    probability: f64,
    last: Option<SVector<T, N>>,
    random: G,
}

impl<T: Scalar, G: Rng + Clone, const N: usize> Dropout<T, G, N> {
    /// Losses with a `probability` from 0 to below 1, drawn from `random`.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotBelow`] or [`Error::NonFinite`].
    pub fn new(probability: f64, random: G) -> Result<Self, Error> {
        let probability = below("probability", not_negative("probability", probability)?, 1.0)?;
        Ok(Self { probability, last: None, random })
    }
}

impl<T: Scalar, G: Rng + Clone, const N: usize> Channel<T, N> for Dropout<T, G, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let mut random = self.random.clone();
        let lost = random.random::<f64>() < self.probability;
        let arrived = self.last.filter(|_| lost).unwrap_or(*signal);
        Ok((Self { last: Some(arrived), random, ..*self }, arrived))
    }
}

checked! {
    [T: Scalar, G, const N: usize] Dropout<T, G, N>, [T, G; G: Rng + Clone]
    { probability: f64, last: Option<SVector<T, N>>, random: G } =>
    Self::new(probability, random).and_then(|new| {
        known("last signal", last.iter().flatten().copied())?;
        Ok(Self { last, ..new })
    })
}
