use nalgebra::SVector;
use rand::Rng;
use rand_distr::{Distribution, StandardNormal};

use super::{Channel, validate};
use crate::{
    Error, Scalar,
    error::{finite_vector, not_negative_vector},
    scalar::constant,
};

/// White Gaussian noise on each signal: uᵢ ↦ uᵢ + deviationᵢ·ξ with independent standard normal ξ, new at each call.
///
/// `deviation` is that of one sample: a sensor that is read more often brings more noise in all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise<T, G, const N: usize> {
    deviation: SVector<T, N>,
    random: G,
}

impl<T: Scalar, G: Rng + Clone, const N: usize> Noise<T, G, N> {
    /// Noise of standard deviation `deviation` ≥ 0 for each signal, in its units, drawn from `random`.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn new(deviation: impl Into<SVector<T, N>>, random: G) -> Result<Self, Error> {
        let deviation = deviation.into();
        not_negative_vector("deviation", &deviation)?;
        Ok(Self { deviation, random })
    }
}

impl<T: Scalar, G: Rng + Clone, const N: usize> Channel<T, N> for Noise<T, G, N> {
    fn passed(&self, signal: &SVector<T, N>, dt: T) -> Result<(Self, SVector<T, N>), Error> {
        validate(signal, dt)?;
        let mut random = self.random.clone();
        let arrived = signal + self.deviation.component_mul(&normal(&mut random));
        finite_vector("signal + noise", &arrived)?;
        Ok((Self { random, ..*self }, arrived))
    }
}

/// Independent standard normal numbers.
pub(super) fn normal<T: Scalar, G: Rng, const N: usize>(random: &mut G) -> SVector<T, N> {
    SVector::from_fn(|_, _| constant(StandardNormal.sample(random)))
}

checked! {
    [T: Scalar, G, const N: usize] Noise<T, G, N>, [T, G; G: Rng + Clone]
    { deviation: SVector<T, N>, random: G } =>
    Self::new(deviation, random)
}
