use nalgebra::SVector;

use super::{Leakage, Projection};
#[cfg(feature = "serde")]
use crate::error::at_most;
use crate::{
    Error, Scalar,
    error::{below, positive, value},
};

/// θ̂ and κ̂.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parameters<T, const L: usize> {
    pub theta: SVector<T, L>,
    pub kappa: T,
}

/// How they are learned, and where they started.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Learning<T, const L: usize> {
    rate: T,
    leakage: Leakage<T>,
    projection: Projection<T, L>,
    /// γ_κ with the range of κ̂, if Λ is not known.
    effectiveness: Option<(T, [T; 2])>,
    pub initial: Parameters<T, L>,
}

impl<T: Scalar, const L: usize> Learning<T, L> {
    pub fn new(rate: T) -> Result<Self, Error> {
        Ok(Self {
            rate: positive("rate of learning", rate)?,
            leakage: Leakage::None,
            projection: Projection::None,
            effectiveness: None,
            initial: Parameters { theta: SVector::zeros(), kappa: T::one() },
        })
    }

    pub fn with_leakage(self, leakage: Leakage<T>) -> Result<Self, Error> {
        Ok(Self { leakage: leakage.validated()?, ..self })
    }

    pub fn with_projection(self, projection: Projection<T, L>) -> Result<Self, Error> {
        Ok(Self { projection: projection.validated()?, ..self }.starting(self.initial))
    }

    pub fn with_effectiveness(self, rate: T, [lower, upper]: [T; 2]) -> Result<Self, Error> {
        positive("rate of learning", rate)?;
        below("lower", positive("lower", lower)?, positive("upper", upper)?)?;
        let adaptive = Self { effectiveness: Some((rate, [lower, upper])), ..self };
        Ok(adaptive.starting(self.initial))
    }

    /// The same from other parameters, as far as they are allowed.
    pub fn starting(self, initial: Parameters<T, L>) -> Self {
        Self { initial: self.allowed(initial), ..self }
    }

    fn allowed(&self, Parameters { theta, kappa }: Parameters<T, L>) -> Parameters<T, L> {
        let theta = self.projection.nearest(theta);
        let known = [T::one(); 2];
        let [lower, upper] = self.effectiveness.map_or(known, |(_, range)| range);
        Parameters { theta, kappa: kappa.max(lower).min(upper) }
    }

    /// Checks that `parameters` are where they are kept.
    #[cfg(feature = "serde")]
    pub fn allows(&self, parameters: &Parameters<T, L>) -> Result<(), Error> {
        let allowed = self.allowed(*parameters);
        let outside = (parameters.theta - allowed.theta).amax();
        at_most("distance of theta from the projection", outside, T::zero())?;
        let outside = (parameters.kappa - allowed.kappa).abs();
        at_most("distance of kappa from its range", outside, T::zero())?;
        Ok(())
    }

    /// What `now` becomes after a period `dt` in which φ = `phi` and μ = `mu` were what made `s`; `reach` is what a unit of ẋ_n over the period
    /// makes of s.
    pub fn learned(
        &self,
        now: &Parameters<T, L>,
        (phi, mu): (&SVector<T, L>, T),
        s: T,
        reach: T,
        dt: T,
    ) -> Parameters<T, L> {
        let (of_kappa, strongest) = match self.effectiveness {
            None => (T::zero(), T::one()),
            Some((rate, [lower, _])) => (rate, lower.recip()),
        };
        let excitation = self.rate * phi.norm_squared() + of_kappa * mu * mu;
        let step = dt / (T::one() + reach * dt * excitation * strongest) * s;
        let leak = self.rate * dt * self.leakage.rate(s);
        let moved = now.theta - phi * (self.rate * step) + self.initial.theta * leak;
        let next = self.allowed(Parameters {
            theta: moved / (T::one() + leak),
            kappa: now.kappa + of_kappa * step * mu,
        });
        let usable = next.theta.iter().all(|theta| usable(*theta)) && usable(next.kappa);
        if usable { next } else { *now }
    }
}

/// Whether products of two such numbers are within the range of `T`, with room for a rate or a gain.
pub(super) fn usable<T: Scalar>(x: T) -> bool {
    x.abs() <= T::max_value().unwrap_or(T::one()).cbrt()
}

/// `x`, which is to be remembered, if it is [`usable`].
pub(super) fn remembered<T: Scalar>(name: &'static str, x: T) -> Result<T, Error> {
    if usable(x) { Ok(x) } else { Err(Error::NonFinite { name, value: value(x) }) }
}

checked! {
    [T: Scalar, const L: usize] Parameters<T, L>, [T] { theta: SVector<T, L>, kappa: T } =>
    known("theta", theta.iter().copied()).and_then(|()| {
        Ok(Self { theta, kappa: positive("kappa", kappa)? })
    })
}

checked! {
    [T: Scalar, const L: usize] Learning<T, L>, [T]
    {
        rate: T,
        leakage: Leakage<T>,
        projection: Projection<T, L>,
        effectiveness: Option<(T, [T; 2])>,
        initial: Parameters<T, L>,
    } =>
    Self::new(rate).and_then(|new| {
        let learning = new.with_leakage(leakage)?.with_projection(projection)?;
        let learning = match effectiveness {
            Some((rate, range)) => learning.with_effectiveness(rate, range)?,
            None => learning,
        };
        learning.allows(&initial)?;
        Ok(Self { initial, ..learning })
    })
}
