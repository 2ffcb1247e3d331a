//! Arc length along a polynomial: its integral, the inverse of that, and derivatives by it.

use nalgebra::SVector;

use super::{Quintic, gauss_legendre::integral};
use crate::{Error, Scalar, error::value, scalar::constant};

/// Derivatives by arc length are computed up to here.
pub(super) const ORDER: usize = 5;

const MOST_PANELS: u32 = 128;

/// A segment of a spline, seen as a curve: s(u) = ∫|x′| du from its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc<T, const D: usize> {
    pub segment: Quintic<T, D>,
    pub length: T,
    /// How many panels make the quadrature exact to rounding.
    pub panels: u32,
}

impl<T: Scalar, const D: usize> Arc<T, D> {
    /// Doubles the panels until that changes nothing but roundings.
    ///
    /// # Errors
    /// [`Error::Singular`] where the curve stands still or turns on the spot: by 90° between neighbouring nodes, or so that the most
    /// panels are not enough.
    pub fn new(segment: Quintic<T, D>) -> Result<Self, Error> {
        let h = segment.duration();
        let singular =
            |speed: T| Error::Singular { name: "speed along the spline", value: value(speed) };
        let tolerance = T::default_epsilon() * constant(64.0);
        let speed = |u| segment.velocity(u).norm();
        let mut panels = 1;
        let mut length = integral(speed, T::zero(), h, panels);
        loop {
            panels *= 2;
            let finer = integral(speed, T::zero(), h, panels);
            let settled = (finer - length).abs() <= tolerance * finer;
            length = finer;
            if settled {
                break;
            }
            if panels >= MOST_PANELS {
                return Err(singular(slowest(&segment)));
            }
        }
        let mut before = segment.velocity(T::zero());
        let nodes = panels * 8;
        for node in 1..=nodes {
            let after = segment.velocity(h * constant(f64::from(node) / f64::from(nodes)));
            if before.dot(&after) <= T::zero() {
                return Err(singular(slowest(&segment)));
            }
            before = after;
        }
        Ok(Self { segment, length, panels })
    }

    /// u(s), for 0 ≤ s ≤ length: Newton's method, with bisection where it would leave the bracket. NaN stays NaN.
    pub fn parameter(&self, s: T) -> T {
        if !s.is_finite() {
            return s;
        }
        let h = self.segment.duration();
        let close = h * T::default_epsilon() * constant(8.0);
        let (mut low, mut high) = (T::zero(), h);
        let mut u = h * (s / self.length);
        let mut excess = self.way(T::zero(), u) - s;
        for _ in 0..64 {
            if excess > T::zero() {
                high = u;
            } else {
                low = u;
            }
            let newton = u - excess / self.segment.velocity(u).norm();
            let inside = newton >= low && newton <= high;
            let next = if inside { newton } else { (low + high) * constant(0.5) };
            if (next - u).abs() <= close {
                return next;
            }
            // The steps become short, and so does what is to be integrated.
            excess += self.way(u, next);
            u = next;
        }
        u
    }

    /// The arc length between two parameters, in panels not wider than those of the whole.
    fn way(&self, from: T, to: T) -> T {
        let part = value((to - from).abs() / self.segment.duration());
        let panels = (f64::from(self.panels) * part) as u32;
        integral(|u| self.segment.velocity(u).norm(), from, to, panels + 1)
    }

    /// The coefficients yₖ of x = Σ yₖ·σᵏ in the arc length σ from x(u), up to k = `order`.
    ///
    /// With w(σ) the parameter from u on, |dx/dσ|² = 1 fixes its coefficients one after the other: w₁ = 1/|x′|, and wₙ, which enters
    /// the coefficient of σⁿ⁻¹ as 2n·wₙ/w₁, is what makes it vanish.
    pub fn series(&self, u: T, order: usize) -> [SVector<T, D>; ORDER + 1] {
        let mut x = [SVector::zeros(); ORDER + 1];
        self.segment.polynomial(u, &mut x);
        let mut factorial = T::one();
        for (k, x) in x.iter_mut().enumerate().skip(1) {
            factorial *= constant(k as f64);
            *x /= factorial;
        }
        let mut w = [T::zero(); ORDER + 1];
        let first = self.segment.velocity(u).norm().recip();
        if let Some(w) = w.get_mut(1) {
            *w = first;
        }
        for n in 2..=order.min(ORDER) {
            let excess = square_of_the_derivative(&composed(&x, &w), n - 1);
            if let Some(w) = w.get_mut(n) {
                *w = -excess * first / constant((2 * n) as f64);
            }
        }
        composed(&x, &w)
    }
}

/// The least speed among nodes, for a message.
fn slowest<T: Scalar, const D: usize>(segment: &Quintic<T, D>) -> T {
    let node = |j: u32| segment.duration() * constant(f64::from(j) / f64::from(MOST_PANELS));
    (0..=MOST_PANELS)
        .map(|j| segment.velocity(node(j)).norm())
        .reduce(|least, speed| if speed < least { speed } else { least })
        .unwrap_or(T::zero())
}

/// Σ xⱼ·w(σ)ʲ, by Horner's rule with power series cut off after σ^ORDER.
fn composed<T: Scalar, const D: usize>(
    x: &[SVector<T, D>; ORDER + 1],
    w: &[T; ORDER + 1],
) -> [SVector<T, D>; ORDER + 1] {
    let mut y = [SVector::zeros(); ORDER + 1];
    for x in x.iter().rev() {
        y = core::array::from_fn(|k| {
            let start = if k == 0 { *x } else { SVector::zeros() };
            let products = y.iter().zip(w.iter().take(k + 1).rev());
            products.fold(start, |sum, (y, w)| sum + y * *w)
        });
    }
    y
}

/// The coefficient of σⁿ in |dy/dσ|².
fn square_of_the_derivative<T: Scalar, const D: usize>(y: &[SVector<T, D>], n: usize) -> T {
    let rates = y.iter().enumerate().skip(1).take(n + 1).map(|(k, y)| y * constant::<T>(k as f64));
    let reversed = y.iter().enumerate().skip(1).take(n + 1).rev();
    let reversed = reversed.map(|(k, y)| y * constant::<T>(k as f64));
    rates.zip(reversed).fold(T::zero(), |sum, (a, b)| sum + a.dot(&b))
}
