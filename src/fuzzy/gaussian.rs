use crate::{
    Error, Scalar,
    error::{finite, positive},
};

/// A Gaussian membership function μ(e) = exp(−½·((e − c)/σ)²) with centre c and width σ > 0, both in the units of e (eq_mu).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaussian<T> {
    centre: T,
    width: T,
}

impl<T: Scalar> Gaussian<T> {
    /// A membership function with centre c and width σ.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a width σ ≤ 0, [`Error::NonFinite`] for either not finite.
    pub fn new(centre: T, width: T) -> Result<Self, Error> {
        Ok(Self { centre: finite("centre", centre)?, width: positive("width", width)? })
    }

    /// The centre c.
    pub fn centre(&self) -> T {
        self.centre
    }

    /// The width σ.
    pub fn width(&self) -> T {
        self.width
    }

    /// The distance from the centre in widths: M = (e − c)/σ.
    pub fn distance(&self, e: T) -> T {
        (e - self.centre) / self.width
    }

    /// The membership grade μ(e), between 0 and 1.
    pub fn grade(&self, e: T) -> T {
        let m = self.distance(e);
        (m * m * crate::scalar::constant(-0.5)).exp()
    }

    /// The same function moved by `by` along e, as far as the range of `T` goes.
    pub(super) fn shifted(&self, by: T) -> Self {
        let moved = self.centre + by;
        let centre = if moved.is_finite() {
            moved
        } else {
            T::max_value().map_or(moved, |most| most.copysign(moved))
        };
        Self { centre, width: self.width }
    }

    /// The same function after the flow d ↦ d·e^{−τ}, M² ↦ M² + 2τ, as seen from an input at 0.
    pub(super) fn flowed(&self, tau: T) -> Self {
        if tau.is_zero() {
            return *self;
        }
        let m = self.distance(T::zero());
        let shrinking = (-tau).exp();
        // M⁺²/M², in which an M² beyond the range of `T` does not move.
        let growth = T::one() + (tau + tau) / (m * m);
        Self { centre: self.centre * shrinking, width: self.width * shrinking / growth.sqrt() }
    }
}

checked! { [T: Scalar] Gaussian<T>, [T] { centre: T, width: T } => Self::new(centre, width) }
