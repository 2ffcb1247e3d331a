use nalgebra::SVector;

use super::{Boundary, Trajectory};
use crate::{
    Error, Scalar,
    error::{finite_vector, positive},
    scalar::constant,
};

/// The quintic from one boundary state to another: r(t) = Σ cⱼ·τʲ, τ = t/T, j = 0…5, for 0 ≤ t ≤ T.
///
/// Among all curves between these states it is the one of least ∫|r⃛|² dt. From rest to rest it is
/// p₀ + (p₁ − p₀)·(10τ³ − 15τ⁴ + 6τ⁵), with the greatest speed 15/8·|p₁ − p₀|/T half-way.
///
/// Before and after, it goes on with the acceleration of its end; from rest to rest, it rests. Infinitely often differentiable inside, two
/// continuous derivatives at the ends.
///
/// # References
/// T. Flash and N. Hogan, "The coordination of arm movements: an experimentally confirmed mathematical model", Journal of
/// Neuroscience 5(7), 1985.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quintic<T, const D: usize> {
    start: Boundary<T, D>,
    end: Boundary<T, D>,
    duration: T,
    /// (c₀, …, c₅).
    coefficients: [SVector<T, D>; 6],
}

impl<T: Scalar, const D: usize> Quintic<T, D> {
    /// From `start` at t = 0 to `end` at t = `duration` T > 0.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] for a boundary state, [`Error::NotPositive`] or [`Error::NonFinite`] for the duration;
    /// [`Error::NonFiniteEntry`] for `coefficients` c₀, …, c₅ beyond the range of `T`.
    pub fn new(start: Boundary<T, D>, end: Boundary<T, D>, duration: T) -> Result<Self, Error> {
        start.validate()?;
        end.validate()?;
        let quintic = Self::between(start, end, positive("duration", duration)?);
        for c in &quintic.coefficients {
            finite_vector("coefficients", c)?;
        }
        Ok(quintic)
    }

    /// From rest in `start` at t = 0 to rest in `end` at t = `duration` T > 0.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn rest_to_rest(start: [T; D], end: [T; D], duration: T) -> Result<Self, Error> {
        Self::new(Boundary::rest(start), Boundary::rest(end), duration)
    }

    /// The duration T in seconds.
    pub fn duration(&self) -> T {
        self.duration
    }

    /// The same between states that have been checked.
    pub(super) fn between(start: Boundary<T, D>, end: Boundary<T, D>, duration: T) -> Self {
        let (n, h) = (constant::<T>, duration);
        let c0 = start.position;
        let c1 = start.velocity * h;
        let c2 = start.acceleration * h * h * n(0.5);
        // What the first three terms leave to be done at τ = 1.
        let p = end.position - c0 - c1 - c2;
        let v = end.velocity * h - c1 - c2 * n(2.0);
        let a = end.acceleration * h * h - c2 * n(2.0);
        let c3 = p * n(10.0) - v * n(4.0) + a * n(0.5);
        let c4 = p * n(-15.0) + v * n(7.0) - a;
        let c5 = p * n(6.0) - v * n(3.0) + a * n(0.5);
        Self { start, end, duration, coefficients: [c0, c1, c2, c3, c4, c5] }
    }

    /// The velocity of the polynomial at any t.
    pub(super) fn velocity(&self, t: T) -> SVector<T, D> {
        let tau = t / self.duration;
        let terms = self.coefficients.iter().enumerate().skip(1).rev();
        let sum = |sum, (j, c): (usize, &SVector<T, D>)| sum * tau + c * constant::<T>(j as f64);
        terms.fold(SVector::zeros(), sum) / self.duration
    }

    /// The polynomial and its derivatives at any t.
    pub(super) fn polynomial(&self, t: T, out: &mut [SVector<T, D>]) {
        let tau = t / self.duration;
        let mut c = self.coefficients;
        for out in out {
            *out = c.iter().rev().fold(SVector::zeros(), |sum, c| sum * tau + c);
            // d/dt: cⱼ becomes (j + 1)·cⱼ₊₁/T.
            c.rotate_left(1);
            for (j, c) in c.iter_mut().enumerate() {
                let factor = if j < 5 { constant((j + 1) as f64) } else { T::zero() };
                *c *= factor / self.duration;
            }
        }
    }
}

impl<T: Scalar, const D: usize> Trajectory<D> for Quintic<T, D> {
    type Scalar = T;

    fn derivatives(&self, t: T, out: &mut [SVector<T, D>]) {
        if t < T::zero() {
            self.start.coast(t, out);
        } else if t > self.duration {
            self.end.coast(t - self.duration, out);
        } else {
            self.polynomial(t, out);
        }
    }
}

checked! {
    [T: Scalar, const D: usize] Quintic<T, D>, [T]
    { start: Boundary<T, D>, end: Boundary<T, D>, duration: T; coefficients } =>
    Self::new(start, end, duration)
}
