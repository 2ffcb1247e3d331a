//! The sampled loop: hold, order of events, times, counts, failures.

mod adaptive;
mod failures;
mod hold;
mod measurements;
mod times;

use brunovsky::{
    Error, Scalar,
    controller::{Accept, Controller, Measurement},
};
use nalgebra::SVector;

/// Plays inputs given as a function of the sample's number and keeps what it was told.
#[derive(Debug, Clone)]
struct Scripted<T: Scalar, F, const NX: usize, const NU: usize> {
    script: F,
    heard: Vec<(Measurement<T, NX, NU>, T, T)>,
}

impl<T: Scalar, F, const NX: usize, const NU: usize> Scripted<T, F, NX, NU> {
    fn new(script: F) -> Self
    where
        F: Fn(usize) -> SVector<T, NU>,
    {
        Self { script, heard: Vec::new() }
    }
}

impl<T: Scalar, F, const NX: usize, const NU: usize> Controller<NX, NU> for Scripted<T, F, NX, NU>
where
    F: Fn(usize) -> SVector<T, NU>,
{
    type Scalar = T;
    /// The time that the reference was asked for.
    type Reference = T;
    type Command = SVector<T, NU>;

    fn update_if(
        &mut self,
        measurement: &Measurement<T, NX, NU>,
        reference: &T,
        dt: T,
        accept: Accept<SVector<T, NU>>,
    ) -> Result<SVector<T, NU>, Error> {
        let u = (self.script)(self.heard.len());
        accept(&u)?;
        self.heard.push((*measurement, *reference, dt));
        Ok(u)
    }

    fn reset(&mut self) {
        self.heard.clear();
    }
}

/// u = 0 for ever.
fn idle<T: Scalar, const NX: usize>() -> Scripted<T, fn(usize) -> SVector<T, 1>, NX, 1> {
    Scripted::new(|_| SVector::zeros())
}
