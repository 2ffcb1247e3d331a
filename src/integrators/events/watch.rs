use core::{cmp::Ordering, fmt};

use nalgebra::SVector;

use super::{
    Crossing, Direction, Occurrence,
    crossing::crossed,
    locate::{locate, sign},
};
use crate::{
    Error, Scalar,
    error::{finite_slice, positive},
    integrators::adaptive::Dense,
    scalar::{constant, epsilon},
};

/// M functions g(t, x) whose zero crossings are events, for [`Solver::next_event`](crate::integrators::Solver::next_event).
///
/// An event is a change of sign: a function that is positive, and then is not, falls; one that is negative, and then is not, rises. It is
/// looked for at the end of each step and at points within, and located on the dense output, where the later end of a bracket of
/// 4 units of rounding (or [another width](Self::with_tolerance)) is reported: g has crossed there.
///
/// | what g does | what is found |
/// |---|---|
/// | crosses once between two points | the crossing |
/// | crosses twice between two points | nothing: raise the [number of points](Self::with_points) or limit the step |
/// | touches zero and turns back (a double root) | nothing, unless a point hits the touch to the last bit, or rounding takes g across |
/// | reaches zero and stays there | the time it gets there |
/// | starts at zero, or is there after a restart | nothing until it has had a sign and loses it |
///
/// Events in one step are reported in order of time. At the same time those that are not terminal come first, then those with the lower index.
pub struct Events<G, T, const M: usize> {
    g: G,
    crossings: [Crossing; M],
    points: u32,
    tolerance: Option<T>,
    /// The side of zero each function is on, `Equal` if it has none yet, and the time and value at which it was last found there.
    sides: [Ordering; M],
    since: [(T, T); M],
    /// The time up to which all was looked at.
    seen: Option<T>,
    /// The last event: its function starts without a side if the solver is restarted there.
    reported: Option<(usize, T)>,
}

impl<G, T: Scalar, const M: usize> Events<G, T, M> {
    /// The functions `g`(t, x) and what counts as an event of each, looked for at 10 points of a step.
    pub fn new<const N: usize>(g: G, crossings: [Crossing; M]) -> Self
    where
        G: FnMut(T, &SVector<T, N>) -> [T; M],
    {
        Self {
            g,
            crossings,
            points: 10,
            tolerance: None,
            sides: [Ordering::Equal; M],
            since: [(T::zero(), T::zero()); M],
            seen: None,
            reported: None,
        }
    }

    /// The same, looked for at `points` equidistant points of a step; the last of them is its end.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0.
    pub fn with_points(self, points: u32) -> Result<Self, Error> {
        positive("points", f64::from(points))?;
        Ok(Self { points, ..self })
    }

