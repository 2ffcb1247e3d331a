use core::{
    fmt,
    iter::{FusedIterator, Take},
};

use nalgebra::SVector;

use crate::{
    Error, Scalar,
    controller::{Command, Controller, Measurement},
    error::{finite_vector, not_negative, positive},
    integrators::{Discontinuities, Propagator, Rk4},
    plant::Plant,
    scalar::constant,
};

/// A sampled controller in closed loop with a continuous plant.
///
/// At sample k the time is t = k·dt, computed and never accumulated. The order within a sample is:
///
/// 1. the plant is integrated from sample k−1 to k under the input of sample k−1 (zero-order hold), in `substeps` equal steps or in those
///    that an [`Adaptive`](crate::integrators::Adaptive) method chooses;
/// 2. the state is measured, together with ẋ just before the sample and the input it was under (0 before the first sample);
/// 3. the reference is taken at t, the controller is updated, and its command is yielded as a [`Sample`].
///
/// A disturbance that switches at a sampling instant acts from that instant on: the integration up to a sample sees times before it
/// only, so the switch is not smeared over a step. One that switches between samples is [declared](Self::discontinuities); the period is
/// then integrated in the pieces before and after it.
///
/// The iterator is infinite; [`until`](Self::until) ends it at a time. After an error it ends.
///
/// ```
/// use brunovsky::controller::{FeedbackLinearization, Gains, Reference};
/// use brunovsky::plant::IntegratorChain;
/// use brunovsky::simulation::Simulation;
///
/// let plant = IntegratorChain::<f64, 2>::new();
/// let mut flc = FeedbackLinearization::new(plant, Gains::from_lambda(2.0)?);
/// let run = Simulation::new(&plant, &mut flc, |_t| Reference::setpoint(1.0), [0.0, 0.0], 0.01)?;
/// let samples = run.until(5.0)?.collect::<Result<Vec<_>, _>>()?;
/// assert_eq!(samples.len(), 501);
/// assert!((samples[500].x[0] - 1.0).abs() < 1e-3);
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Clone)]
pub struct Simulation<'a, P, C, R, const NX: usize, const NU: usize, I = Rk4>
where
    P: Plant<NX, NU>,
{
    plant: &'a P,
    controller: C,
    reference: R,
    integrator: I,
    substeps: u32,
    discontinuities: Discontinuities<'a, P::Scalar>,
    dt: P::Scalar,
    k: u64,
    x: SVector<P::Scalar, NX>,
    u: SVector<P::Scalar, NU>,
    ended: bool,
}

/// What happened at one sample of a [`Simulation`]: `command` holds over \[t, t + dt).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<T, R, C, const NX: usize, const NU: usize> {
    /// The number of the sample, from 0.
    pub k: u64,
    /// The time t = k·dt in seconds.
    pub t: T,
    /// The true state x(t).
    pub x: SVector<T, NX>,
    /// The reference given to the controller.
    pub reference: R,
    /// The controller's command.
    pub command: C,
    /// The input that the plant receives over \[t, t + dt).
    pub u: SVector<T, NU>,
}

impl<'a, T, P, C, R, const NX: usize, const NU: usize> Simulation<'a, P, C, R, NX, NU>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    C: Controller<NX, NU, Scalar = T>,
    R: FnMut(T) -> C::Reference,
{
    /// `controller` on `plant` from the state `x0`, following `reference(t)`, with period `dt` > 0 in seconds.
    ///
    /// Between samples it takes ten steps of [`Rk4`]; see [`integrator`](Self::integrator) and [`substeps`](Self::substeps). A
    /// controller passed as `&mut` is there with all it learned when the simulation is over.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `dt`, [`Error::NonFiniteEntry`] for `x0`.
    pub fn new(
        plant: &'a P,
        controller: C,
        reference: R,
        x0: impl Into<SVector<T, NX>>,
        dt: T,
    ) -> Result<Self, Error> {
        let x = x0.into();
        finite_vector("x0", &x)?;
        Ok(Self {
            plant,
            controller,
            reference,
            integrator: Rk4,
            substeps: 10,
            discontinuities: Discontinuities::default(),
            dt: positive("dt", dt)?,
            k: 0,
            x,
            u: SVector::zeros(),
            ended: false,
        })
    }
}

