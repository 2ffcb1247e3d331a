use brunovsky::{
    Scalar,
    differentiator::{BackwardDifference, Differentiator},
};
use proptest::prelude::*;

use crate::support::{cases, error_on_a_sine, rates, real};

in_both_precisions! {
    the_first_rate_is_zero_and_a_ramp_is_exact,
    the_period_may_vary,
}

/// Eighths below 2¹⁰: differences and quotients have no rounding errors.
fn the_first_rate_is_zero_and_a_ramp_is_exact<T: Scalar>() {
    proptest!(cases(200), |(slope in -50..50_i32, start in -50..50_i32)| {
        let (slope, start) = (f64::from(slope), f64::from(start));
        let rates = rates::<T>(BackwardDifference::new(), 0.125, 20, |t| start + slope * t);
        prop_assert_eq!(rates[0], T::zero());
        prop_assert!(rates[1..].iter().all(|rate| *rate == real(slope)));
    });
}

fn the_period_may_vary<T: Scalar>() {
    let mut source = BackwardDifference::new();
    let (mut t, slope) = (0.0, -3.0);
    for (k, dt) in [0.125, 0.5, 0.25, 2.0, 0.0625].into_iter().enumerate() {
        t += dt;
        let rate = source.update(real::<T>(slope * t), real(dt)).unwrap();
        assert_eq!(rate, real(if k == 0 { 0.0 } else { slope }));
    }
}

/// (e(t) − e(t − h))/h = ė(t) − ½·h·ë + O(h²): first order at t, second order half a period before. The leading terms,
/// ½·h·max|ë| = h/2 and h²/24·max|e⃛|, say how large, too.
#[test]
fn the_difference_is_of_first_order_and_half_a_period_late() {
    let at_sample = |h| error_on_a_sine(BackwardDifference::new(), h, f64::cos);
    let before = |h: f64| error_on_a_sine(BackwardDifference::new(), h, |t| (t - 0.5 * h).cos());
    for h in [0.02, 0.01, 0.005] {
        assert!((0.99..1.01).contains(&(at_sample(h) / at_sample(h / 2.0)).log2()));
        assert!((1.98..2.02).contains(&(before(h) / before(h / 2.0)).log2()));
        assert!((0.99..1.01).contains(&(at_sample(h) / (0.5 * h))));
        assert!((0.98..1.02).contains(&(before(h) / (h * h / 24.0))));
    }
}
