use crate::{
    Error,
    channel::Ideal,
    error::{below, positive},
};

/// What stands between a simulated plant and its controller: sensors, actuators, and the clocks of all three.
///
/// Times are whole numbers of ticks, a tick being the `dt` of the [`Simulation`](super::Simulation): 10 sensor periods of 3 ticks and 3
/// controller periods of 10 end at the same instant, without rounding. At an instant, what is due happens in the order of
/// [`Simulation`](super::Simulation).
///
/// ```
/// use brunovsky::channel::{Delay, Lag, Quantization, Saturation};
/// use brunovsky::controller::{FeedbackLinearization, Gains, Reference};
/// use brunovsky::plant::IntegratorChain;
/// use brunovsky::simulation::{Hardware, Sensors, Simulation};
///
/// let plant = IntegratorChain::<f64, 2>::new();
/// let flc = FeedbackLinearization::new(plant, Gains::from_lambda(2.0)?);
/// // An encoder every 2 ms, a controller every 10 ms that takes 3 ms to compute, a drive at every tick of 1 ms.
/// let encoder = Sensors::of_state(Quantization::new([1e-4, 1e-3])?);
/// let drive = (Delay::<f64, 1, 3>::new(), (Saturation::symmetric([5.0])?, Lag::new([0.004])?));
/// let hardware = Hardware::new(encoder, drive).every(2, 10, 1)?;
/// let target = |_t| Reference::setpoint(1.0);
/// let run = Simulation::with_hardware(&plant, hardware, flc, target, [0.0, 0.0], 0.001)?;
/// let last = run.until(5.0)?.last().ok_or(brunovsky::Error::Missing { name: "sample" })??;
/// assert!((last.x[0] - 1.0).abs() < 1e-3);
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hardware<S = Ideal, A = Ideal, L = fn(u64) -> u64> {
    pub(super) sensor: S,
    pub(super) actuator: A,
    pub(super) lateness: L,
    pub(super) sensor_every: u32,
    pub(super) controller_every: u32,
    pub(super) actuator_every: u32,
}

impl Default for Hardware {
    /// Ideal sensors and actuators, everything at every tick and on time.
    fn default() -> Self {
        Self::new(Ideal, Ideal)
    }
}

impl<S, A> Hardware<S, A> {
    /// `sensor` and `actuator`, everything at every tick and on time.
    pub fn new(sensor: S, actuator: A) -> Self {
        Self {
            sensor,
            actuator,
            lateness: |_| 0,
            sensor_every: 1,
            controller_every: 1,
            actuator_every: 1,
        }
    }
}

impl<S, A, L> Hardware<S, A, L> {
    /// The same with sensors read every `sensor` ticks, the controller called every `controller` ticks and the actuators moved every
    /// `actuator` ticks.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0.
    pub fn every(self, sensor: u32, controller: u32, actuator: u32) -> Result<Self, Error> {
        positive("sensor period", f64::from(sensor))?;
        positive("controller period", f64::from(controller))?;
        positive("actuator period", f64::from(actuator))?;
        Ok(Self {
            sensor_every: sensor,
            controller_every: controller,
            actuator_every: actuator,
            ..self
        })
    }

    /// The same with jitter: call k of the controller comes `lateness(k)` ticks late, fewer than its period, and k is asked for in ascending order
    /// and once.
    ///
    /// `move |_| random.random_range(0..3)` draws from a generator; the controller is told the time that really passed since its last call.
    pub fn late<M: FnMut(u64) -> u64>(self, lateness: M) -> Hardware<S, A, M> {
        Hardware {
            sensor: self.sensor,
            actuator: self.actuator,
            lateness,
            sensor_every: self.sensor_every,
            controller_every: self.controller_every,
            actuator_every: self.actuator_every,
        }
    }
}

impl<S, A, L: FnMut(u64) -> u64> Hardware<S, A, L> {
    /// The tick of call `k` of the controller.
    pub(super) fn due(&mut self, k: u64) -> Result<u64, Error> {
        let (late, period) = ((self.lateness)(k), u64::from(self.controller_every));
        below("lateness", late as f64, period as f64)?;
        Ok(k.saturating_mul(period).saturating_add(late))
    }
}
