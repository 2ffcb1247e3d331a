use core::fmt;

use nalgebra::SVector;

use super::{
    Adaptive, Attempt, Dense, Discontinuities, Embedded, Point, Statistics,
    step_control::StepControl,
};
use crate::{
    Error, Scalar,
    error::{below, finite, finite_vector, value},
};

/// The solution of ẋ = f(t, x) from one state on, a step at a time.
///
/// | call | where it ends |
/// |---|---|
/// | [`step`](Self::step) | where the error of one step allows |
/// | [`advance`](Self::advance) | at the time given, with f never taken beyond it |
/// | [`at`](Self::at) | in or at the end of the step that holds the time given, whose state it interpolates: outputs do not change the steps |
/// | [`next_event`](Self::next_event) | at the time given, or at a terminal event before it |
///
/// Where f jumps in time, [declare it](Self::with_discontinuities): no step crosses a declared time, and the solver starts anew there. A jump
/// that is not declared costs rejected steps, and what is smeared over the step that finds it. Where the state jumps,
/// [`restart`](Self::restart).
///
/// After an `Err` the solver stands at the last good t and x, and only its statistics have moved.
pub struct Solver<'a, M: Embedded<T, N>, F, T: Scalar, const N: usize> {
    pub(super) settings: Adaptive<M, T, N>,
    pub(super) f: F,
    pub(super) discontinuities: Discontinuities<'a, T>,
    pub(super) t: T,
    pub(super) x: SVector<T, N>,
    /// f(t, x), if it is known already.
    pub(super) rate: Option<SVector<T, N>>,
    /// How long the next step may be; unknown at the start and after a jump.
    pub(super) h: Option<T>,
    pub(super) control: StepControl<T>,
    pub(super) last: Option<Step<M, T, N>>,
    pub(super) statistics: Statistics,
}

/// The last step, from which the solution within it follows.
pub(super) struct Step<M: Embedded<T, N>, T: Scalar, const N: usize> {
    pub(super) from: Point<T, N>,
    pub(super) h: T,
    pub(super) attempt: Attempt<T, N, M::Stages>,
}

impl<M: Embedded<T, N>, F, T: Scalar, const N: usize> Solver<'static, M, F, T, N> {
    pub(super) fn new(settings: Adaptive<M, T, N>, f: F, t: T, x: SVector<T, N>) -> Self {
        Self {
            settings,
            f,
            discontinuities: Discontinuities::default(),
            t,
            x,
            rate: None,
            h: None,
            control: StepControl::new(),
            last: None,
            statistics: Statistics::default(),
        }
    }
}

impl<'a, M: Embedded<T, N>, F, T: Scalar, const N: usize> Solver<'a, M, F, T, N> {
    /// The same solver with the `times` in seconds, in ascending order, at which f jumps: to its value for t ≥ time.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for a time, [`Error::NotBelow`] for two that do not ascend.
    pub fn with_discontinuities<'b>(self, times: &'b [T]) -> Result<Solver<'b, M, F, T, N>, Error> {
        Ok(Solver {
            discontinuities: Discontinuities::new(times)?,
            settings: self.settings,
            f: self.f,
            t: self.t,
            x: self.x,
            rate: self.rate,
            h: self.h,
            control: self.control,
            last: self.last,
            statistics: self.statistics,
        })
    }

    /// The time t.
    pub fn time(&self) -> T {
        self.t
    }

    /// The state x(t).
    pub fn state(&self) -> &SVector<T, N> {
        &self.x
    }

    /// What was spent so far.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// The time at which the last step started; t before the first, and after a restart.
    pub fn step_start(&self) -> T {
        self.last.as_ref().map_or(self.t, |last| last.from.t)
    }

    /// x(`t`) within the last step, by the method's dense output.
    ///
    /// # Errors
    /// [`Error::NotBelow`] for a time outside of the last step, [`Error::NonFinite`] for one that is not finite, [`Error::NonFiniteEntry`] for a
    /// state that is not, between two large ones.
    pub fn interpolate(&self, t: T) -> Result<SVector<T, N>, Error> {
        finite("t", t)?;
        at_most("t", t, self.t)?;
        at_most("start of the step", self.step_start(), t)?;
        match self.dense() {
            Some(dense) if t < self.t => dense.at(t),
            _ => Ok(self.x),
        }
    }

    /// The same time with the state `x`: an impact, a switch, anything that the last step does not lead to. What the solver knows of f is
    /// discarded, and so is the last step.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn restart(&mut self, x: impl Into<SVector<T, N>>) -> Result<(), Error> {
        let x = x.into();
        finite_vector("x", &x)?;
        self.x = x;
        self.last = None;
        self.forget();
        Ok(())
    }

    /// The solution within the last step.
    pub(in crate::integrators) fn dense(&self) -> Option<Dense<T, N>> {
        self.last.as_ref().map(|Step { from, h, attempt }| Dense {
            t: from.t,
            h: *h,
            x: from.x,
            d: self.settings.method.dense(from, attempt, *h),
        })
    }

    /// Goes back to `x`(`t`) within the last step, keeping the length of steps.
    pub(in crate::integrators) fn go_back(&mut self, t: T, x: SVector<T, N>) {
        self.t = t;
        self.x = x;
        self.rate = None;
    }

    pub(super) fn forget(&mut self) {
        self.rate = None;
        self.h = None;
        self.control = StepControl::new();
    }
}

