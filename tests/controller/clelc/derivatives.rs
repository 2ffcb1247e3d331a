//! The loop runs on dual numbers, so it can be differentiated with respect to its parameters.

use brunovsky::{
    Scalar,
    controller::{Clelc, Controller, FeedbackLinearization, Gains, Measurement, Reference},
    fuzzy::FuzzyNetwork,
    learning::{BackwardDifference, NeuroFuzzy, SlidingMode, Switching},
    plant::{ThirdOrder, Uncertain},
    simulation::Simulation,
};
use num_dual::Dual64;

use crate::support::{learning, num};

/// The input at the second of two samples, as a function of one state of the second.
fn input<T: Scalar>(x3: T) -> T {
    let rule = SlidingMode::new(num::<T>(25.0)).unwrap();
    let rule = rule.with_switching(Switching::Implicit { delta: num(0.5) }).unwrap();
    let mut controller = learning(ThirdOrder::<T>::new(), 3.0, BackwardDifference::new(), rule);
    let mut update = |x: [T; 3]| {
        controller
            .update(&Measurement::new(x), &Reference::setpoint(T::zero()), num(0.01))
            .unwrap()
            .u
    };
    update([1.0, -1.0, -10.0].map(num));
    update([num(0.99), num(-1.1), x3])
}

/// x₁ after half a second of the closed loop with poles at −λ and learning rate α, under Δ = 5·sin t.
fn closed_loop<T: Scalar>(lambda: T, alpha: T) -> T {
    let gains = Gains::from_lambda(lambda).unwrap();
    let base = FeedbackLinearization::new(ThirdOrder::<T>::new(), gains);
    // A smooth sign makes the loop differentiable where the samples do not pass through a switch.
    let rule = SlidingMode::new(alpha).unwrap();
    let rule = rule.with_switching(Switching::Implicit { delta: num(0.5) }).unwrap();
    let network = FuzzyNetwork::<T, 3, 3>::evenly_spaced([1.0, 1.0, 10.0].map(num)).unwrap();
    let controller = Clelc::new(base, NeuroFuzzy::new(network, BackwardDifference::new(), rule));
    let plant =
        Uncertain::matched(ThirdOrder::<T>::new(), |t: T, _: &_, _: &_| num::<T>(5.0) * t.sin());
    let start = [1.0, -1.0, -10.0].map(num::<T>);
    let simulation =
        Simulation::new(&plant, controller, |_| Reference::setpoint(T::zero()), start, num(0.01))
            .unwrap();
    simulation.take(51).last().unwrap().unwrap().x[0]
}

/// The derivative by dual numbers is that of the central difference, whose error is (h²/6)·|f‴| + ε·|f|/h.
fn agrees(dual: impl Fn(Dual64) -> Dual64, real: impl Fn(f64) -> f64, at: f64) {
    let found = dual(Dual64::new(at, 1.0));
    let value = real(at);
    // Quotients of dual numbers round once more than those of f64.
    approx::assert_relative_eq!(found.re, value, max_relative = 1e-12);
    let difference = |h: f64| (real(at + h) - real(at - h)) / (2.0 * h);
    let (coarse, fine) = (difference(2e-4 * at.abs()), difference(1e-4 * at.abs()));
    // Richardson: the difference of the two is three times the error of the finer.
    let richardson = fine + (fine - coarse) / 3.0;
    assert!(found.eps.abs() > 1e-6, "it does depend on it");
    approx::assert_relative_eq!(found.eps, richardson, max_relative = 1e-7);
}

#[test]
fn one_step_is_differentiated_by_dual_numbers() {
    agrees(input, input, -9.0);
}

#[test]
fn a_whole_run_is_differentiated_with_respect_to_the_gains() {
    agrees(|v| closed_loop(v, num(25.0)), |v| closed_loop(v, 25.0), 3.0);
}

#[test]
fn a_whole_run_is_differentiated_with_respect_to_the_learning_rate() {
    agrees(|v| closed_loop(num(3.0), v), |v| closed_loop(3.0, v), 25.0);
}
