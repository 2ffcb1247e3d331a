use crate::{Error, Scalar, error::finite};

/// Σ |u(k+1) − u(k)|: how much a signal moves, the measure of chattering.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TotalVariation<T> {
    last: Option<T>,
    sum: T,
}

impl<T: Scalar> Default for TotalVariation<T> {
    fn default() -> Self {
        Self { last: None, sum: T::zero() }
    }
}

impl<T: Scalar> TotalVariation<T> {
    /// The total variation of all `samples`.
    ///
    /// # Errors
    /// As [`push`](Self::push).
    pub fn of(samples: impl IntoIterator<Item = T>) -> Result<T, Error> {
        let mut variation = Self::default();
        for u in samples {
            variation.push(u)?;
        }
        Ok(variation.value())
    }

    /// Takes the next sample.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for it or for a sum that leaves the range of `T`; the sample is then not taken.
    pub fn push(&mut self, u: T) -> Result<(), Error> {
        let last = self.last.unwrap_or(finite("u", u)?);
        let sum = finite("total variation", self.sum + (u - last).abs())?;
        *self = Self { last: Some(u), sum };
        Ok(())
    }

    /// The total variation so far.
    pub fn value(&self) -> T {
        self.sum
    }
}

checked! {
    [T: Scalar] TotalVariation<T>, [T] { last: Option<T>, sum: T } =>
    known("last u", last).and_then(|()| {
        Ok(Self { last, sum: not_negative("total variation", sum)? })
    })
}
