//! Faults for closed loops to bear.

use brunovsky::{
    Error,
    controller::{Accept, Controller, Measurement},
    plant::{FeedbackLinearizable, Plant},
};
use nalgebra::SVector;

/// A controller whose sensor of ẋ says `says(ẋ)` during some samples, counted from its first.
#[derive(Debug, Clone, Copy)]
pub struct Faulty<C> {
    pub controller: C,
    pub says: fn(f64) -> f64,
    pub samples: [u32; 2],
    pub k: u32,
}

impl<C> Faulty<C> {
    pub fn new(controller: C, says: fn(f64) -> f64, samples: [u32; 2]) -> Self {
        Self { controller, says, samples, k: 0 }
    }
}

impl<C, const NX: usize, const NU: usize> Controller<NX, NU> for Faulty<C>
where
    C: Controller<NX, NU, Scalar = f64>,
{
    type Scalar = f64;
    type Reference = C::Reference;
    type Command = C::Command;

    fn update_if(
        &mut self,
        measurement: &Measurement<f64, NX, NU>,
        reference: &C::Reference,
        dt: f64,
        accept: Accept<C::Command>,
    ) -> Result<C::Command, Error> {
        let [from, until] = self.samples;
        let mut measurement = *measurement;
        if (from..until).contains(&self.k) {
            measurement.x_dot = measurement.x_dot.map(|x_dot| x_dot.map(self.says));
        }
        self.k += 1;
        self.controller.update_if(&measurement, reference, dt, accept)
    }

    fn reset(&mut self) {
        self.controller.reset();
    }
}

/// ẍ = −k·x − d·ẋ + b·u + Δ, of which the model believes that b = 1 and Δ = 0; from the time `since` on b is `gain`.
#[derive(Debug, Clone, Copy)]
pub struct Spring {
    pub stiffness: f64,
    pub damping: f64,
    pub gain: f64,
    pub since: f64,
    pub delta: f64,
}

impl FeedbackLinearizable<2> for Spring {
    type Scalar = f64;

    fn drift(&self, x: &SVector<f64, 2>) -> f64 {
        -self.stiffness * x[0] - self.damping * x[1]
    }

    fn input_gain(&self, _x: &SVector<f64, 2>) -> f64 {
        1.0
    }
}

/// The spring as it is, and not as the model says.
#[derive(Debug, Clone, Copy)]
pub struct Real(pub Spring);

impl Plant<2, 1> for Real {
    type Scalar = f64;

    fn derivative(&self, t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>) -> SVector<f64, 2> {
        let gain = if t < self.0.since { 1.0 } else { self.0.gain };
        SVector::from([x[1], self.0.drift(x) + gain * u[0] + self.0.delta])
    }
}
