use super::Certificate;
use crate::{
    Error, Scalar,
    error::{finite, not_negative},
};

/// Trips when |s| has been above what a [`Certificate`] allows for too long.
///
/// From the first |s| on it carries along the bound that |Δ̇| ≤ B implies, down to the residual. A jump of Δ lifts |s| above it, and
/// learning brings |s| back within |jump|/(α − B): the patience should be that of the largest jump to be expected. What stays above for
/// longer is a learner that does not do its work: ė_n is wrong, the actuator is saturated, Δ is faster than B, or b(x) has the wrong
/// sign.
///
/// It only says so. What follows is the loop's decision: go on and tell somebody, or fall back to plain feedback with
/// [`Supervised`](crate::controller::Supervised).
///
/// A [`Monitor`](super::Monitor) reports every single violation instead, and takes each for a new start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watchdog<T> {
    certificate: Certificate<T>,
    slack: T,
    patience: T,
    possible: Option<T>,
    late: T,
    tripped: bool,
}

/// What the watchdog found at one sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch<T> {
    /// The largest |s| that the certificate allows at this sample.
    pub allowed: T,
    /// For how many seconds |s| has been above that, without a break.
    pub late: T,
    /// Whether that has been too long, at this sample or at one before.
    pub tripped: bool,
}

impl<T: Scalar> Watchdog<T> {
    /// A watchdog that has seen no sample yet, to be called once a period of the certificate. `slack` ≥ 0 is how far s may be off, by noise,
    /// delay or rounding of ė_n; `patience` ≥ 0 in seconds is for how long |s| may be above the bound.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`] for the slack or the patience.
    pub fn new(certificate: Certificate<T>, slack: T, patience: T) -> Result<Self, Error> {
        Ok(Self {
            certificate,
            slack: not_negative("slack", slack)?,
            patience: not_negative("patience", patience)?,
            possible: None,
            late: T::zero(),
            tripped: false,
        })
    }

    /// Judges the next s. Once it has tripped it stays so until [`reset`](Self::reset).
    ///
    /// # Errors
    /// [`Error::NonFinite`] for an s that is not finite, or a bound on it or a time beyond the range of `T`; the watchdog is then as before.
    pub fn update(&mut self, s: T) -> Result<Watch<T>, Error> {
        let size = finite("s", s)?.abs();
        let possible = match self.possible {
            None => size + self.slack,
            Some(last) => self.certificate.worst_noisy(last, self.slack),
        };
        let allowed = finite("allowed s", possible + self.slack)?;
        // Added up only while it matters: a long violation cannot stall in rounding.
        let late = if size <= allowed { T::zero() } else { self.late + self.certificate.dt() };
        self.late = finite("time above the bound", late)?;
        self.tripped |= self.late > self.patience;
        self.possible = Some(possible);
        Ok(Watch { allowed, late: self.late, tripped: self.tripped })
    }

    /// Forgets the samples so far, and that it had tripped.
    pub fn reset(&mut self) {
        *self = Self { possible: None, late: T::zero(), tripped: false, ..*self };
    }
}
