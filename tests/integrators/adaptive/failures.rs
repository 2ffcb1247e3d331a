//! Bad input is refused by name; a run that fails says where, and stands at the last good state.

use brunovsky::{
    Error, Scalar,
    integrators::{Adaptive, DormandPrince, Embedded, Rodas, Tolerance},
};
use nalgebra::SVector;

use super::{num, pendulum, start};

#[test]
fn settings_out_of_range_are_refused_by_name() {
    let refused = |rtol, atol| Tolerance::<f64, 2>::new(rtol, atol).unwrap_err();
    assert_eq!(refused(-1e-3, 1.0), Error::Negative { name: "rtol", value: -1e-3 });
    assert_eq!(refused(1e-3, 0.0), Error::NotPositive { name: "atol", value: 0.0 });
    assert!(matches!(refused(f64::NAN, 1.0), Error::NonFinite { name: "rtol", .. }));
    assert!(matches!(refused(0.0, f64::INFINITY), Error::NonFinite { name: "atol", .. }));
    let each = Tolerance::<f64, 2>::per_component(0.0, [1e-3, -1.0]).unwrap_err();
    assert_eq!(each, Error::NotPositive { name: "atol", value: -1.0 });

    let settings = Adaptive::new(DormandPrince, Tolerance::<f64, 2>::new(1e-3, 1e-3).unwrap());
    let first = Error::NotPositive { name: "first step", value: 0.0 };
    assert_eq!(settings.with_first_step(0.0).unwrap_err(), first);
    let longest = Error::NotPositive { name: "longest step", value: -1.0 };
    assert_eq!(settings.with_longest_step(-1.0).unwrap_err(), longest);
    let limit = Error::NotPositive { name: "step limit", value: 0.0 };
    assert_eq!(settings.with_step_limit(0).unwrap_err(), limit);
    let bad = settings.solve(pendulum::<f64>, f64::NAN, [0.0, 0.0]);
    assert!(matches!(bad.err(), Some(Error::NonFinite { name: "t0", .. })));
    let bad = settings.solve(pendulum::<f64>, 0.0, [0.0, f64::NAN]);
    assert!(matches!(bad.err(), Some(Error::NonFiniteEntry { name: "x0", index: 1, .. })));
}

#[test]
fn times_out_of_range_are_refused_by_name() {
    let mut solver = start(DormandPrince, 1e-6, pendulum::<f64>, [2.0, 0.0]);
    solver.advance(1.0).unwrap();
    let x = *solver.state();
    let past = Error::NotBelow { name: "t", value: 1.0, limit: 0.5 };
    assert_eq!(solver.advance(0.5).unwrap_err(), past);
    assert!(matches!(solver.advance(f64::NAN), Err(Error::NonFinite { name: "t_end", .. })));
    assert!(matches!(solver.at(f64::INFINITY), Err(Error::NonFinite { name: "t", .. })));
    let gone = solver.interpolate(-1.0).unwrap_err();
    assert!(matches!(gone, Error::NotBelow { name: "start of the step", limit: -1.0, .. }));
    let to_come = Error::NotBelow { name: "t", value: 1.5, limit: 1.0 };
    assert_eq!(solver.interpolate(1.5).unwrap_err(), to_come);
    let bad = solver.restart([0.0, f64::NAN]).unwrap_err();
    assert!(matches!(bad, Error::NonFiniteEntry { name: "x", index: 1, .. }));
    assert_eq!((solver.time(), *solver.state()), (1.0, x));
    let solver = start(DormandPrince, 1e-6, pendulum::<f64>, [2.0, 0.0]);
    let falling = Error::NotBelow { name: "discontinuity", value: 2.0, limit: 1.0 };
    assert_eq!(solver.with_discontinuities(&[2.0, 1.0]).err(), Some(falling));
}

