//! What is counted is what was spent.

use core::cell::Cell;

use brunovsky::integrators::{Adaptive, DormandPrince, Linearization, Rodas, Tolerance};
use nalgebra::{SMatrix, SVector};

use super::{pendulum, start};

#[test]
fn every_evaluation_is_counted() {
    let calls = Cell::new(0);
    let counted = |t: f64, x: &SVector<f64, 2>| {
        calls.set(calls.get() + 1);
        pendulum(t, x)
    };
    let mut explicit = start(DormandPrince, 1e-6, counted, [2.0, 0.0]);
    explicit.advance(10.0).unwrap();
    assert_eq!(explicit.statistics().evaluations, calls.get());
    calls.set(0);
    let mut stiff = start(Rodas::new(), 1e-6, counted, [2.0, 0.0]);
    stiff.advance(10.0).unwrap();
    assert_eq!(stiff.statistics().evaluations, calls.get());
}

/// Two evaluations find the first step, and six each make an attempt: the seventh stage of one step is the first of the next, also where
/// one call ends and the next goes on.
#[test]
fn the_last_stage_is_used_again() {
    let mut solver = start(DormandPrince, 1e-6, pendulum::<f64>, [2.0, 0.0]);
    for end in [1.0, 2.5, 2.5, 7.0, 40.0] {
        solver.advance(end).unwrap();
    }
    let spent = solver.statistics();
    assert!(spent.rejected > 0, "or this shows less than it says");
    assert_eq!(spent.evaluations, 2 + 6 * (spent.accepted + spent.rejected));
    assert_eq!((spent.jacobians, spent.factorizations), (0, 0));
}

/// One linearization for each start of a step, kept when the step is rejected; one factorization for each attempt. f is evaluated at the
/// start and five times in each attempt, and three times for differences in two states and time.
#[test]
fn a_stiff_step_costs_what_is_stated() {
    let mut solver = start(Rodas::new(), 1e-6, pendulum::<f64>, [2.0, 0.0]);
    solver.advance(40.0).unwrap();
    let spent = solver.statistics();
    assert!(spent.rejected > 0, "or this shows less than it says");
    let attempts = spent.accepted + spent.rejected;
    assert_eq!((spent.jacobians, spent.factorizations), (spent.accepted, attempts));
    assert_eq!(spent.evaluations, 1 + 4 * spent.accepted + 5 * attempts);

    let exact = |t: f64, x: &SVector<f64, 2>| Linearization {
        x: SMatrix::<f64, 2, 2>::new(0.0, 1.0, -x[0].cos(), -0.1),
        t: SVector::from([0.0, -t.sin()]),
    };
    let mut solver = start(Rodas::with_jacobian(exact), 1e-6, pendulum::<f64>, [2.0, 0.0]);
    solver.advance(40.0).unwrap();
    let spent = solver.statistics();
    let attempts = spent.accepted + spent.rejected;
    assert_eq!(spent.evaluations, 1 + spent.accepted + 5 * attempts);
}

/// Neither the first step nor any other is longer than it may be, and the given first step is taken.
#[test]
fn lengths_of_steps_are_kept() {
    let tolerance = Tolerance::new(1e-3, 1e-3).unwrap();
    let settings = Adaptive::new(DormandPrince, tolerance);
    let slow = |_: f64, _: &SVector<f64, 1>| SVector::from([1.0]);
    let mut solver = settings.with_longest_step(0.25).unwrap().solve(slow, 0.0, [0.0]).unwrap();
    while solver.time() < 5.0 {
        solver.step().unwrap();
        // The difference of two times up to 5.25 is rounded.
        assert!(solver.time() - solver.step_start() <= 0.25 + 4.0 * f64::EPSILON);
    }
    let mut solver = settings.with_first_step(0.125).unwrap().solve(slow, 0.0, [0.0]).unwrap();
    solver.step().unwrap();
    assert_eq!(solver.time(), 0.125);
}

/// The step that ends at the time asked for may be short; the ones after it need not grow again from there.
#[test]
fn a_step_cut_short_is_no_reason_for_short_steps() {
    let steps = |stops: &[f64]| {
        let mut solver = start(DormandPrince, 1e-6, pendulum::<f64>, [2.0, 0.0]);
        for stop in stops {
            solver.advance(*stop).unwrap();
        }
        solver.statistics().accepted
    };
    let (undisturbed, cut) = (steps(&[40.0]), steps(&[10.0, 10.0001, 20.0, 20.0001, 40.0]));
    assert!(cut <= undisturbed + 5, "{cut} against {undisturbed}");
}
