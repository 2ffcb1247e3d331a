use nalgebra::SVector;

use crate::{
    Error, Scalar,
    channel::{Channel, Ideal},
    controller::Measurement,
};

/// The state of affairs at an instant, which no controller knows but through a [`Sensor`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truth<T, const NX: usize, const NU: usize> {
    /// The time t in seconds.
    pub t: T,
    /// The state x(t).
    pub x: SVector<T, NX>,
    /// ẋ just before t.
    pub x_dot: SVector<T, NX>,
    /// The input that the plant was under just before t.
    pub u: SVector<T, NU>,
}

/// What a controller sees of a plant with NX states and NU inputs.
pub trait Sensor<T: Scalar, const NX: usize, const NU: usize>: Clone {
    /// What it sees: a [`Measurement`] for the controller at hand.
    type Seen: Clone;

    /// The sensor after a period of `dt` > 0 seconds, and what it shows of the `truth` at its end.
    ///
    /// # Errors
    /// Those of its channels.
    fn sensed(&self, truth: &Truth<T, NX, NU>, dt: T) -> Result<(Self, Self::Seen), Error>;
}

/// The sensor that shows everything: the state, its derivative and the input that was applied.
impl<T: Scalar, const NX: usize, const NU: usize> Sensor<T, NX, NU> for Ideal {
    type Seen = Measurement<T, NX, NU>;

    fn sensed(&self, truth: &Truth<T, NX, NU>, _dt: T) -> Result<(Self, Self::Seen), Error> {
        let Truth { x, x_dot, u, .. } = *truth;
        Ok((*self, Measurement { x, x_dot: Some(x_dot), applied: Some(u) }))
    }
}

/// Sensors for a vector y = h(truth), each through a [`Channel`].
///
/// They have no ẋ to show. What the actuators report for the applied input arrives as it is, if they [report](Self::unreported) it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensors<H, C> {
    output: H,
    channel: C,
    report: bool,
}

impl<H, C> Sensors<H, C> {
    /// Sensors that show `output` of the truth through `channel`.
    ///
    /// `output` takes a `&Truth<T, NX, NU>` to an `SVector<T, NY>`: what a controller takes for its state.
    pub fn new(output: H, channel: C) -> Self {
        Self { output, channel, report: true }
    }

    /// The same sensors, with actuators that do not report what they did: the controller takes its last command for it.
    pub fn unreported(self) -> Self {
        Self { report: false, ..self }
    }
}

/// The state as it is.
pub type State<T, const NX: usize, const NU: usize> = fn(&Truth<T, NX, NU>) -> SVector<T, NX>;

impl<T: Scalar, C: Channel<T, NX>, const NX: usize, const NU: usize> Sensors<State<T, NX, NU>, C> {
    /// Sensors that show the state through `channel`.
    pub fn of_state(channel: C) -> Self {
        Self::new(|truth| truth.x, channel)
    }
}

impl<T, H, C, const NX: usize, const NU: usize, const NY: usize> Sensor<T, NX, NU> for Sensors<H, C>
where
    T: Scalar,
    H: Fn(&Truth<T, NX, NU>) -> SVector<T, NY> + Clone,
    C: Channel<T, NY>,
{
    type Seen = Measurement<T, NY, NU>;

    fn sensed(&self, truth: &Truth<T, NX, NU>, dt: T) -> Result<(Self, Self::Seen), Error> {
        let (channel, x) = self.channel.passed(&(self.output)(truth), dt)?;
        let applied = self.report.then_some(truth.u);
        Ok((Self { channel, ..self.clone() }, Measurement { x, x_dot: None, applied }))
    }
}
