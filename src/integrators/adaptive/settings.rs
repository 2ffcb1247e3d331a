use nalgebra::SVector;

use super::{Embedded, Solver, Tolerance};
use crate::{
    Error, Scalar,
    error::{finite, finite_vector, positive},
    integrators::Propagator,
};

/// An [`Embedded`] method with a [`Tolerance`]: it chooses its steps so that each is within it.
///
/// [`solve`](Self::solve) starts on a problem and gives a [`Solver`]. In a [`Simulation`](crate::simulation::Simulation) it is an
/// integrator like the others; there every period starts anew, so that what happens in it depends on its first state and its input alone.
/// Where the period is short, [`with_first_step`](Self::with_first_step)(dt) tries it in one step.
///
/// ```
/// use brunovsky::integrators::{Adaptive, DormandPrince, Tolerance};
/// use nalgebra::SVector;
///
/// let oscillator = |_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]);
/// let method = Adaptive::new(DormandPrince, Tolerance::new(1e-9, 1e-12)?);
/// let mut solver = method.solve(oscillator, 0.0, [1.0, 0.0])?;
/// let x = solver.advance(1.0)?;
/// assert!((x[0] - 1.0_f64.cos()).abs() < 1e-8);
/// assert!(solver.statistics().evaluations < 200);
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adaptive<M, T, const N: usize> {
    pub(super) method: M,
    pub(super) tolerance: Tolerance<T, N>,
    pub(super) first_step: Option<T>,
    pub(super) longest_step: Option<T>,
    pub(super) step_limit: u64,
}

impl<M: Embedded<T, N>, T: Scalar, const N: usize> Adaptive<M, T, N> {
    /// `method` under `tolerance`, with steps of any length and at most 100 000 of them in a call.
    pub fn new(method: M, tolerance: Tolerance<T, N>) -> Self {
        Self { method, tolerance, first_step: None, longest_step: None, step_limit: 100_000 }
    }

    /// The same with a first step, and one after each jump, of `h` in seconds instead of one found from f.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_first_step(self, h: T) -> Result<Self, Error> {
        Ok(Self { first_step: Some(positive("first step", h)?), ..self })
    }

    /// The same with steps of at most `h` in seconds, for an f with short events that longer steps would pass over.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_longest_step(self, h: T) -> Result<Self, Error> {
        Ok(Self { longest_step: Some(positive("longest step", h)?), ..self })
    }

    /// The same with at most `steps` steps in one call, accepted and rejected.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0.
    pub fn with_step_limit(self, steps: u32) -> Result<Self, Error> {
        positive("step limit", f64::from(steps))?;
        Ok(Self { step_limit: u64::from(steps), ..self })
    }

    /// A solver of ẋ = f(t, x) from x(t0) = `x0`.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for `t0`, [`Error::NonFiniteEntry`] for `x0`.
    pub fn solve<F>(
        self,
        f: F,
        t0: T,
        x0: impl Into<SVector<T, N>>,
    ) -> Result<Solver<'static, M, F, T, N>, Error>
    where
        F: FnMut(T, &SVector<T, N>) -> SVector<T, N>,
    {
        let x = x0.into();
        finite("t0", t0)?;
        finite_vector("x0", &x)?;
        Ok(Solver::new(self, f, t0, x))
    }
}

impl<M: Embedded<T, N> + Copy, T: Scalar, const N: usize> Propagator<T, N> for Adaptive<M, T, N> {
    /// It chooses its own steps, whatever their number is meant to be.
    fn propagate(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        duration: T,
        _steps: u32,
    ) -> Result<SVector<T, N>, Error> {
        self.solve(f, t, *x)?.advance(t + positive("duration", duration)?).copied()
    }
}

checked! {
    [M, T: Scalar, const N: usize] Adaptive<M, T, N>, [M, T]
    {
        method: M,
        tolerance: Tolerance<T, N>,
        first_step: Option<T>,
        longest_step: Option<T>,
        step_limit: u64,
    } =>
    positive("first step", first_step.unwrap_or(T::one())).and_then(|_| {
        positive("longest step", longest_step.unwrap_or(T::one()))?;
        positive("step limit", step_limit as f64)?;
        Ok(Self { method, tolerance, first_step, longest_step, step_limit })
    })
}
