//! Outputs between steps.

use brunovsky::integrators::{DormandPrince, Embedded, Rodas};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{pendulum, start};

fn steps_without(method: impl Embedded<f64, 2>, end: f64) -> Vec<(f64, SVector<f64, 2>)> {
    let mut solver = start(method, 1e-6, pendulum::<f64>, [2.0, 0.0]);
    let mut steps = vec![];
    while solver.time() < end {
        solver.step().unwrap();
        steps.push((solver.time(), *solver.state()));
    }
    steps
}

fn steps_with(method: impl Embedded<f64, 2>, times: &[f64]) -> Vec<(f64, SVector<f64, 2>)> {
    let mut solver = start(method, 1e-6, pendulum::<f64>, [2.0, 0.0]);
    let mut steps = vec![];
    for time in times {
        solver.at(*time).unwrap();
        if steps.last().is_none_or(|(last, _)| *last < solver.time()) {
            steps.push((solver.time(), *solver.state()));
        }
    }
    steps
}

proptest! {
    /// Every step after which an output was asked for is one that is taken without outputs, bit for bit.
    #[test]
    fn the_steps_do_not_depend_on_the_outputs(mut times in prop::collection::vec(0.0..20.0_f64, 1..40)) {
        times.sort_by(f64::total_cmp);
        // The time 0 takes no step.
        times.retain(|time| *time > 0.0);
        prop_assume!(!times.is_empty());
        let without = steps_without(DormandPrince, 20.0);
        prop_assert!(steps_with(DormandPrince, &times).iter().all(|step| without.contains(step)));
        let without = steps_without(Rodas::new(), 20.0);
        prop_assert!(steps_with(Rodas::new(), &times).iter().all(|step| without.contains(step)));
    }
}

/// Between the ends of a step the error is of the size of that at the ends: ẋ = −x from 1, at 400 times.
fn follows_the_solution(method: impl Embedded<f64, 1>, bound: f64) {
    let decay = |_: f64, x: &SVector<f64, 1>| -x;
    let mut solver = start(method, 1e-8, decay, [1.0]);
    for k in 0..=400 {
        let t = f64::from(k) * 0.01;
        let error = (solver.at(t).unwrap()[0] - (-t).exp()).abs();
        assert!(error < bound, "{error:e} at {t}");
    }
    assert!(solver.statistics().accepted < 200);
}

#[test]
fn the_output_between_steps_follows_the_solution() {
    follows_the_solution(DormandPrince, 1e-7);
    follows_the_solution(Rodas::autonomous(), 1e-7);
}

/// The ends of a step are met to the bit at its end and to rounding at its start.
#[test]
fn the_ends_of_a_step_are_states_of_the_solver() {
    let mut solver = start(DormandPrince, 1e-6, pendulum::<f64>, [2.0, 0.0]);
    for _ in 0..20 {
        let before = *solver.state();
        solver.step().unwrap();
        assert_eq!(solver.interpolate(solver.step_start()).unwrap(), before);
        assert_eq!(solver.interpolate(solver.time()).unwrap(), *solver.state());
    }
}
