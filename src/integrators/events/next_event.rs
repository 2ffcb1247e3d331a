use nalgebra::SVector;

use super::{Direction, Events};
use crate::{
    Error, Scalar,
    integrators::{Embedded, Solver},
};

/// An event that happened.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Occurrence<T, const N: usize> {
    /// The function, counted from 0.
    pub index: usize,
    /// The time, just after the crossing.
    pub t: T,
    /// The state at that time, by the dense output.
    pub x: SVector<T, N>,
    /// The way the function crossed.
    pub direction: Direction,
    /// Whether the solver stands at the event; otherwise it stands at the end of the step that holds it.
    pub terminal: bool,
}

impl<M: Embedded<T, N>, F, T: Scalar, const N: usize> Solver<'_, M, F, T, N>
where
    F: FnMut(T, &SVector<T, N>) -> SVector<T, N>,
{
    /// The next of the `events` up to `t_end` in seconds, or `None` when the solver has arrived there.
    ///
    /// After a terminal event the solver stands at it: go on as it is, or [`restart`](Self::restart) from another state first. The same
    /// `events` are passed again; the one that was reported is not found a second time. Time that other calls pass is not looked at.
    ///
    /// Where infinitely many events pile up (Zeno), the ones closer together than the rounding of t are not told apart: leave the loop at
    /// an impact that is slow enough.
    ///
    /// ```
    /// use brunovsky::integrators::{Adaptive, Crossing, DormandPrince, Events, Tolerance};
    /// use nalgebra::SVector;
    ///
    /// // A ball falls from 1 m and loses half its speed at each impact.
    /// let falling = |_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -9.81]);
    /// let mut floor = Events::new(|_t, x: &SVector<f64, 2>| [x[0]], [Crossing::falling().terminal()]);
    /// let method = Adaptive::new(DormandPrince, Tolerance::new(1e-9, 1e-12)?);
    /// let mut ball = method.solve(falling, 0.0, [1.0, 0.0])?;
    /// let mut impacts = 0;
    /// while let Some(impact) = ball.next_event(1.2, &mut floor)? {
    ///     impacts += 1;
    ///     ball.restart([0.0, -0.5 * impact.x[1]])?;
    /// }
    /// // At 0.452, 0.903 and 1.129 s; the next would be at 1.242 s.
    /// assert_eq!(impacts, 3);
    /// assert_eq!(ball.time(), 1.2);
    /// # Ok::<(), brunovsky::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`advance`](Self::advance), and [`Error::NonFiniteEntry`] for g(t, x).
    pub fn next_event<G, const E: usize>(
        &mut self,
        t_end: T,
        events: &mut Events<G, T, E>,
    ) -> Result<Option<Occurrence<T, N>>, Error>
    where
        G: FnMut(T, &SVector<T, N>) -> [T; E],
    {
        crate::error::finite("t_end", t_end)?;
        crate::integrators::adaptive::at_most("t", self.time(), t_end)?;
        let start = self.attempts();
        if self.dense().is_none() || !events.has_seen(self.step_start(), self.time()) {
            events.look(self.time(), self.state())?;
        }
        loop {
            if let Some(step) = self.dense()
                && let Some(event) = events.next_within(&step, self.time())?
            {
                if event.terminal {
                    self.go_back(event.t, event.x);
                }
                return Ok(Some(event));
            }
            if self.time() >= t_end {
                return Ok(None);
            }
            self.step_towards(Some(t_end))?;
            self.within_limit(start)?;
        }
    }
}
