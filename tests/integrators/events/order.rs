//! Several events, and the same one again.

use core::cell::Cell;

use brunovsky::{
    Scalar,
    integrators::{Adaptive, Crossing, Direction, DormandPrince, Events, Tolerance},
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{all, clock, num};

/// Two events in one step are reported in the order of their times, not of their numbers; the solver stands at the end of the step.
#[test]
fn two_events_in_one_step_come_in_order() {
    let mut solver = clock::<f64>();
    let g = |_: f64, x: &SVector<f64, 1>| [x[0] - 7.25, 7.125 - x[0]];
    let mut events = Events::new(g, [Crossing::both(); 2]);
    let first = solver.next_event(100.0, &mut events).unwrap().unwrap();
    let stood = solver.time();
    let second = solver.next_event(100.0, &mut events).unwrap().unwrap();
    assert!(solver.step_start() < 7.125 && 7.25 < stood, "both are in one step");
    assert_eq!(stood, solver.time(), "which is not taken again");
    assert_eq!((first.index, first.direction), (1, Direction::Falling));
    assert_eq!((second.index, second.direction), (0, Direction::Rising));
    approx::assert_relative_eq!(first.t, 7.125, max_relative = 1e-14);
    approx::assert_relative_eq!(second.t, 7.25, max_relative = 1e-14);
    assert_eq!(solver.next_event(100.0, &mut events).unwrap(), None);
    assert_eq!(solver.time(), 100.0);
}

/// What comes after a terminal event in its step is found after it, in the steps taken from there.
#[test]
fn a_terminal_event_comes_between_others() {
    let mut solver = clock::<f64>();
    let g = |_: f64, x: &SVector<f64, 1>| [x[0] - 7.25, x[0] - 7.125, x[0] - 7.5];
    let crossings = [Crossing::rising().terminal(), Crossing::rising(), Crossing::rising()];
    let mut events = Events::new(g, crossings);
    let mut next = || {
        let event = solver.next_event(100.0, &mut events).unwrap().unwrap();
        (event.index, event.t, solver.time())
    };
    let (before, terminal, after) = (next(), next(), next());
    assert_eq!([before.0, terminal.0, after.0], [1, 0, 2]);
    assert!(before.2 > 7.5 && terminal.2 == terminal.1 && after.2 >= after.1);
    approx::assert_relative_eq!(after.1, 7.5, max_relative = 1e-14);
    assert_eq!(solver.next_event(100.0, &mut events).unwrap(), None);
}

/// At the same time those that are not terminal come first, then the lower number; none is lost.
#[test]
fn at_the_same_time_terminal_events_come_last() {
    let mut solver = clock::<f64>();
    let g = |_: f64, x: &SVector<f64, 1>| [x[0] - 7.25; 4];
    let (quiet, terminal) = (Crossing::rising(), Crossing::rising().terminal());
    let mut events = Events::new(g, [terminal, quiet, terminal, quiet]);
    let found = all(&mut solver, &mut events, 100.0);
    let order: Vec<usize> = found.iter().map(|event| event.index).collect();
    assert_eq!(order, [1, 3, 0, 2]);
    assert!(found.iter().all(|event| (event.t - 7.25).abs() < 1e-13));
}

proptest! {
    /// x = sin t is at ±½ at known times; each crossing is found once, in its direction, whether the solver stops there or not.
    #[test]
    fn every_crossing_is_found_once(level in -0.9..0.9_f64, terminal in any::<bool>(), digits in 4..10_i32) {
        let oscillator = |_: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]);
        let tolerance = 10.0_f64.powi(-digits);
        let method = Adaptive::new(DormandPrince, Tolerance::new(tolerance, tolerance).unwrap());
        let mut solver = method.solve(oscillator, 0.0, [0.0, 1.0]).unwrap();
        let wanted = [Crossing::rising(), Crossing::falling(), Crossing::both()];
        let wanted = wanted.map(|crossing| if terminal { crossing.terminal() } else { crossing });
        let mut events = Events::new(move |_, x: &SVector<f64, 2>| [x[0] - level; 3], wanted);
        let found = all(&mut solver, &mut events, 30.0);
        let turn = core::f64::consts::TAU;
        let up = (0..6).map(|k| level.asin() + turn * f64::from(k)).filter(|t| *t > 0.0 && *t < 30.0);
        let down = (0..6).map(|k| turn / 2.0 - level.asin() + turn * f64::from(k)).filter(|t| *t < 30.0);
        let times = |index| found.iter().filter(move |event| event.index == index);
        // The error of x in 30 s, through a slope of √(1 − 0.9²) = 0.44 at least, and again at each stop by the dense output.
        let bound = 3000.0 * tolerance;
        for (events, expected, direction) in [
            (times(0), up.collect::<Vec<_>>(), Direction::Rising),
            (times(1), down.collect::<Vec<_>>(), Direction::Falling),
        ] {
            let events: Vec<_> = events.collect();
            prop_assert_eq!(events.len(), expected.len());
            for (event, time) in events.iter().zip(expected) {
                prop_assert!((event.t - time).abs() < bound, "{} is not {}", event.t, time);
                prop_assert_eq!(event.direction, direction);
            }
        }
        prop_assert_eq!(times(2).count(), times(0).count() + times(1).count());
    }
}

/// A crossing is located to a few units of rounding of the time, on its far side.
fn located_to_rounding<T: Scalar>() {
    for target in [0.3, 1.0 / 7.0, 5.1, 17.77] {
        let target = num::<T>(target);
        let g = move |t: T, _: &SVector<T, 1>| [(t - target) * (t - target) * (t - target)];
        let mut events = Events::new(g, [Crossing::rising()]);
        let event = clock::<T>().next_event(num(20.0), &mut events).unwrap().unwrap();
        assert!(event.t >= target);
        // The step may be longer than the time is late.
        let unit = T::default_epsilon() * num(20.0);
        assert!(event.t - target <= unit * num(4.0), "{} is not {target}", event.t);
    }
}

#[test]
fn events_are_located_to_rounding_at_f32() {
    located_to_rounding::<f32>();
}

#[test]
fn events_are_located_to_rounding_at_f64() {
    located_to_rounding::<f64>();
}

/// A wider bracket takes fewer looks and stays within it.
#[test]
fn a_wider_tolerance_is_kept_and_takes_fewer_evaluations() {
    let looks = |tolerance: f64| {
        let count = Cell::new(0);
        let g = |_: f64, x: &SVector<f64, 1>| {
            count.set(count.get() + 1);
            [x[0].exp() - 5.0_f64.exp()]
        };
        let events = Events::new(g, [Crossing::rising()]);
        let mut events = events.with_tolerance(tolerance).unwrap();
        let event = clock::<f64>().next_event(6.0, &mut events).unwrap().unwrap();
        assert!(event.t >= 5.0 - 1e-14 && event.t <= 5.0 + tolerance);
        count.get()
    };
    assert!(looks(0.01) < looks(1e-14));
}
