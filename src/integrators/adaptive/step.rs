use core::cmp::Ordering;

use nalgebra::SVector;

use super::{
    Attempt, Embedded, Point, Solver, Tolerance, discontinuities::just_before,
    initial_step::initial_step, solver::Step, step_control::StepControl, tolerance::norm,
};
use crate::{
    Error, Scalar,
    error::{finite, value},
    scalar::{constant, epsilon},
};

impl<M: Embedded<T, N>, F, T: Scalar, const N: usize> Solver<'_, M, F, T, N>
where
    F: FnMut(T, &SVector<T, N>) -> SVector<T, N>,
{
    /// One step within the tolerance, not beyond `stop` nor the next discontinuity.
    pub(in crate::integrators) fn step_towards(&mut self, stop: Option<T>) -> Result<(), Error> {
        let jump =
            self.discontinuities.after(self.t).filter(|jump| stop.is_none_or(|t| *jump <= t));
        let end = jump.or(stop);
        // What begins at the jump is not shown to a step that ends there.
        let latest = jump.map(|jump| just_before(self.t, jump)).or(stop);
        let (settings, t, x) = (&self.settings, self.t, self.x);
        let mut f = |time: T, x: &SVector<T, N>| {
            self.statistics.evaluations += 1;
            // What surrounds a time at the end of the range is not asked for.
            let time = if time.is_finite() { time } else { t };
            (self.f)(latest.map_or(time, |latest| time.min(latest)), x)
        };
        let rate = match self.rate {
            Some(rate) => rate,
            None => finite_rate(t, f(t, &x))?,
        };
        let from = Point { t, x, rate };
        let weights = settings.tolerance.weights(&x, &x);
        let left = end.map(|end| end - t);
        let mut h = self
            .h
            .or(settings.first_step)
            .unwrap_or_else(|| initial_step(&mut f, &from, &weights, M::ORDER, left));
        if let Some(longest) = settings.longest_step {
            h = h.min(longest);
        }
        let within = left.map_or(h, |left| h.min(left));
        let linearization = settings.method.linearize(&mut f, &from, within, &weights);
        self.statistics.jacobians += u64::from(M::LINEARIZES);

        let shortest = t.abs() * epsilon::<T>() * constant(10.0);
        let mut rejected = false;
        let (error, length) = loop {
            // A little longer rather than a tiny step at the end.
            let reached = left.filter(|left| h * constant(1.01) >= *left);
            if h <= shortest && (rejected || reached.is_none()) {
                return Err(Error::StepTooSmall { time: value(t), step: value(h) });
            }
            let length = reached.unwrap_or(h);
            finite("t + h", t + length)?;
            let attempt = settings.method.attempt(&mut f, &from, &linearization, length);
            self.statistics.factorizations += u64::from(M::LINEARIZES);
            let error =
                attempt.as_ref().and_then(|attempt| error(&settings.tolerance, &x, attempt));
            match (attempt, error) {
                (Some(attempt), Some(error)) if error <= T::one() => {
                    self.x = attempt.x;
                    self.rate = attempt.rate;
                    self.last = Some(Step { from, h: length, attempt });
                    break (error, length);
                }
                _ => {
                    rejected = true;
                    self.statistics.rejected += 1;
                    let shorter = length * StepControl::rejected(error, M::ESTIMATE + 1);
                    // Among the least numbers nothing is shorter, and no end to looking for it.
                    if shorter.partial_cmp(&length) != Some(Ordering::Less) {
                        return Err(Error::StepTooSmall { time: value(t), step: value(length) });
                    }
                    h = shorter;
                }
            }
        };
        self.statistics.accepted += 1;
        let cut_short = length < h;
        let growth = if cut_short {
            self.control.cut_short(error, M::ESTIMATE + 1)
        } else {
            self.control.accepted(error, M::ESTIMATE + 1)
        };
        let next = length * if rejected { growth.min(T::one()) } else { growth };
        // Where the end cut it short, the length that was planned still holds.
        self.h = Some(if cut_short { next.max(h) } else { next });
        let arrived = left == Some(length);
        self.t = end.filter(|_| arrived).unwrap_or(t + length);
        if arrived && jump.is_some() {
            self.forget();
        }
        Ok(())
    }
}

/// The error of a step from `x` in units of the tolerance; `None` if anything in it is not finite.
fn error<T: Scalar, const N: usize, S>(
    tolerance: &Tolerance<T, N>,
    x: &SVector<T, N>,
    attempt: &Attempt<T, N, S>,
) -> Option<T> {
    let error = norm(&attempt.error, &tolerance.weights(x, &attempt.x));
    let finite = error.is_finite() && attempt.x.iter().all(|entry| entry.is_finite());
    finite.then_some(error)
}

fn finite_rate<T: Scalar, const N: usize>(
    t: T,
    rate: SVector<T, N>,
) -> Result<SVector<T, N>, Error> {
    match rate.iter().enumerate().find(|(_, entry)| !entry.is_finite()) {
        None => Ok(rate),
        Some((index, entry)) => {
            Err(Error::NonFiniteRate { time: value(t), index, value: value(*entry) })
        }
    }
}
