use crate::{
    Error, Scalar,
    error::{below, finite, value},
    scalar::constant,
};

/// Characteristics of a step response y(t) from y_init to y_final, by the definitions of MATLAB's `stepinfo`.
///
/// Everything refers to the normalized response η(t) = (y(t) − y_init)/(y_final − y_init), so falling responses need no special case.
/// Crossings between samples are interpolated linearly. Feed samples in order of time with [`push`](Self::push).
///
/// # References
/// The MathWorks, Control System Toolbox, `stepinfo`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepInfo<T> {
    initial: T,
    span: T,
    last: Option<(T, T)>,
    start: T,
    rise_start: Option<T>,
    rise_end: Option<T>,
    settled: Option<T>,
    highest: T,
    lowest: T,
    peak: T,
    peak_time: T,
}

impl<T: Scalar> StepInfo<T> {
    /// A response from `y_init` that is meant to end at `y_final`; no sample yet.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for either, [`Error::Singular`] if they are equal.
    pub fn new(y_init: T, y_final: T) -> Result<Self, Error> {
        let span = finite("y_final", y_final)? - finite("y_init", y_init)?;
        if span.is_zero() {
            return Err(Error::Singular { name: "y_final - y_init", value: value(span) });
        }
        Ok(Self {
            initial: y_init,
            span: finite("y_final - y_init", span)?,
            last: None,
            start: T::zero(),
            rise_start: None,
            rise_end: None,
            settled: None,
            highest: T::zero(),
            lowest: T::zero(),
            peak: T::zero(),
            peak_time: T::zero(),
        })
    }

    /// The characteristics of all `samples` (t, y), in order of time.
    ///
    /// # Errors
    /// As [`new`](Self::new) and [`push`](Self::push).
    pub fn of(
        samples: impl IntoIterator<Item = (T, T)>,
        y_init: T,
        y_final: T,
    ) -> Result<Self, Error> {
        let mut info = Self::new(y_init, y_final)?;
        for (t, y) in samples {
            info.push(t, y)?;
        }
        Ok(info)
    }

    /// Takes the next sample y(t).
    ///
    /// # Errors
    /// [`Error::NonFinite`] for either or for a figure that leaves the range of `T`, [`Error::NotBelow`] if time does not advance; the
    /// sample is then not taken.
    pub fn push(&mut self, t: T, y: T) -> Result<(), Error> {
        finite("t", t)?;
        let eta = finite("normalized y", (finite("y", y)? - self.initial) / self.span)?;
        if let Some((before, _)) = self.last {
            below("time of the sample before", before, t)?;
            finite("time since the first sample", t - self.start)?;
        }
        finite("normalized y in percent", eta * constant(100.0))?;
        finite("y_final - y", (T::one() - eta) * self.span)?;
        let from = self.last.unwrap_or((t, eta));
        let to = (t, eta);
        if self.last.is_none() {
            self.start = t;
        }
        if self.rise_start.is_none() && eta >= constant(0.1) {
            self.rise_start = Some(crossing(from, to, constant(0.1)));
        }
        if self.rise_end.is_none() && eta >= constant(0.9) {
            self.rise_end = Some(crossing(from, to, constant(0.9)));
        }
        self.settle(from, to);
        self.highest = self.highest.max(eta);
        self.lowest = self.lowest.min(eta);
        if self.last.is_none() || y.abs() > self.peak {
            self.peak = y.abs();
            self.peak_time = t;
        }
        self.last = Some(to);
        Ok(())
    }

    /// The response is settled from the last time on at which it entered the 2 % band.
    fn settle(&mut self, from: (T, T), to: (T, T)) {
        let band = constant::<T>(0.02);
        if (to.1 - T::one()).abs() > band {
            self.settled = None;
        } else if self.settled.is_none() {
            let edge = if from.1 < to.1 { -band } else { band };
            self.settled = Some(crossing(from, to, T::one() + edge));
        }
    }

    /// The time from 10 % to 90 % of the way, in seconds; `None` if 90 % is not reached.
    pub fn rise_time(&self) -> Option<T> {
        Some(self.rise_end? - self.rise_start?)
    }

    /// The time from the first sample until |y − y_final| stays within 2 % of |y_final − y_init|, in seconds; `None` if it is
    /// outside at the last sample.
    pub fn settling_time(&self) -> Option<T> {
        self.settled.map(|settled| settled - self.start)
    }

    /// How far the response goes beyond y_final, in percent of |y_final − y_init|; 0 if it does not.
    pub fn overshoot(&self) -> T {
        (self.highest - T::one()).max(T::zero()) * constant(100.0)
    }

    /// How far the response goes to the wrong side of y_init, in percent of |y_final − y_init|; 0 if it does not.
    pub fn undershoot(&self) -> T {
        self.lowest.abs() * constant(100.0)
    }

    /// y_final − y at the last sample, in the units of y; `None` before the first.
    pub fn steady_state_error(&self) -> Option<T> {
        self.last.map(|(_, eta)| (T::one() - eta) * self.span)
    }

    /// The largest |y|.
    pub fn peak(&self) -> T {
        self.peak
    }

    /// The time at which |y| is largest, in seconds.
    pub fn peak_time(&self) -> T {
        self.peak_time
    }
}

/// The time at which the line from one sample to the next is at `level`; that of the second if the first is past it or the line is
/// level.
fn crossing<T: Scalar>(from: (T, T), to: (T, T), level: T) -> T {
    let rise = to.1 - from.1;
    let part = (level - from.1) / rise;
    if rise.is_zero() || part < T::zero() || part > T::one() {
        to.0
    } else {
        from.0 + (to.0 - from.0) * part
    }
}

checked! {
    [T: Scalar] StepInfo<T>, [T]
    {
        initial: T,
        span: T,
        last: Option<(T, T)>,
        start: T,
        rise_start: Option<T>,
        rise_end: Option<T>,
        settled: Option<T>,
        highest: T,
        lowest: T,
        peak: T,
        peak_time: T,
    } =>
    Self::new(T::zero(), span).and_then(|_| {
        known("y_init", [initial])?;
        known("times", [rise_start, rise_end, settled, Some(start), Some(peak_time)].into_iter().flatten())?;
        if let Some((t, eta)) = last {
            not_negative("time since the first sample", t - start)?;
            finite("normalized y", eta)?;
        }
        Ok(Self {
            initial,
            span,
            last,
            start,
            rise_start,
            rise_end,
            settled,
            highest: not_negative("highest normalized y", highest)?,
            lowest: -not_negative("-lowest normalized y", -lowest)?,
            peak: not_negative("peak", peak)?,
            peak_time,
        })
    })
}
