use nalgebra::SVector;

use crate::{
    Error, Scalar,
    channel::{Channel, Ideal},
    controller::Measurement,
};

/// What a controller sees of a plant with NX states and NU inputs.
pub trait Sensor<T: Scalar, const NX: usize, const NU: usize>: Clone {
    /// What it sees: a [`Measurement`] for the controller at hand.
    type Seen: Clone;

    /// The sensor after a period of `dt` > 0 seconds, and what it shows of the `truth` at its end.
    ///
    /// The truth brings ẋ just before that instant and the input it was under.
    ///
    /// # Errors
    /// Those of its channels.
    fn sensed(&self, truth: &Measurement<T, NX, NU>, dt: T) -> Result<(Self, Self::Seen), Error>;
}

/// The sensor that shows everything: the state, its derivative and the input that was applied.
impl<T: Scalar, const NX: usize, const NU: usize> Sensor<T, NX, NU> for Ideal {
    type Seen = Measurement<T, NX, NU>;

    fn sensed(&self, truth: &Self::Seen, _dt: T) -> Result<(Self, Self::Seen), Error> {
        Ok((*self, *truth))
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
    /// `output` takes a `&Measurement<T, NX, NU>` to an `SVector<T, NY>`: what a controller takes for its state.
    pub fn new(output: H, channel: C) -> Self {
        Self { output, channel, report: true }
    }

    /// The same sensors, with actuators that do not report what they did: the controller takes its last command for it.
    pub fn unreported(self) -> Self {
        Self { report: false, ..self }
    }
}

/// The state as it is.
pub type State<T, const NX: usize, const NU: usize> = fn(&Measurement<T, NX, NU>) -> SVector<T, NX>;

impl<T: Scalar, C: Channel<T, NX>, const NX: usize, const NU: usize> Sensors<State<T, NX, NU>, C> {
    /// Sensors that show the state through `channel`.
    pub fn of_state(channel: C) -> Self {
        Self::new(|truth| truth.x, channel)
    }
}

impl<T, H, C, const NX: usize, const NU: usize, const NY: usize> Sensor<T, NX, NU> for Sensors<H, C>
where
    T: Scalar,
    H: Fn(&Measurement<T, NX, NU>) -> SVector<T, NY> + Clone,
    C: Channel<T, NY>,
{
    type Seen = Measurement<T, NY, NU>;

    fn sensed(&self, truth: &Measurement<T, NX, NU>, dt: T) -> Result<(Self, Self::Seen), Error> {
        let (channel, x) = self.channel.passed(&(self.output)(truth), dt)?;
        let applied = truth.applied.filter(|_| self.report);
        Ok((Self { channel, ..self.clone() }, Measurement { x, x_dot: None, applied }))
    }
}
