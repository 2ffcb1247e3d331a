//! Where f jumps in time.

use brunovsky::integrators::{Adaptive, DormandPrince, Embedded, Rodas, Tolerance};
use nalgebra::SVector;

use super::{pendulum, start};

/// A time that no step of a power of two reaches.
const SWITCH: f64 = 0.709;

/// ẋ = −x, and ẋ = −x + 2 from the switch on.
fn switched(t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
    SVector::from([if t >= SWITCH { 2.0 - x[0] } else { -x[0] }])
}

/// Its solution from 1: e^−t, and 2 + (e^−c − 2)·e^−(t − c) from the switch on.
fn exact(t: f64) -> f64 {
    if t < SWITCH { (-t).exp() } else { 2.0 + ((-SWITCH).exp() - 2.0) * (SWITCH - t).exp() }
}

/// The error at t = 2 with steps of h that no tolerance shortens.
fn error(method: impl Embedded<f64, 1>, h: f64, declared: &[f64]) -> f64 {
    let settings = Adaptive::new(method, Tolerance::new(1e6, 1e6).unwrap());
    let settings = settings.with_first_step(h).unwrap().with_longest_step(h).unwrap();
    let solver = settings.solve(switched, 0.0, [1.0]).unwrap();
    let mut solver = solver.with_discontinuities(declared).unwrap();
    (solver.advance(2.0).unwrap()[0] - exact(2.0)).abs()
}

/// The exponent of error ∝ hᵖ over a factor of 16 in h, so that what is left over before the switch evens out.
fn order(method: impl Embedded<f64, 1> + Copy, declared: &[f64]) -> f64 {
    (error(method, 0.25, declared) / error(method, 0.25 / 16.0, declared)).log2() / 4.0
}

#[test]
fn a_declared_jump_leaves_the_order_and_one_that_is_not_declared_takes_it() {
    let (explicit, stiff) = (DormandPrince, Rodas::autonomous());
    let declared = order(explicit, &[SWITCH]);
    assert!((declared - 5.0).abs() < 0.3, "{declared}");
    let smeared = order(explicit, &[]);
    assert!(smeared < 2.0, "{smeared}");
    let declared = order(stiff, &[SWITCH]);
    assert!((declared - 4.0).abs() < 0.3, "{declared}");
    let smeared = order(stiff, &[]);
    assert!(smeared < 2.0, "{smeared}");
}

/// Under a tolerance both arrive, but only one without stumbling.
#[test]
fn a_declared_jump_costs_no_rejected_steps() {
    let run = |declared: &[f64]| {
        let solver = start(DormandPrince, 1e-8, switched, [1.0]);
        let mut solver = solver.with_discontinuities(declared).unwrap();
        let error = (solver.advance(2.0).unwrap()[0] - exact(2.0)).abs();
        (error, solver.statistics())
    };
    let (error, spent) = run(&[SWITCH]);
    assert!(error < 1e-7, "{error}");
    assert_eq!(spent.rejected, 0);
    // It starts anew after the jump: two evaluations there as at the start.
    assert_eq!(spent.evaluations, 4 + 6 * spent.accepted);
    let (_, stumbled) = run(&[]);
    assert!(stumbled.rejected > 3);
    assert!(stumbled.evaluations > spent.evaluations * 3 / 2);
}

/// The first time at or after a jump that f is shown is the jump itself, where the solver starts anew, and no earlier one is shown again.
fn sees_each_piece_for_itself(method: impl Embedded<f64, 2>) {
    let jumps = [0.5, 1.25, 3.0];
    let mut shown = vec![];
    let watched = |t: f64, x: &SVector<f64, 2>| {
        shown.push(t);
        pendulum(t, x)
    };
    let mut solver = start(method, 1e-6, watched, [2.0, 0.0]).with_discontinuities(&jumps).unwrap();
    // One end is a jump, the others are not.
    for end in [0.25, 2.0, 3.0, 4.0] {
        solver.advance(end).unwrap();
        assert_eq!(solver.time(), end);
    }
    drop(solver);
    for jump in jumps {
        let first = shown.iter().position(|t| *t >= jump).unwrap();
        assert_eq!(shown[first], jump);
        assert!(shown[first..].iter().all(|t| *t >= jump));
    }
    assert!(shown.iter().all(|t| *t <= 4.0));
}

#[test]
fn no_step_sees_beyond_a_jump_or_the_end() {
    sees_each_piece_for_itself(DormandPrince);
    sees_each_piece_for_itself(Rodas::new());
}

/// A jump at a time that is not there, or after the end, changes nothing.
#[test]
fn a_jump_that_is_not_met_changes_nothing() {
    let run = |declared: &[f64]| {
        let solver = start(DormandPrince, 1e-6, pendulum::<f64>, [2.0, 0.0]);
        let mut solver = solver.with_discontinuities(declared).unwrap();
        let end = *solver.advance(4.0).unwrap();
        (end, solver.statistics())
    };
    assert_eq!(run(&[]), run(&[-3.0, 0.0, 4.5]));
}
