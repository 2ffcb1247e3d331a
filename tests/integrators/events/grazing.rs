//! Touches, double crossings and zeros at the start: what is found and what is not, as the documentation says.

use brunovsky::integrators::{Crossing, Direction, Events};
use nalgebra::SVector;

use super::{all, clock};

/// (x − 7.3)² + depth: two crossings 2·√−depth apart, one touch, or none.
fn parabola(depth: f64) -> impl FnMut(f64, &SVector<f64, 1>) -> [f64; 1] {
    move |_, x| [(x[0] - 7.3) * (x[0] - 7.3) + depth]
}

/// The step that holds 7.3 is some 10 s long, so ten points are 1 s apart and a hundred 0.1 s.
#[test]
fn two_crossings_are_found_if_a_point_falls_between_them() {
    let found = |depth, points| {
        let events = Events::new(parabola(depth), [Crossing::both()]);
        let mut events = events.with_points(points).unwrap();
        all(&mut clock(), &mut events, 100.0).len()
    };
    assert_eq!(found(-4.0, 10), 2, "4 s apart, with ten points");
    assert_eq!(found(-1e-4, 10), 0, "0.02 s apart, with ten points");
    assert_eq!(found(-1e-4, 10_000), 2, "0.02 s apart, with enough");
    assert_eq!(found(1e-4, 10_000), 0, "no crossing");
}

/// A double root is no change of sign.
#[test]
fn a_touch_is_no_event() {
    let mut events = Events::new(parabola(0.0), [Crossing::both()]);
    assert_eq!(all(&mut clock(), &mut events, 100.0), []);
}

/// Unless a point hits it to the last bit, here at the end of a step, where g ≤ 0 after g > 0 is what an event is; on the way back from
/// zero there is none.
#[test]
fn a_touch_that_is_hit_is_reported_once() {
    let mut solver = clock();
    let g = |t: f64, _: &SVector<f64, 1>| [(t - 7.3) * (t - 7.3)];
    let mut events = Events::new(g, [Crossing::both()]);
    assert_eq!(solver.next_event(7.3, &mut events).unwrap().map(|event| event.t), Some(7.3));
    assert_eq!(all(&mut solver, &mut events, 100.0), []);
}

/// A function that reaches zero and stays there has one event, at the time it gets there.
#[test]
fn a_function_that_stays_at_zero_has_one_event() {
    let g = |_: f64, x: &SVector<f64, 1>| [(7.3 - x[0]).max(0.0)];
    let mut events = Events::new(g, [Crossing::both()]);
    let found = all(&mut clock(), &mut events, 100.0);
    assert_eq!(found.len(), 1);
    approx::assert_relative_eq!(found[0].t, 7.3, max_relative = 1e-14);
    assert_eq!(found[0].direction, Direction::Falling);
}

/// Zero at the start is not an event, whichever way the function leaves; its next crossing is one, also within the first step.
#[test]
fn a_zero_at_the_start_is_no_event() {
    for sign in [1.0, -1.0] {
        for next in [1e-3, 0.5, 40.0] {
            let g = move |_: f64, x: &SVector<f64, 1>| [sign * x[0] * (next - x[0])];
            let mut events = Events::new(g, [Crossing::both()]);
            let found = all(&mut clock(), &mut events, 100.0);
            assert_eq!(found.len(), 1, "next at {next}: {found:?}");
            approx::assert_relative_eq!(found[0].t, next, max_relative = 1e-12);
        }
    }
}

/// Restarted at its event, a function may leave zero either way: neither is the event again.
#[test]
fn a_restart_at_an_event_is_no_event() {
    for offset in [0.0, 1e-15, -1e-15] {
        let mut solver = clock();
        let g = |_: f64, x: &SVector<f64, 1>| [(x[0] - 7.3) * (9.5 - x[0])];
        let mut events = Events::new(g, [Crossing::both().terminal()]);
        let first = solver.next_event(100.0, &mut events).unwrap().unwrap();
        solver.restart([7.3 + offset]).unwrap();
        let second = solver.next_event(100.0, &mut events).unwrap().unwrap();
        approx::assert_relative_eq!(first.t, 7.3, max_relative = 1e-14);
        approx::assert_relative_eq!(second.t, 9.5, max_relative = 1e-14);
        assert_eq!((first.direction, second.direction), (Direction::Rising, Direction::Falling));
        assert_eq!(solver.next_event(100.0, &mut events).unwrap(), None);
    }
}

/// An event at the very end is in time; the ones after it are found by the next call.
#[test]
fn an_event_at_the_end_is_in_time() {
    let g = |t: f64, _: &SVector<f64, 1>| [t - 5.0, t - 6.0];
    let mut events = Events::new(g, [Crossing::rising(); 2]);
    let mut solver = clock();
    assert_eq!(solver.next_event(5.0, &mut events).unwrap().unwrap().t, 5.0);
    assert_eq!(solver.next_event(5.0, &mut events).unwrap(), None);
    let next = solver.next_event(7.0, &mut events).unwrap().unwrap();
    assert_eq!(next.index, 1);
}

/// What other calls pass is not looked at, and is no crossing afterwards.
#[test]
fn time_that_other_calls_pass_is_not_looked_at() {
    let g = |t: f64, _: &SVector<f64, 1>| [t - 5.0, t - 9.0];
    let mut events = Events::new(g, [Crossing::both(); 2]);
    let mut solver = clock();
    assert_eq!(solver.next_event(1.0, &mut events).unwrap(), None);
    solver.advance(6.0).unwrap();
    solver.advance(8.0).unwrap();
    let found = all(&mut solver, &mut events, 20.0);
    assert_eq!(found.iter().map(|event| event.index).collect::<Vec<_>>(), [1]);
}
