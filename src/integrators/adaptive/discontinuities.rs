use crate::{
    Error, Scalar,
    error::{below, finite},
    scalar::epsilon,
};

/// Times at which f jumps, in ascending order. No step crosses one, and f acts with its new value from that time on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Discontinuities<'a, T>(&'a [T]);

impl<T> Default for Discontinuities<'_, T> {
    fn default() -> Self {
        Self(&[])
    }
}

impl<'a, T: Scalar> Discontinuities<'a, T> {
    /// # Errors
    /// [`Error::NonFinite`] for a time, [`Error::NotBelow`] for two that do not ascend.
    pub(crate) fn new(times: &'a [T]) -> Result<Self, Error> {
        for &time in times {
            finite("discontinuity", time)?;
        }
        for (&time, &next) in times.iter().zip(times.iter().skip(1)) {
            below("discontinuity", time, next)?;
        }
        Ok(Self(times))
    }

    /// The first one after `t`.
    pub(crate) fn after(&self, t: T) -> Option<T> {
        self.0.get(self.0.partition_point(|time| *time <= t)).copied()
    }
}

/// The last time before `end` that a step from `start` shows to f, so that it does not see what begins at `end`.
pub(crate) fn just_before<T: Scalar>(start: T, end: T) -> T {
    end - end.abs().max(start.abs()) * epsilon()
}