impl<M: Embedded<T, N>, F, T: Scalar, const N: usize> Solver<'_, M, F, T, N>
where
    F: FnMut(T, &SVector<T, N>) -> SVector<T, N>,
{
    /// One step within the tolerance, up to the next discontinuity at most. f may be taken anywhere in it, and is for a step that is
    /// rejected further on than it ends.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for a step beyond the range of `T`; [`Error::NonFiniteRate`] if f is not finite at t; [`Error::StepTooSmall`] if no step that changes t is within the tolerance: at a
    /// pole or a jump, where f is not finite further on, or where rounding alone is more than the tolerance.
    pub fn step(&mut self) -> Result<(), Error> {
        self.step_towards(None)
    }

    /// The state at `t_end` in seconds, where a step ends; f is not taken beyond it.
    ///
    /// # Errors
    /// As [`step`](Self::step); [`Error::NotBelow`] for a `t_end` before t, [`Error::NonFinite`] for one that is not finite, and
    /// [`Error::TooManySteps`].
    pub fn advance(&mut self, t_end: T) -> Result<&SVector<T, N>, Error> {
        finite("t_end", t_end)?;
        at_most("t", self.t, t_end)?;
        let start = self.attempts();
        while self.t < t_end {
            self.step_towards(Some(t_end))?;
            self.within_limit(start)?;
        }
        Ok(&self.x)
    }

    /// x(`t`), with steps as they would be without it: as many as it takes for the last one to hold t, by the method's dense output.
    ///
    /// # Errors
    /// As [`step`](Self::step) and [`interpolate`](Self::interpolate), and [`Error::TooManySteps`].
    pub fn at(&mut self, t: T) -> Result<SVector<T, N>, Error> {
        finite("t", t)?;
        let start = self.attempts();
        while self.t < t {
            self.step()?;
            self.within_limit(start)?;
        }
        self.interpolate(t)
    }

    pub(in crate::integrators) fn attempts(&self) -> u64 {
        self.statistics.accepted + self.statistics.rejected
    }

    /// The steps tried since there were `start` of them are not too many.
    pub(in crate::integrators) fn within_limit(&self, start: u64) -> Result<(), Error> {
        let limit = self.settings.step_limit;
        if self.attempts() - start <= limit {
            Ok(())
        } else {
            Err(Error::TooManySteps { time: value(self.t), limit })
        }
    }
}

/// Where the solution stands; f need not be printable.
impl<M: Embedded<T, N> + fmt::Debug, F, T: Scalar, const N: usize> fmt::Debug
    for Solver<'_, M, F, T, N>
{
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Solver")
            .field("settings", &self.settings)
            .field("t", &self.t)
            .field("x", &self.x)
            .field("h", &self.h)
            .field("statistics", &self.statistics)
            .finish_non_exhaustive()
    }
}

/// `x`, if it is not above `limit`; both are finite already.
pub(in crate::integrators) fn at_most<T: Scalar>(
    name: &'static str,
    x: T,
    limit: T,
) -> Result<T, Error> {
    if x == limit { Ok(x) } else { below(name, x, limit) }
}