/// ẋ = x² from 1 is 1/(1 − t): a pole at 1, and the solver ends close to it with a state that is still right.
fn stops_before_a_pole<T: Scalar>(method: impl Embedded<T, 1>, tolerance: f64) {
    let square = |_: T, x: &SVector<T, 1>| x.map(|x| x * x);
    let mut solver = start(method, tolerance, square, [1.0]);
    let Err(Error::StepTooSmall { time, step }) = solver.advance(num(2.0)) else {
        panic!("there is no solution at 2");
    };
    assert!((time - 1.0).abs() < 1e-3, "{time}");
    assert!(step > 0.0 && step < 1e-4);
    assert_eq!(num::<T>(time), solver.time());
    assert!(solver.state()[0] > num(1e3) && solver.state()[0].is_finite());
}

#[test]
fn a_pole_ends_the_run_before_it() {
    stops_before_a_pole::<f32>(DormandPrince, 1e-5);
    stops_before_a_pole::<f64>(DormandPrince, 1e-8);
    stops_before_a_pole::<f32>(Rodas::autonomous(), 1e-5);
    stops_before_a_pole::<f64>(Rodas::autonomous(), 1e-8);
}

/// An f that ends at t = 0.5: the solver comes within `reach`, on the solution x = t.
fn stops_where_f_ends(method: impl Embedded<f64, 2>, reach: f64) {
    let ending =
        |t: f64, _: &SVector<f64, 2>| SVector::from([1.0, if t > 0.5 { f64::NAN } else { 0.0 }]);
    let mut solver = start(method, 1e-6, ending, [0.0, 0.0]);
    let Err(Error::StepTooSmall { time, .. }) = solver.advance(1.0) else {
        panic!("there is no solution at 1");
    };
    assert_eq!(time, solver.time());
    assert!(time <= 0.5 && 0.5 - time < reach, "{time}");
    approx::assert_relative_eq!(solver.state()[0], time, max_relative = 1e-14);
    assert!(solver.statistics().rejected > 5);
}

/// As far as steps above rounding go; differences in time look ahead by √ε·t = 7e-9.
#[test]
fn an_f_that_ends_ends_the_run_there() {
    stops_where_f_ends(DormandPrince, 1e-14);
    stops_where_f_ends(Rodas::new(), 1e-8);
    stops_where_f_ends(Rodas::autonomous(), 1e-14);
}

#[test]
fn an_f_that_is_not_finite_where_the_solver_stands_is_named_with_the_time() {
    let bad =
        |t: f64, _: &SVector<f64, 2>| SVector::from([0.0, if t < 3.0 { 1.0 } else { t / 0.0 }]);
    let settings = Adaptive::new(DormandPrince, Tolerance::new(1e-6, 1e-6).unwrap());
    let mut solver = settings.solve(bad, 3.0, [1.0, 2.0]).unwrap();
    let error = Error::NonFiniteRate { time: 3.0, index: 1, value: f64::INFINITY };
    assert_eq!(solver.step(), Err(error));
    assert_eq!((solver.time(), *solver.state()), (3.0, SVector::from([1.0, 2.0])));
    // Declared, the jump is the end of the run up to it.
    let solver = settings.solve(bad, 0.0, [1.0, 2.0]).unwrap();
    let mut solver = solver.with_discontinuities(&[3.0]).unwrap();
    assert_eq!(solver.advance(4.0), Err(error));
    assert_eq!(solver.time(), 3.0);
    approx::assert_relative_eq!(solver.state()[1], 5.0, max_relative = 1e-14);
}

/// The limit counts the steps of one call; what it reached is kept, and another call goes on.
#[test]
fn a_call_takes_no_more_steps_than_it_may() {
    let settings = Adaptive::new(DormandPrince, Tolerance::new(1e-9, 1e-9).unwrap());
    let settings = settings.with_step_limit(20).unwrap();
    let mut solver = settings.solve(pendulum::<f64>, 0.0, [2.0, 0.0]).unwrap();
    let error = solver.advance(100.0).unwrap_err();
    assert_eq!(error, Error::TooManySteps { time: solver.time(), limit: 20 });
    let mut calls = 1;
    while solver.advance(100.0).is_err() {
        calls += 1;
    }
    let steps = solver.statistics().accepted + solver.statistics().rejected;
    assert!(steps > 20 * (calls - 1) && steps <= 22 * calls);
    let mut free = start(DormandPrince, 1e-9, pendulum::<f64>, [2.0, 0.0]);
    assert_eq!(free.advance(100.0).unwrap(), solver.state());
}