impl<'a, T, P, C, R, I, const NX: usize, const NU: usize> Simulation<'a, P, C, R, NX, NU, I>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    C: Controller<NX, NU, Scalar = T>,
    R: FnMut(T) -> C::Reference,
    I: Propagator<T, NX>,
{
    /// The same loop with another integration method: [`Heun`](crate::integrators::Heun), or
    /// `Adaptive::new(Rodas::new(), Tolerance::new(1e-6, 1e-9)?)`.
    pub fn integrator<J>(self, integrator: J) -> Simulation<'a, P, C, R, NX, NU, J>
    where
        J: Propagator<T, NX>,
    {
        Simulation {
            plant: self.plant,
            controller: self.controller,
            reference: self.reference,
            integrator,
            substeps: self.substeps,
            discontinuities: self.discontinuities,
            dt: self.dt,
            k: self.k,
            x: self.x,
            u: self.u,
            ended: self.ended,
        }
    }

    /// The same loop with `substeps` steps of the integrator in a period, or in each of its pieces; an adaptive one chooses its own.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0.
    pub fn substeps(self, substeps: u32) -> Result<Self, Error> {
        positive("substeps", f64::from(substeps))?;
        Ok(Self { substeps, ..self })
    }

    /// The same loop with the `times` in seconds, in ascending order, at which the plant or its uncertainty jumps: to its value for t ≥ time.
    ///
    /// The method keeps its order there; a jump within a step that is not declared is smeared over it. Sampling instants need no declaration.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for a time, [`Error::NotBelow`] for two that do not ascend.
    pub fn discontinuities(self, times: &'a [T]) -> Result<Self, Error> {
        Ok(Self { discontinuities: Discontinuities::new(times)?, ..self })
    }

    /// The samples from here to the last one at or before the time `t_end` in seconds, give or take its rounding.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`] for `t_end`.
    pub fn until(self, t_end: T) -> Result<Take<Self>, Error> {
        not_negative("t_end", t_end)?;
        // A quotient that is a whole number but for its rounding counts as that number; the cast rounds down.
        let periods = t_end / self.dt * (T::one() + T::default_epsilon() * constant(4.0));
        let last = crate::error::value(periods) as u64;
        let left = last.saturating_add(1).saturating_sub(self.k);
        Ok(self.take(usize::try_from(left).unwrap_or(usize::MAX)))
    }

    /// The true state at the last sample (also if the controller failed there), or at the start.
    pub fn state(&self) -> &SVector<T, NX> {
        &self.x
    }

    /// The time k·dt of sample `k`.
    fn time(&self, k: u64) -> T {
        constant::<T>(k as f64) * self.dt
    }

    fn sample(&mut self) -> Result<Sample<T, C::Reference, C::Command, NX, NU>, Error> {
        let t = self.time(self.k);
        if let Some(last) = self.k.checked_sub(1) {
            self.x = self.propagated(self.time(last), t)?;
        }
        let u = self.u;
        let field = held(self.plant, u, t);
        let measurement = Measurement::new(self.x).with_rate(field(t, &self.x)).with_applied(u);
        let reference = (self.reference)(t);
        let command = self.controller.update(&measurement, &reference, self.dt)?;
        self.u = command.input();
        let sample = Sample { k: self.k, t, x: self.x, reference, command, u: self.u };
        self.k += 1;
        Ok(sample)
    }

    /// The state after the period from `start` to `end`, in pieces over which the plant is smooth.
    fn propagated(&self, start: T, end: T) -> Result<SVector<T, NX>, Error> {
        let (mut t, mut x, mut left) = (start, self.x, self.dt);
        while let Some(jump) = self.discontinuities.after(t).filter(|jump| *jump < end) {
            let field = held(self.plant, self.u, jump);
            x = self.integrator.propagate(field, t, &x, jump - t, self.substeps)?;
            (t, left) = (jump, end - jump);
        }
        self.integrator.propagate(held(self.plant, self.u, end), t, &x, left, self.substeps)
    }
}

/// ẋ = F(t, x, `u`) before `end`: later times are not shown. The start, 0, has no "before": ẋ is then taken at the start itself.
fn held<T: Scalar, P: Plant<NX, NU, Scalar = T>, const NX: usize, const NU: usize>(
    plant: &P,
    u: SVector<T, NU>,
    end: T,
) -> impl Fn(T, &SVector<T, NX>) -> SVector<T, NX> {
    let before = end * (T::one() - T::default_epsilon());
    move |t, x| plant.derivative(t.min(before), x, &u)
}

/// Where the loop stands; a plant, a controller or a reference need not be printable.
impl<P: Plant<NX, NU>, C, R, I, const NX: usize, const NU: usize> fmt::Debug
    for Simulation<'_, P, C, R, NX, NU, I>
{
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Simulation")
            .field("dt", &self.dt)
            .field("substeps", &self.substeps)
            .field("k", &self.k)
            .field("x", &self.x)
            .field("u", &self.u)
            .field("ended", &self.ended)
            .finish_non_exhaustive()
    }
}

impl<T, P, C, R, I, const NX: usize, const NU: usize> Iterator
    for Simulation<'_, P, C, R, NX, NU, I>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    C: Controller<NX, NU, Scalar = T>,
    R: FnMut(T) -> C::Reference,
    I: Propagator<T, NX>,
{
    type Item = Result<Sample<T, C::Reference, C::Command, NX, NU>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let sample = self.sample();
        self.ended = sample.is_err();
        Some(sample)
    }
}

impl<T, P, C, R, I, const NX: usize, const NU: usize> FusedIterator
    for Simulation<'_, P, C, R, NX, NU, I>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    C: Controller<NX, NU, Scalar = T>,
    R: FnMut(T) -> C::Reference,
    I: Propagator<T, NX>,
{
}
