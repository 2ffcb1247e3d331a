//! What the curve minimizes: ∫r⃛·b⃛ dt = 0 for every bump b that it may not be moved by.

use brunovsky::trajectory::{MinimumJerk, Trajectory};
use proptest::prelude::*;

use super::{Curve, TIMES, any, curve, derivative, evaluate};
use crate::support::{WINDING, cases, integral};

proptest! {
    #![proptest_config(cases(200))]

    /// ∫r⃛·b⃛ dt = 0 for every bump b that is zero at the points and has no velocity and acceleration at the ends: then ∫|r⃛ + b⃛|² dt is
    /// ∫|r⃛|² dt + ∫|b⃛|² dt.
    #[test]
    fn no_admissible_bump_changes_the_jerk_to_first_order(case in any(), more in -3.0..3.0_f64) {
        let times = case.1;
        let ends = [times[0], times[0], times[5], times[5]];
        let cosine = cosine_of_jerks(&curve(&case), &times, &[times.as_slice(), &ends, &[more]].concat());
        prop_assert!(cosine.abs() < 1e-6, "{cosine}");
    }
}

/// The counterpart: what moves a point does change the integral.
#[test]
fn a_bump_that_moves_a_point_changes_the_jerk_to_first_order() {
    let r = MinimumJerk::new(WINDING, TIMES).unwrap();
    let ends = [TIMES[0], TIMES[0], TIMES[5], TIMES[5]];
    for moved in &TIMES[1..5] {
        let roots = TIMES.into_iter().filter(|t| t != moved).chain(ends);
        let cosine = cosine_of_jerks(&r, &TIMES, &roots.collect::<Vec<_>>());
        assert!(cosine.abs() > 1e-3, "{cosine}");
    }
}

/// ∫x⃛·b⃛ dt/√(∫x⃛² dt·∫b⃛² dt) for b = Π(t − root), up to a quadrature of order 6.
fn cosine_of_jerks(r: &Curve, times: &[f64; 6], roots: &[f64]) -> f64 {
    let b = derivative(&derivative(&derivative(&polynomial(roots))));
    let over_all = |f: &dyn Fn(f64, f64) -> f64| {
        let jerks = |t: f64| f(r.jet::<4>(t)[3][0], evaluate(&b, t));
        times.windows(2).map(|pair| integral(jerks, pair[0], pair[1], 60)).sum::<f64>()
    };
    over_all(&|x, b| x * b) / (over_all(&|x, _| x * x) * over_all(&|_, b| b * b)).sqrt()
}

/// The coefficients of Π(t − root), from t⁰ on.
fn polynomial(roots: &[f64]) -> Vec<f64> {
    roots.iter().fold(vec![1.0], |c, root| {
        let shifted = std::iter::once(&0.0).chain(&c);
        shifted.zip(c.iter().chain([&0.0])).map(|(below, here)| below - root * here).collect()
    })
}
