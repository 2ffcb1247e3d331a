use nalgebra::SVector;

use super::{Limits, Trajectory};
use crate::{Error, Scalar, error::finite_vector};

/// Straight and steady: r(t) = p₀ + v·t. With v = 0 it rests.
///
/// Infinitely often differentiable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line<T, const D: usize> {
    start: SVector<T, D>,
    velocity: SVector<T, D>,
}

impl<T: Scalar, const D: usize> Line<T, D> {
    /// Through `start` = p₀ at t = 0 with `velocity` v.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] for either.
    pub fn new(start: [T; D], velocity: [T; D]) -> Result<Self, Error> {
        let (start, velocity) = (start.into(), velocity.into());
        finite_vector("start", &start)?;
        finite_vector("velocity", &velocity)?;
        Ok(Self { start, velocity })
    }
}

impl<T: Scalar, const D: usize> Trajectory<D> for Line<T, D> {
    type Scalar = T;

    fn derivatives(&self, t: T, out: &mut [SVector<T, D>]) {
        let jet = [self.start + self.velocity * t, self.velocity];
        let jet = jet.into_iter().chain(core::iter::repeat(SVector::zeros()));
        for (out, derivative) in out.iter_mut().zip(jet) {
            *out = derivative;
        }
    }

    /// Speed |v|, acceleration 0; in the plane, yaw rate 0 unless v = 0.
    fn limits(&self, from: T, to: T) -> Result<Limits<T>, Error> {
        let speed = self.velocity.norm();
        let turns = D == 2 && speed > T::zero();
        Limits { speed, acceleration: T::zero(), yaw_rate: turns.then(T::zero) }.over(from, to)
    }
}

checked! {
    [T: Scalar, const D: usize] Line<T, D>, [T]
    { start: SVector<T, D>, velocity: SVector<T, D> } =>
    Self::new(start.into(), velocity.into())
}
