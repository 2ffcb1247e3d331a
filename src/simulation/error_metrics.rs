use crate::{
    Error, Scalar,
    error::{below, finite},
    scalar::constant,
};

/// Integrals of an error e(t), by the trapezoidal rule over the samples given.
///
/// | figure | definition |
/// |---|---|
/// | IAE | ∫\|e\| dt |
/// | ISE | ∫e² dt |
/// | ITAE | ∫t·\|e\| dt, t counted from the first sample |
/// | RMS | √(ISE/duration) |
/// | maximum | max \|e\| |
///
/// To judge the steady state, push only the samples that belong to it: the maximum and the RMS are then the steady-state error, also
/// where it does not come to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorMetrics<T> {
    start: T,
    last: Option<(T, T)>,
    iae: T,
    ise: T,
    itae: T,
    maximum: T,
}

impl<T: Scalar> Default for ErrorMetrics<T> {
    fn default() -> Self {
        Self {
            start: T::zero(),
            last: None,
            iae: T::zero(),
            ise: T::zero(),
            itae: T::zero(),
            maximum: T::zero(),
        }
    }
}

impl<T: Scalar> ErrorMetrics<T> {
    /// Metrics of all `samples` (t, e), in order of time.
    ///
    /// # Errors
    /// As [`push`](Self::push).
    pub fn of(samples: impl IntoIterator<Item = (T, T)>) -> Result<Self, Error> {
        let mut metrics = Self::default();
        for (t, e) in samples {
            metrics.push(t, e)?;
        }
        Ok(metrics)
    }

    /// Takes the next sample e(t).
    ///
    /// # Errors
    /// [`Error::NonFinite`] for either or for an integral that leaves the range of `T`, [`Error::NotBelow`] if time does not advance;
    /// the sample is then not taken.
    pub fn push(&mut self, t: T, e: T) -> Result<(), Error> {
        finite("t", t)?;
        let size = finite("e", e)?.abs();
        let mut next = *self;
        match self.last {
            None => next.start = t,
            Some((before, last)) => {
                below("time of the sample before", before, t)?;
                let half = finite("time between samples", t - before)? * constant(0.5);
                next.iae = finite("IAE", next.iae + half * (last + size))?;
                next.ise = finite("ISE", next.ise + half * (last * last + size * size))?;
                let weighted = (before - self.start) * last + (t - self.start) * size;
                next.itae = finite("ITAE", next.itae + half * weighted)?;
            }
        }
        next.maximum = self.maximum.max(size);
        next.last = Some((t, size));
        *self = next;
        Ok(())
    }

    /// ∫|e| dt.
    pub fn iae(&self) -> T {
        self.iae
    }

    /// ∫e² dt.
    pub fn ise(&self) -> T {
        self.ise
    }

    /// ∫t·|e| dt with t from the first sample.
    pub fn itae(&self) -> T {
        self.itae
    }

    /// max |e|.
    pub fn maximum(&self) -> T {
        self.maximum
    }

    /// √(ISE/duration); `None` before the second sample.
    pub fn rms(&self) -> Option<T> {
        let duration = self.last?.0 - self.start;
        (duration > T::zero()).then(|| (self.ise / duration).sqrt())
    }
}

checked! {
    [T: Scalar] ErrorMetrics<T>, [T]
    { start: T, last: Option<(T, T)>, iae: T, ise: T, itae: T, maximum: T } =>
    known("start", [start]).and_then(|()| {
        if let Some((t, size)) = last {
            not_negative("time since the first sample", t - start)?;
            not_negative("last |e|", size)?;
        }
        Ok(Self {
            start,
            last,
            iae: not_negative("IAE", iae)?,
            ise: not_negative("ISE", ise)?,
            itae: not_negative("ITAE", itae)?,
            maximum: not_negative("maximum", maximum)?,
        })
    })
}
