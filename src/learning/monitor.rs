use super::Certificate;
use crate::{
    Error, Scalar,
    error::{finite, not_negative},
};

/// Compares |s| at run time with what a [`Certificate`] allows.
///
/// From the first |s| on it carries along the largest true |s| that is possible while |Δ̇| ≤ B, sample by sample. A greater one means
/// that an assumption has failed: Δ moves faster than B, or the ė_n behind s is farther off than was said. After a violation the
/// bound starts again from the |s| found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Monitor<T> {
    certificate: Certificate<T>,
    slack: T,
    possible: Option<T>,
}

/// What the monitor found at one sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict<T> {
    /// The largest |s| that the certificate allows at this sample.
    pub allowed: T,
    /// Whether |s| is no larger.
    pub holds: bool,
}

impl<T: Scalar> Monitor<T> {
    /// A monitor that has seen no sample yet, to be called once a period of the certificate. `slack` ≥ 0 is how far s may be off,
    /// by noise, delay or rounding of ė_n.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`] for the slack.
    pub fn new(certificate: Certificate<T>, slack: T) -> Result<Self, Error> {
        Ok(Self { certificate, slack: not_negative("slack", slack)?, possible: None })
    }

    /// Judges the next s.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for an s that is not finite, or a bound on it beyond the range of `T`; the monitor is then as before.
    pub fn update(&mut self, s: T) -> Result<Verdict<T>, Error> {
        let size = finite("s", s)?.abs();
        let possible = match self.possible {
            None => size + self.slack,
            Some(last) => self.certificate.worst_noisy(last, self.slack),
        };
        let allowed = finite("allowed s", possible + self.slack)?;
        let holds = size <= allowed;
        let possible = if holds { possible } else { finite("possible s", size + self.slack)? };
        self.possible = Some(possible);
        Ok(Verdict { allowed, holds })
    }

    /// Forgets the samples so far.
    pub fn reset(&mut self) {
        self.possible = None;
    }
}

checked! {
    [T: Scalar] Monitor<T>, [T]
    { certificate: Certificate<T>, slack: T, possible: Option<T> } =>
    Self::new(certificate, slack).and_then(|new| {
        not_negative("possible s", possible.unwrap_or(slack))?;
        Ok(Self { possible, ..new })
    })
}
