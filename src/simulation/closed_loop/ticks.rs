use core::iter;

use super::{Simulation, held};
use crate::{
    Error, Scalar,
    channel::Channel,
    controller::{Command, Controller, Measurement},
    error::finite_vector,
    integrators::Propagator,
    plant::Plant,
    simulation::{Hardware, Sample, Sensor, Tick, Truth},
};

impl<T, P, C, R, I, S, A, L, const NX: usize, const NU: usize, const NY: usize>
    Simulation<'_, P, C, R, NX, NU, I, Hardware<S, A, L>, Measurement<T, NY, NU>>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    C: Controller<NY, NU, Scalar = T>,
    R: FnMut(T) -> C::Reference,
    I: Propagator<T, NX>,
    S: Sensor<T, NX, NU, Seen = Measurement<T, NY, NU>>,
    A: Channel<T, NU>,
    L: FnMut(u64) -> u64,
{
    /// The loop tick by tick: also those between the calls of the controller.
    pub fn ticks(mut self) -> impl Iterator<Item = Result<TickOf<C, T, NX, NU, NY>, Error>> {
        iter::from_fn(move || self.next_tick())
    }

    fn next_tick(&mut self) -> Option<Result<TickOf<C, T, NX, NU, NY>, Error>> {
        if self.ended || self.tick > self.end {
            return None;
        }
        let tick = self.advance();
        self.ended = tick.is_err();
        Some(tick)
    }

    fn advance(&mut self) -> Result<TickOf<C, T, NX, NU, NY>, Error> {
        let j = self.tick;
        let t = self.ticks_long(j);
        if let Some(last) = j.checked_sub(1) {
            self.x = self.propagated(self.ticks_long(last), t)?;
        }
        if let Some(period) = due_at(j, self.hardware.sensor_every) {
            let x_dot = held(self.plant, self.u, t)(t, &self.x);
            let truth = Truth { t, x: self.x, x_dot, u: self.u };
            let (sensor, seen) = self.hardware.sensor.sensed(&truth, self.ticks_long(period))?;
            (self.hardware.sensor, self.seen) = (sensor, Some(seen));
        }
        let called = if j == self.due { Some(self.call_controller(t)?) } else { None };
        if let Some(period) = due_at(j, self.hardware.actuator_every) {
            let (actuator, u) =
                self.hardware.actuator.passed(&self.asked, self.ticks_long(period))?;
            (self.hardware.actuator, self.u) = (actuator, u);
        }
        self.tick = j + 1;
        let sample = called.map(|sample| Sample { u: self.u, ..sample });
        Ok(Tick { t, x: self.x, u: self.u, sample })
    }

    /// The next call of the controller; what the plant receives is not known yet.
    fn call_controller(&mut self, t: T) -> Result<SampleOf<C, T, NX, NU, NY>, Error> {
        let period = u64::from(self.hardware.controller_every);
        let elapsed = self.called.map_or(period, |called| self.tick - called);
        let seen = self.seen.ok_or(Error::Missing { name: "measurement" })?;
        let reference = (self.reference)(t);
        let command = self.controller.update(&seen, &reference, self.ticks_long(elapsed))?;
        let sample = Sample { k: self.call, t, x: self.x, seen, reference, command, u: self.u };
        let asked = command.input();
        finite_vector("u", &asked)?;
        self.asked = asked;
        self.called = Some(self.tick);
        self.call += 1;
        self.due = self.hardware.due(self.call)?;
        Ok(sample)
    }
}

/// A [`Sample`] of the controller `C`.
type SampleOf<C, T, const NX: usize, const NU: usize, const NY: usize> = Sample<
    T,
    <C as Controller<NY, NU>>::Reference,
    <C as Controller<NY, NU>>::Command,
    NX,
    NU,
    Measurement<T, NY, NU>,
>;

/// A [`Tick`] with the samples of the controller `C`.
type TickOf<C, T, const NX: usize, const NU: usize, const NY: usize> =
    Tick<SampleOf<C, T, NX, NU, NY>, T, NX, NU>;

/// The period of something that is due at tick `j` and every `every` ticks.
fn due_at(j: u64, every: u32) -> Option<u64> {
    let every = u64::from(every);
    (j.checked_rem(every) == Some(0)).then_some(every)
}

impl<T, P, C, R, I, S, A, L, const NX: usize, const NU: usize, const NY: usize> Iterator
    for Simulation<'_, P, C, R, NX, NU, I, Hardware<S, A, L>, Measurement<T, NY, NU>>
where
    T: Scalar,
    P: Plant<NX, NU, Scalar = T>,
    C: Controller<NY, NU, Scalar = T>,
    R: FnMut(T) -> C::Reference,
    I: Propagator<T, NX>,
    S: Sensor<T, NX, NU, Seen = Measurement<T, NY, NU>>,
    A: Channel<T, NU>,
    L: FnMut(u64) -> u64,
{
    type Item = Result<SampleOf<C, T, NX, NU, NY>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            match self.next_tick()? {
                Err(error) => return Some(Err(error)),
                Ok(Tick { sample: Some(sample), .. }) => return Some(Ok(sample)),
                Ok(_) => {}
            }
        }
    }
}

impl<T, P, C, R, I, S, A, L, const NX: usize, const NU: usize, const NY: usize> iter::FusedIterator
    for Simulation<'_, P, C, R, NX, NU, I, Hardware<S, A, L>, Measurement<T, NY, NU>>
where
    Self: Iterator,
    P: Plant<NX, NU, Scalar = T>,
{
}
