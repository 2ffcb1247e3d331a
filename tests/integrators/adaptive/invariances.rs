//! What must not change the solution, or must change it in a known way.

use brunovsky::integrators::{Adaptive, DormandPrince, Embedded, Rodas, Solver, Tolerance};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{pendulum, start};

/// The solution run backwards from its end: y(s) = x(T − s) solves ẏ = −f(T − s, y) and ends where x started.
fn returns(method: impl Embedded<f64, 2> + Copy, bound: f64) {
    let begin = [2.0, -0.5];
    let mut forth = start(method, 1e-9, pendulum::<f64>, begin);
    let end = *forth.advance(6.0).unwrap();
    let reversed = |s: f64, y: &SVector<f64, 2>| -pendulum(6.0 - s, y);
    let mut back = start(method, 1e-9, reversed, end.into());
    let error = (back.advance(6.0).unwrap() - SVector::from(begin)).norm();
    assert!(error < bound, "{error}");
}

/// Two runs of 6 s, each within about a hundred times the tolerance of a step.
#[test]
fn backwards_in_time_the_solution_returns_to_its_start() {
    returns(DormandPrince, 1e-7);
    returns(Rodas::new(), 1e-7);
}

/// x, t and what was spent, in units of `length` and `time`.
fn in_units(
    method: impl Embedded<f64, 2>,
    (length, time): (f64, f64),
) -> (SVector<f64, 2>, f64, u64) {
    let f = move |t: f64, x: &SVector<f64, 2>| pendulum(t / time, &(x / length)) * (length / time);
    let settings = Adaptive::new(method, Tolerance::new(1e-6, 1e-6 * length).unwrap());
    let settings = settings.with_first_step(0.01 * time).unwrap();
    let mut solver = settings.solve(f, 0.0, [2.0 * length, 0.0]).unwrap();
    let x = *solver.advance(6.0 * time).unwrap();
    (x / length, solver.time() / time, solver.statistics().evaluations)
}

proptest! {
    /// In units that are a power of two apart every operation rounds the same, so every bit is the same.
    #[test]
    fn units_of_state_and_time_do_not_matter(length in -20..20_i32, time in -20..20_i32) {
        let units = (2.0_f64.powi(length), 2.0_f64.powi(time));
        prop_assert_eq!(in_units(DormandPrince, units), in_units(DormandPrince, (1.0, 1.0)));
    }

    /// The same with RODAS, whose differences move by √ε, not a power of two in general, but the same fraction of x in all units.
    #[test]
    fn units_do_not_matter_for_differences_either(length in -20..20_i32, time in -20..20_i32) {
        let units = (2.0_f64.powi(length), 2.0_f64.powi(time));
        prop_assert_eq!(in_units(Rodas::new(), units), in_units(Rodas::new(), (1.0, 1.0)));
    }
}

/// The end of a run, bit for bit.
fn end<F>(mut solver: Solver<DormandPrince, F, f64, 2>) -> SVector<f64, 2>
where
    F: FnMut(f64, &SVector<f64, 2>) -> SVector<f64, 2>,
{
    *solver.advance(9.0).unwrap()
}

/// From a restart on, nothing of the time before is left: neither its last stage nor its step.
#[test]
fn a_restart_is_a_new_start() {
    let mut solver = start(DormandPrince, 1e-7, pendulum::<f64>, [2.0, 0.0]);
    solver.advance(4.0).unwrap();
    solver.restart([0.3, -1.0]).unwrap();
    assert_eq!(solver.step_start(), 4.0);
    let settings = Adaptive::new(DormandPrince, Tolerance::new(1e-7, 1e-7).unwrap());
    assert_eq!(end(solver), end(settings.solve(pendulum::<f64>, 4.0, [0.3, -1.0]).unwrap()));
}

/// From a declared jump on neither, so a run in one piece is the run of its pieces.
#[test]
fn a_declared_jump_is_a_new_start() {
    let settings = Adaptive::new(DormandPrince, Tolerance::new(1e-7, 1e-7).unwrap());
    let solver = start(DormandPrince, 1e-7, pendulum::<f64>, [2.0, 0.0]);
    let whole = end(solver.with_discontinuities(&[4.0]).unwrap());
    let jump = [4.0];
    let first = start(DormandPrince, 1e-7, pendulum::<f64>, [2.0, 0.0]);
    let mut first = first.with_discontinuities(&jump).unwrap();
    let middle = *first.advance(4.0).unwrap();
    assert_eq!(whole, end(settings.solve(pendulum::<f64>, 4.0, middle).unwrap()));
}
