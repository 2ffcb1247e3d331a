use nalgebra::SVector;

use crate::controller::Measurement;

/// What happened at one call of the controller in a [`Simulation`](super::Simulation).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<T, R, C, const NX: usize, const NU: usize, M = Measurement<T, NX, NU>> {
    /// The number of the call, from 0.
    pub k: u64,
    /// The time t in seconds; t = k·dt where the controller is called at every tick, and on time.
    pub t: T,
    /// The true state x(t).
    pub x: SVector<T, NX>,
    /// What the controller saw.
    pub seen: M,
    /// The reference given to the controller.
    pub reference: R,
    /// The controller's command.
    pub command: C,
    /// The input that the plant receives from t on, until the actuators move next.
    pub u: SVector<T, NU>,
}

/// What happened at one tick of a [`Simulation`](super::Simulation), whether or not the controller was called.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tick<S, T, const NX: usize, const NU: usize> {
    /// The time t = j·dt of tick j in seconds.
    pub t: T,
    /// The true state x(t).
    pub x: SVector<T, NX>,
    /// The input that the plant receives over \[t, t + dt).
    pub u: SVector<T, NU>,
    /// The call of the controller at this tick, if there was one.
    pub sample: Option<S>,
}
