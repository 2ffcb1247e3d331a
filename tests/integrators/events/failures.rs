//! Bad input is refused by name.

use brunovsky::{
    Error,
    integrators::{Crossing, Events},
};
use nalgebra::SVector;

use super::clock;

fn height(_: f64, x: &SVector<f64, 1>) -> [f64; 1] {
    [x[0] - 7.3]
}

#[test]
fn settings_out_of_range_are_refused_by_name() {
    let events = || Events::new(height, [Crossing::both()]);
    let points = Error::NotPositive { name: "points", value: 0.0 };
    assert_eq!(events().with_points(0).err(), Some(points));
    let tolerance = Error::NotPositive { name: "tolerance", value: -1.0 };
    assert_eq!(events().with_tolerance(-1.0).err(), Some(tolerance));
    let mut solver = clock::<f64>();
    solver.advance(1.0).unwrap();
    let past = Error::NotBelow { name: "t", value: 1.0, limit: 0.5 };
    assert_eq!(solver.next_event(0.5, &mut events()), Err(past));
    let endless = solver.next_event(f64::INFINITY, &mut events());
    assert!(matches!(endless, Err(Error::NonFinite { name: "t_end", .. })));
}

#[test]
fn an_event_function_that_is_not_finite_is_named() {
    let bad = |_: f64, x: &SVector<f64, 1>| [x[0] - 9.0, if x[0] > 3.0 { f64::NAN } else { 1.0 }];
    let mut events = Events::new(bad, [Crossing::both(); 2]);
    let mut solver = clock::<f64>();
    let error = solver.next_event(20.0, &mut events).unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "g(t, x)", index: 1, .. }));
}
