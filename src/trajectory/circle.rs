use nalgebra::SVector;

use super::{Limits, Trajectory};
use crate::{
    Error, Scalar,
    elementary::sin_cos,
    error::{finite, finite_vector, positive},
};

/// A circle: r(t) = c + R·(cos θ, sin θ) with θ = ω·t + φ, counter-clockwise for ω > 0.
///
/// Each derivative is the one before, turned by a quarter and multiplied by ω: speed R·|ω|, acceleration R·ω² towards the centre, yaw
/// rate ω. Infinitely often differentiable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle<T> {
    centre: SVector<T, 2>,
    radius: T,
    rate: T,
    phase: T,
}

impl<T: Scalar> Circle<T> {
    /// Around `centre` c with `radius` R > 0, at the angular `rate` ω in rad/s, of either sign, from the angle `phase` φ in rad.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the radius, [`Error::NonFinite`] or [`Error::NonFiniteEntry`] for a parameter that is not finite.
    pub fn new(centre: [T; 2], radius: T, rate: T, phase: T) -> Result<Self, Error> {
        let centre = centre.into();
        finite_vector("centre", &centre)?;
        Ok(Self {
            centre,
            radius: positive("radius", radius)?,
            rate: finite("rate", rate)?,
            phase: finite("phase", phase)?,
        })
    }
}

impl<T: Scalar> Trajectory<2> for Circle<T> {
    type Scalar = T;

    fn derivatives(&self, t: T, out: &mut [SVector<T, 2>]) {
        let (sin, cos) = sin_cos(self.rate * t + self.phase);
        let mut around = self.centre;
        let mut arm = SVector::from([cos, sin]) * self.radius;
        for out in out {
            *out = around + arm;
            around = SVector::zeros();
            arm = SVector::from([-arm[1], arm[0]]) * self.rate;
        }
    }

    /// Speed R·|ω|, acceleration R·ω², yaw rate |ω|; no yaw rate if ω = 0.
    fn limits(&self, from: T, to: T) -> Result<Limits<T>, Error> {
        let rate = self.rate.abs();
        let speed = self.radius * rate;
        let yaw_rate = (rate > T::zero()).then_some(rate);
        Limits { speed, acceleration: speed * rate, yaw_rate }.over(from, to)
    }
}

checked! {
    [T: Scalar] Circle<T>, [T] { centre: SVector<T, 2>, radius: T, rate: T, phase: T } =>
    Self::new(centre.into(), radius, rate, phase)
}
