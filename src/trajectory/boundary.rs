use nalgebra::SVector;

use crate::{Error, Scalar, error::finite_vector, scalar::constant};

/// Position, velocity and acceleration where a curve begins or ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boundary<T, const D: usize> {
    /// The position p.
    pub position: SVector<T, D>,
    /// The velocity v.
    pub velocity: SVector<T, D>,
    /// The acceleration a.
    pub acceleration: SVector<T, D>,
}

impl<T: Scalar, const D: usize> Boundary<T, D> {
    /// At `position` with `velocity` and `acceleration`.
    pub fn new(position: [T; D], velocity: [T; D], acceleration: [T; D]) -> Self {
        Self {
            position: position.into(),
            velocity: velocity.into(),
            acceleration: acceleration.into(),
        }
    }

    /// At rest in `position`.
    pub fn rest(position: [T; D]) -> Self {
        Self::new(position, [T::zero(); D], [T::zero(); D])
    }

    /// Checks that everything is finite.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], naming `position`, `velocity` or `acceleration`.
    pub fn validate(&self) -> Result<(), Error> {
        finite_vector("position", &self.position)?;
        finite_vector("velocity", &self.velocity)?;
        finite_vector("acceleration", &self.acceleration)
    }

    /// The motion that keeps this acceleration: p + v·t + a·t²/2 and its derivatives, t from here and of either sign.
    pub(super) fn coast(&self, t: T, out: &mut [SVector<T, D>]) {
        let half = constant::<T>(0.5);
        let velocity = self.velocity + self.acceleration * t;
        let position = self.position + (self.velocity + velocity) * (t * half);
        let jet = [position, velocity, self.acceleration];
        let jet = jet.into_iter().chain(core::iter::repeat(SVector::zeros()));
        for (out, derivative) in out.iter_mut().zip(jet) {
            *out = derivative;
        }
    }
}

checked! {
    [T: Scalar, const D: usize] Boundary<T, D>, [T]
    { position: SVector<T, D>, velocity: SVector<T, D>, acceleration: SVector<T, D> } =>
    {
        let boundary = Self { position, velocity, acceleration };
        boundary.validate().map(|()| boundary)
    }
}
