use super::Certificate;
use crate::{
    Error, Scalar,
    error::{finite, not_negative},
};

/// Trips when |s| has been above what a [`Certificate`] allows for too long.
///
/// From the first |s| on it carries along the bound that |Δ̇| ≤ B implies, down to the residual. A jump of Δ lifts |s| above it, and
/// learning brings |s| back: the patience should be the [recovery time](Certificate::recovery_time) of the largest jump to be expected, the
/// slack by its `within` larger than s may be off. What stays above for longer is a learner that does not do its work: ė_n is wrong, the
/// input does not arrive, Δ is faster than B, or the model's b(x) is far off.
/// Its clock runs back while |s| is within the bound: an s that swings through zero does not stop it, and jumps may follow one another when
/// |s| has been within for as long as it was not.
///
/// The certificate says nothing of samples at which nothing is learned. Where u_n also moves with e, because the antecedents are
/// [`Fixed`](super::Fixed), B has to cover that too.
///
/// It only says so. [`Guarded`](super::Guarded) puts it on a compensator, with the fall-back to plain feedback.
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
    /// For how many seconds |s| has been above that, less those for which it was not.
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
        let dt = self.certificate.dt();
        let late = if size > allowed { self.late + dt } else { (self.late - dt).max(T::zero()) };
        self.late = finite("time above the bound", late)?;
        self.tripped |= self.late > self.patience;
        self.possible = Some(possible);
        Ok(Watch { allowed, late: self.late, tripped: self.tripped })
    }

    /// Whether it has tripped.
    pub fn tripped(&self) -> bool {
        self.tripped
    }

    /// Forgets the samples so far, and that it had tripped.
    pub fn reset(&mut self) {
        *self = Self { possible: None, late: T::zero(), tripped: false, ..*self };
    }
}

checked! {
    [T: Scalar] Watchdog<T>, [T]
    {
        certificate: Certificate<T>,
        slack: T,
        patience: T,
        possible: Option<T>,
        late: T,
        tripped: bool,
    } =>
    Self::new(certificate, slack, patience).and_then(|new| {
        not_negative("possible s", possible.unwrap_or(slack))?;
        Ok(Self { possible, late: not_negative("time above the bound", late)?, tripped, ..new })
    })
}
