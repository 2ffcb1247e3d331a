//! Sensors, actuators and clocks of their own around a simulated controller.

mod clocks;
mod order;
mod timing;
mod views;

use std::{cell::RefCell, rc::Rc};

use brunovsky::{
    Error,
    controller::{Accept, Controller, Measurement},
};
use nalgebra::SVector;

/// A record that sensors, controllers and actuators share.
type Log<E> = Rc<RefCell<Vec<E>>>;

/// Answers a law of what it sees, and keeps (time of the reference, what it saw, dt).
#[derive(Clone)]
struct Recorded<F, const NY: usize> {
    law: F,
    heard: Log<(f64, Measurement<f64, NY, 1>, f64)>,
}

impl<F: Fn(&SVector<f64, NY>) -> f64, const NY: usize> Recorded<F, NY> {
    fn new(law: F) -> Self {
        Self { law, heard: Log::default() }
    }
}

impl<F: Fn(&SVector<f64, NY>) -> f64, const NY: usize> Controller<NY, 1> for Recorded<F, NY> {
    type Scalar = f64;
    /// The time that the reference was asked for.
    type Reference = f64;
    type Command = SVector<f64, 1>;

    fn update_if(
        &mut self,
        measurement: &Measurement<f64, NY, 1>,
        t: &f64,
        dt: f64,
        accept: Accept<SVector<f64, 1>>,
    ) -> Result<SVector<f64, 1>, Error> {
        let u = SVector::from([(self.law)(&measurement.x)]);
        accept(&u)?;
        self.heard.borrow_mut().push((*t, *measurement, dt));
        Ok(u)
    }

    fn reset(&mut self) {
        self.heard.borrow_mut().clear();
    }
}
