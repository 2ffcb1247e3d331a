use nalgebra::SVector;

use super::Trajectory;
use crate::{
    Error, Scalar,
    elementary::sin_cos,
    error::{finite, positive},
    scalar::constant,
};

/// A lying eight: r(t) = (a·sin ωt, b·sin 2ωt), a Lissajous curve that crosses itself in the origin and never stops for ω ≠ 0.
///
/// It reaches ±a and ±b; its greatest speed is |ω|·√(a² + 4b²), in the crossing. Infinitely often differentiable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FigureEight<T> {
    amplitudes: [T; 2],
    rate: T,
}

impl<T: Scalar> FigureEight<T> {
    /// With half the `length` a > 0, half the `width` b > 0, and `rate` ω in rad/s of either sign: the period is 2π/|ω|.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(length: T, width: T, rate: T) -> Result<Self, Error> {
        let amplitudes = [positive("length", length)?, positive("width", width)?];
        Ok(Self { amplitudes, rate: finite("rate", rate)? })
    }
}

impl<T: Scalar> Trajectory<2> for FigureEight<T> {
    type Scalar = T;

    fn derivatives(&self, t: T, out: &mut [SVector<T, 2>]) {
        let [a, b] = self.amplitudes;
        let mut x = Wave::new(a, self.rate, t);
        let mut y = Wave::new(b, self.rate * constant(2.0), t);
        for out in out {
            *out = SVector::from([x.sin, y.sin]);
            (x, y) = (x.derivative(), y.derivative());
        }
    }
}

/// A·sin ωt and, a quarter of a period ahead, A·cos ωt.
struct Wave<T> {
    rate: T,
    sin: T,
    cos: T,
}

impl<T: Scalar> Wave<T> {
    fn new(amplitude: T, rate: T, t: T) -> Self {
        let (sin, cos) = sin_cos(rate * t);
        Self { rate, sin: sin * amplitude, cos: cos * amplitude }
    }

    fn derivative(&self) -> Self {
        Self { rate: self.rate, sin: self.cos * self.rate, cos: -self.sin * self.rate }
    }
}

checked! {
    [T: Scalar] FigureEight<T>, [T] { amplitudes: [T; 2], rate: T } =>
    Self::new(amplitudes[0], amplitudes[1], rate)
}
