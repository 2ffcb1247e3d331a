//! Bad parameters are refused by name; a run that fails says so once and ends.

use brunovsky::{
    Error, Scalar,
    controller::{FeedbackLinearization, Gains, Reference},
    integrators::{Euler, Heun, Rk4},
    plant::{IntegratorChain, Plant},
    simulation::Simulation,
};
use nalgebra::SVector;

use super::{Scripted, idle};
use crate::{at_f32_and_f64, num};

fn refuses_bad_parameters<T: Scalar>() {
    let chain = IntegratorChain::<T, 2>::new();
    let new =
        |dt: f64, x2: f64| Simulation::new(&chain, idle(), |t| t, [T::one(), num(x2)], num(dt));
    for value in [0.0, -0.0, -0.125] {
        assert_eq!(new(value, 0.0).err(), Some(Error::NotPositive { name: "dt", value }));
    }
    let good = || new(0.125, 0.0).unwrap();
    let no_steps = Error::NotPositive { name: "substeps", value: 0.0 };
    assert_eq!(good().substeps(0).err(), Some(no_steps));
    let past = Error::Negative { name: "t_end", value: -0.5 };
    assert_eq!(good().until(num(-0.5)).err(), Some(past));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(new(bad, 0.0).err(), Some(Error::NonFinite { name: "dt", .. })));
        assert!(matches!(
            new(0.1, bad).err(),
            Some(Error::NonFiniteEntry { name: "x0", index: 1, .. })
        ));
        assert!(matches!(
            good().until(num(bad)).err(),
            Some(Error::NonFinite { name: "t_end", .. })
        ));
    }
}

/// A reference that turns bad at the fourth sample: three samples, the error, and then nothing.
fn ends_after_an_error_of_the_controller<T: Scalar>() {
    let chain = IntegratorChain::<T, 1>::new();
    let flc = FeedbackLinearization::new(chain, Gains::new([T::one()]).unwrap());
    let reference = |t: T| Reference::setpoint(if t < num(0.3) { T::one() } else { num(f64::NAN) });
    let mut simulation = Simulation::new(&chain, flc, reference, [T::zero()], num(0.125)).unwrap();
    assert!(simulation.by_ref().take(3).all(|sample| sample.is_ok()));
    let error = simulation.next().unwrap().unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "r", index: 0, .. }));
    for _ in 0..3 {
        assert_eq!(simulation.next(), None);
    }
}

/// ẋ = x² from 1 leaves every range soon after t = 1, whatever the input.
struct Explosive<T>(T);

impl<T: Scalar> Plant<1, 1> for Explosive<T> {
    type Scalar = T;

    fn derivative(&self, _t: T, x: &SVector<T, 1>, _u: &SVector<T, 1>) -> SVector<T, 1> {
        x.map(|x| x * x * self.0)
    }
}

fn reports_a_plant_that_blows_up<T: Scalar>() {
    let plant = Explosive(T::one());
    let run = || Simulation::new(&plant, idle(), |t| t, [T::one()], num(0.125)).unwrap();
    let errors = [
        run().integrator(Rk4).take(100).collect::<Result<Vec<_>, _>>().unwrap_err(),
        run().integrator(Heun).take(100).collect::<Result<Vec<_>, _>>().unwrap_err(),
        run().integrator(Euler).take(100).collect::<Result<Vec<_>, _>>().unwrap_err(),
    ];
    for error in errors {
        assert!(matches!(error, Error::NonFiniteEntry { name: "x", index: 0, .. }));
    }
    // Up to the pole there is a solution, x = 1/(1 − t), and samples of it.
    let samples = run().until(num(0.75)).unwrap().collect::<Result<Vec<_>, _>>().unwrap();
    approx::assert_relative_eq!(samples[6].x[0], num(4.0), max_relative = num(1e-5));
}

/// A command that is not finite does not reach the plant.
fn reports_an_input_that_is_not_finite<T: Scalar>() {
    let chain = IntegratorChain::<T, 1>::new();
    let script = |k: usize| SVector::from([num::<T>(if k == 2 { f64::NAN } else { 1.0 })]);
    let mut simulation =
        Simulation::new(&chain, Scripted::new(script), |t| t, [T::zero()], T::one()).unwrap();
    assert!(simulation.by_ref().take(2).all(|sample| sample.is_ok()));
    let error = simulation.next().unwrap().unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "u", index: 0, .. }));
    assert_eq!(simulation.next(), None);
}

at_f32_and_f64! {
    parameters_out_of_range_are_refused_by_name => refuses_bad_parameters,
    an_error_of_the_controller_ends_the_run => ends_after_an_error_of_the_controller,
    a_plant_that_blows_up_ends_the_run => reports_a_plant_that_blows_up,
    an_input_that_is_not_finite_ends_the_run => reports_an_input_that_is_not_finite,
}
