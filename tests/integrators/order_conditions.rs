//! Order conditions: a method of order p gives every rooted tree of up to p nodes its weight 1/γ, and some tree of p + 1 nodes not.
//!
//! The weights are read off a single step of the method itself, on the differential equations of the trees.
//!
//! # References
//! E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.2; *II*, IV.7 for Rosenbrock methods, whose weights
//! come out right with the exact Jacobian.

use brunovsky::integrators::{
    Attempt, DormandPrince, Embedded, Euler, Heun, Integrator, Point, Rk4, Rodas,
};
use nalgebra::SVector;

use crate::trees::{TREES, linearization, rate, trees};

type Weights = SVector<f64, TREES>;

/// The largest difference to θ^ρ/γ among the trees of each order, from 1 to 6.
fn defects(weights: &Weights, theta: f64) -> [f64; 6] {
    let mut defects = [0.0_f64; 6];
    for (tree, weight) in trees().iter().zip(weights) {
        let defect = (weight - theta.powi(tree.order) / tree.density).abs();
        let largest = &mut defects[tree.order as usize - 1];
        *largest = largest.max(defect);
    }
    defects
}

/// Up to order p nothing but the rounding of terms of up to some 50 remains; beyond, a defect that none of these methods has by accident.
fn have_order(weights: &Weights, theta: f64, order: i32) {
    for (defect, nodes) in defects(weights, theta).into_iter().zip(1..) {
        if nodes <= order {
            assert!(defect < 200.0 * f64::EPSILON, "{nodes} nodes: {defect:e}");
        } else if nodes == order + 1 {
            assert!(defect > 1e-4, "{nodes} nodes: {defect:e}");
        }
    }
}

fn fixed<I: Integrator>(method: &I) {
    let trees = trees();
    let weights = method.step(|_, x| rate(&trees, x), 0.0, &SVector::zeros(), 1.0);
    have_order(&weights, 1.0, I::ORDER);
}

#[test]
fn methods_of_equal_steps_satisfy_the_conditions_of_their_order_and_no_more() {
    fixed(&Euler);
    fixed(&Heun);
    fixed(&Rk4);
    fixed(&DormandPrince);
}

/// A step of length 1 from 0, and the solution within.
fn attempt<M: Embedded<f64, TREES>>(
    method: &M,
) -> (Point<f64, TREES>, Attempt<f64, TREES, M::Stages>) {
    let trees = trees();
    let f = |_: f64, x: &Weights| rate(&trees, x);
    let x = SVector::zeros();
    let from = Point { t: 0.0, x, rate: rate(&trees, &x) };
    let weights = SVector::repeat(1.0);
    let linearization = method.linearize(f, &from, 1.0, &weights);
    let attempt = method.attempt(f, &from, &linearization, 1.0).unwrap();
    (from, attempt)
}

fn embedded<M: Embedded<f64, TREES>>(method: &M) {
    let (_, attempt) = attempt(method);
    have_order(&attempt.x, 1.0, M::ORDER);
    have_order(&(attempt.x - attempt.error), 1.0, M::ESTIMATE);
}

/// x(θ) as the trait defines it.
fn within<M: Embedded<f64, TREES>>(method: &M, theta: f64) -> Weights {
    let (from, attempt) = attempt(method);
    let [d1, d2, d3, d4] = method.dense(&from, &attempt, 1.0);
    from.x + theta * (d1 + (1.0 - theta) * (d2 + theta * (d3 + (1.0 - theta) * d4)))
}

/// The dense output of order q: the conditions of the solution at θ.
fn dense<M: Embedded<f64, TREES>>(method: &M, order: i32) {
    for theta in [0.1, 0.25, 0.5, 0.7, 0.9] {
        for (defect, nodes) in defects(&within(method, theta), theta).into_iter().zip(1..) {
            if nodes <= order {
                assert!(defect < 200.0 * f64::EPSILON, "θ = {theta}, {nodes} nodes: {defect:e}");
            }
        }
    }
    // The middle is no lucky place of these polynomials.
    have_order(&within(method, 0.5), 0.5, order);
    approx::assert_abs_diff_eq!(within(method, 0.0), SVector::zeros());
    let end = attempt(method).1.x;
    approx::assert_abs_diff_eq!(within(method, 1.0), end);
}

fn rodas() -> impl Embedded<f64, TREES> {
    let trees = trees();
    Rodas::with_jacobian(move |_: f64, x: &Weights| linearization(&trees, x))
}

#[test]
fn pairs_satisfy_the_conditions_of_both_their_orders() {
    embedded(&DormandPrince);
    embedded(&rodas());
}

#[test]
fn the_dense_output_satisfies_the_conditions_of_its_order() {
    dense(&DormandPrince, 4);
    dense(&rodas(), 3);
}

/// The slopes of the polynomial at its ends are those of the solution: x′(0) = h·f(t, x), x′(1) = h·f(t + h, x⁺), so the dense output of
/// many steps has no kinks.
#[test]
fn the_dense_output_of_dormand_and_prince_is_smooth_across_steps() {
    let (from, attempt) = attempt(&DormandPrince);
    let [d1, d2, d3, _] = DormandPrince.dense(&from, &attempt, 1.0);
    approx::assert_abs_diff_eq!(d1 + d2, from.rate, epsilon = 1e-14);
    approx::assert_abs_diff_eq!(d1 - (d2 + d3), attempt.rate.unwrap(), epsilon = 1e-14);
}
