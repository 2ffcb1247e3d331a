mod ticks;

use core::fmt;

use nalgebra::SVector;

use super::{Hardware, Sensor};
use crate::{
    Error, Scalar,
    channel::Channel,
    controller::{Controller, Measurement},
    error::{finite_vector, not_negative, positive},
    integrators::{Discontinuities, Propagator, Rk4},
    plant::Plant,
    scalar::constant,
};

/// A sampled controller in closed loop with a continuous plant.
///
/// The clock ticks every `dt`: tick j is at t = j·dt, computed and never accumulated. The order within a tick is:
///
/// 1. the plant is integrated from tick j−1 to j under the input of tick j−1 (zero-order hold), in `substeps` equal steps or in those
///    that an [`Adaptive`](crate::integrators::Adaptive) method chooses;
/// 2. the sensors are read, if it is their turn: they see the state, ẋ just before the tick and the input it was under (0 before the first
///    tick);
/// 3. the controller is called, if it is its turn, with what the sensors showed last, the reference at t and the time since its last call;
/// 4. the actuators move, if it is their turn, toward the last command (0 before the first), and what they do is the plant's input from
///    here on;
/// 5. if the controller was called, a [`Sample`](super::Sample) is yielded.
///
/// Without [`Hardware`] it is everyone's turn at every tick, sensors show the truth and actuators do as they are told. Delays, noise, losses
/// and limits are [channels](crate::channel) of the hardware.
///
/// A disturbance that switches at a tick acts from that instant on: the integration up to a tick sees times before it only, so the switch
/// is not smeared over a step. One that switches between ticks is [declared](Self::discontinuities); the tick is then integrated in the
/// pieces before and after it.
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
pub struct Simulation<
    'a,
    P,
    C,
    R,
    const NX: usize,
    const NU: usize,
    I = Rk4,
    H = Hardware,
    M = Measurement<<P as Plant<NX, NU>>::Scalar, NX, NU>,
> where
    P: Plant<NX, NU>,
{
    plant: &'a P,
    hardware: H,
    controller: C,
    reference: R,
    integrator: I,
    substeps: u32,
    discontinuities: Discontinuities<'a, P::Scalar>,
    dt: P::Scalar,
    /// The tick that comes next.
    tick: u64,
    /// The last tick.
    end: u64,
    /// The number of the next call of the controller, and its tick.
    call: u64,
    due: u64,
    /// The tick of the last one.
    called: Option<u64>,
    x: SVector<P::Scalar, NX>,
    seen: Option<M>,
    asked: SVector<P::Scalar, NU>,
    u: SVector<P::Scalar, NU>,
    ended: bool,
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
        Self::with_hardware(plant, Hardware::default(), controller, reference, x0, dt)
    }
}

impl<'a, T, P, C, R, S, A, L, const NX: usize, const NU: usize, const NY: usize>
    Simulation<'a, P, C, R, NX, NU, Rk4, Hardware<S, A, L>, Measurement<T, NY, NU>>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    C: Controller<NY, NU, Scalar = T>,
    R: FnMut(T) -> C::Reference,
    S: Sensor<T, NX, NU, Seen = Measurement<T, NY, NU>>,
    A: Channel<T, NU>,
    L: FnMut(u64) -> u64,
{
    /// The same with `hardware` between the plant and a `controller` that takes what its sensors show for the state; `dt` > 0 is the tick of
    /// its clocks in seconds.
    ///
    /// # Errors
    /// Those of [`new`](Simulation::new), and [`Error::NotBelow`] for a call that would be late by its period.
    pub fn with_hardware(
        plant: &'a P,
        mut hardware: Hardware<S, A, L>,
        controller: C,
        reference: R,
        x0: impl Into<SVector<T, NX>>,
        dt: T,
    ) -> Result<Self, Error> {
        let x = x0.into();
        finite_vector("x0", &x)?;
        Ok(Self {
            plant,
            due: hardware.due(0)?,
            hardware,
            controller,
            reference,
            integrator: Rk4,
            substeps: 10,
            discontinuities: Discontinuities::default(),
            dt: positive("dt", dt)?,
            tick: 0,
            end: u64::MAX,
            call: 0,
            called: None,
            x,
            seen: None,
            asked: SVector::zeros(),
            u: SVector::zeros(),
            ended: false,
        })
    }
}

impl<'a, T, P, C, R, I, H, M, const NX: usize, const NU: usize>
    Simulation<'a, P, C, R, NX, NU, I, H, M>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    I: Propagator<T, NX>,
{
    /// The same loop with another integration method: [`Heun`](crate::integrators::Heun), or
    /// `Adaptive::new(Rodas::new(), Tolerance::new(1e-6, 1e-9)?)`.
    pub fn integrator<J: Propagator<T, NX>>(
        self,
        integrator: J,
    ) -> Simulation<'a, P, C, R, NX, NU, J, H, M> {
        Simulation {
            plant: self.plant,
            hardware: self.hardware,
            controller: self.controller,
            reference: self.reference,
            integrator,
            substeps: self.substeps,
            discontinuities: self.discontinuities,
            dt: self.dt,
            tick: self.tick,
            end: self.end,
            call: self.call,
            due: self.due,
            called: self.called,
            x: self.x,
            seen: self.seen,
            asked: self.asked,
            u: self.u,
            ended: self.ended,
        }
    }

    /// The same loop with `substeps` steps of the integrator in a tick, or in each of its pieces; an adaptive one chooses its own.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0.
    pub fn substeps(self, substeps: u32) -> Result<Self, Error> {
        positive("substeps", f64::from(substeps))?;
        Ok(Self { substeps, ..self })
    }

    /// The same loop with the `times` in seconds, in ascending order, at which the plant or its uncertainty jumps: to its value for t ≥ time.
    ///
    /// The method keeps its order there; a jump within a step that is not declared is smeared over it. Ticks need no declaration.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for a time, [`Error::NotBelow`] for two that do not ascend.
    pub fn discontinuities(self, times: &'a [T]) -> Result<Self, Error> {
        Ok(Self { discontinuities: Discontinuities::new(times)?, ..self })
    }

    /// The same loop, up to the last tick at or before the time `t_end` in seconds, give or take its rounding.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`] for `t_end`.
    pub fn until(self, t_end: T) -> Result<Self, Error> {
        not_negative("t_end", t_end)?;
        // A quotient that is a whole number but for its rounding counts as that number; the cast rounds down.
        let ticks = t_end / self.dt * (T::one() + T::default_epsilon() * constant(4.0));
        Ok(Self { end: crate::error::value(ticks) as u64, ..self })
    }

    /// The true state at the last tick (also if the controller failed there), or at the start.
    pub fn state(&self) -> &SVector<T, NX> {
        &self.x
    }

    /// `count` ticks in seconds.
    fn ticks_long(&self, count: u64) -> T {
        constant::<T>(count as f64) * self.dt
    }

    /// The state after the tick from `start` to `end`, in pieces over which the plant is smooth.
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
impl<P: Plant<NX, NU>, C, R, I, H, M, const NX: usize, const NU: usize> fmt::Debug
    for Simulation<'_, P, C, R, NX, NU, I, H, M>
{
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Simulation")
            .field("dt", &self.dt)
            .field("substeps", &self.substeps)
            .field("tick", &self.tick)
            .field("x", &self.x)
            .field("u", &self.u)
            .field("ended", &self.ended)
            .finish_non_exhaustive()
    }
}