    /// The same, located within `tolerance` in seconds.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_tolerance(self, tolerance: T) -> Result<Self, Error> {
        Ok(Self { tolerance: Some(positive("tolerance", tolerance)?), ..self })
    }

    fn values<const N: usize>(&mut self, t: T, x: &SVector<T, N>) -> Result<[T; M], Error>
    where
        G: FnMut(T, &SVector<T, N>) -> [T; M],
    {
        let values = (self.g)(t, x);
        finite_slice("g(t, x)", &values)?;
        Ok(values)
    }

    /// Whether all was looked at up to a time within a step from `start` to `end`.
    pub(super) fn has_seen(&self, start: T, end: T) -> bool {
        self.seen.is_some_and(|seen| start <= seen && seen <= end)
    }

    /// Looks at a state that no step leads to.
    pub(super) fn look<const N: usize>(&mut self, t: T, x: &SVector<T, N>) -> Result<(), Error>
    where
        G: FnMut(T, &SVector<T, N>) -> [T; M],
    {
        let values = self.values(t, x)?;
        self.since = values.map(|value| (t, value));
        self.sides = values.map(sign);
        // At the place of its own event a function is zero but for the rounding of the time.
        if let Some((index, _)) = self.reported.filter(|(_, time)| *time == t)
            && let Some(side) = self.sides.get_mut(index)
        {
            *side = Ordering::Equal;
        }
        self.seen = Some(t);
        Ok(())
    }

    /// The first event within a step that is not reported yet, up to `end`.
    pub(super) fn next_within<const N: usize>(
        &mut self,
        step: &Dense<T, N>,
        end: T,
    ) -> Result<Option<Occurrence<T, N>>, Error>
    where
        G: FnMut(T, &SVector<T, N>) -> [T; M],
    {
        for j in 1..=self.points {
            let part = constant::<T>(f64::from(j) / f64::from(self.points));
            let t = if j == self.points { end } else { step.t + (end - step.t) * part };
            if self.seen.is_none_or(|seen| seen < t)
                && let Some(event) = self.next_until(t, step)?
            {
                return Ok(Some(event));
            }
        }
        Ok(None)
    }

    fn next_until<const N: usize>(
        &mut self,
        t: T,
        step: &Dense<T, N>,
    ) -> Result<Option<Occurrence<T, N>>, Error>
    where
        G: FnMut(T, &SVector<T, N>) -> [T; M],
    {
        let values = self.values(t, &step.at(t)?)?;
        let mut first: Option<(T, T, usize, Direction)> = None;
        for (i, value) in values.into_iter().enumerate() {
            self.find_side(i, t, step)?;
            let Some(direction) = crossed(self.sides[i], sign(value)) else { continue };
            if !self.crossings[i].wants(direction) {
                continue;
            }
            let width =
                self.tolerance.unwrap_or(epsilon::<T>() * constant(4.0) * t.abs().max(step.h));
            let (side, since) = (self.sides[i], self.since[i]);
            let g = |t| self.values(t, &step.at(t)?).map(|values| values[i]);
            let (time, value) = locate(g, side, since, (t, value), width)?;
            let earlier = first.is_none_or(|(first, _, other, _)| {
                let [this, other] = [i, other].map(|i| self.crossings[i].is_terminal());
                time < first || time == first && !this && other
            });
            if earlier {
                first = Some((time, value, i, direction));
            }
        }
        let Some((time, value, index, direction)) = first else {
            for (i, value) in values.into_iter().enumerate() {
                self.sides[i] = sign(value);
                self.since[i] = (t, value);
            }
            self.seen = Some(t);
            return Ok(None);
        };
        self.sides[index] = sign(value);
        self.since[index] = (time, value);
        self.reported = Some((index, time));
        let terminal = self.crossings[index].is_terminal();
        if terminal {
            self.stop(time, step)?;
        }
        Ok(Some(Occurrence { index, t: time, x: step.at(time)?, direction, terminal }))
    }

    /// What lies beyond a terminal event does not happen; what happens at the same time still counts.
    fn stop<const N: usize>(&mut self, time: T, step: &Dense<T, N>) -> Result<(), Error>
    where
        G: FnMut(T, &SVector<T, N>) -> [T; M],
    {
        let values = self.values(time, &step.at(time)?)?;
        for (i, value) in values.into_iter().enumerate() {
            self.since[i] = (time, value);
        }
        self.seen = Some(time);
        Ok(())
    }

    /// The side of a function that starts at zero: the first one it takes, looked for ever closer to the start.
    fn find_side<const N: usize>(&mut self, i: usize, t: T, step: &Dense<T, N>) -> Result<(), Error>
    where
        G: FnMut(T, &SVector<T, N>) -> [T; M],
    {
        let start = self.since[i].0;
        for k in (1..=20).rev() {
            if self.sides[i] != Ordering::Equal {
                break;
            }
            let time = start + (t - start) * constant::<T>(0.5).powi(k);
            let value = self.values(time, &step.at(time)?)?[i];
            self.sides[i] = sign(value);
            self.since[i] = (time, value);
        }
        Ok(())
    }
}

/// What is watched; the functions need not be printable.
impl<G, T: Scalar, const M: usize> fmt::Debug for Events<G, T, M> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Events")
            .field("crossings", &self.crossings)
            .field("points", &self.points)
            .field("sides", &self.sides)
            .field("seen", &self.seen)
            .finish_non_exhaustive()
    }
}
