use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::FuzzyNetwork,
    learning::{AdaptationRule, GradientDescent},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, cases, real, ulps};

in_both_precisions! {
    a_constant_s_moves_the_output_in_a_straight_line,
    what_is_left_to_learn_decays_geometrically,
    a_rate_that_is_not_positive_and_finite_is_refused,
}

/// u_n after `steps` periods of 1/8 s at the input `e`, with s as a function of u_n, and ρ = η·dt·w̃ᵀw̃.
fn learned<T: Scalar>(rate: T, e: [f64; 2], steps: u32, s: impl Fn(T) -> T) -> (T, T) {
    let mut network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
    let (memberships, mut rule) = (network.memberships(), GradientDescent::new(rate).unwrap());
    let firing = network.fire(&SVector::from(e.map(real)));
    for _ in 0..steps {
        let u_n = network.output(&firing);
        rule.adapt(&mut network, &firing, s(u_n), real(0.125));
    }
    assert_eq!(network.memberships(), memberships);
    (network.output(&firing), rate * real(0.125) * firing.norm_squared())
}

/// u_n(k) = ρ·k·s from u_n(0) = 0.
fn a_constant_s_moves_the_output_in_a_straight_line<T: Scalar>() {
    proptest!(cases(200), |(rate in 0.1..10.0_f64, s in -5.0..5.0_f64, e1 in -2.0..2.0_f64, e2 in -2.0..2.0_f64, steps in 0..100_u32)| {
        let s = real::<T>(s);
        let (u_n, rho) = learned(real(rate), [e1, e2], steps, |_| s);
        let travel = rho * s * real(steps.into());
        // Each of the k additions rounds by an ulp of what has been reached.
        assert_abs_diff_eq!(u_n, travel, epsilon = ulps::<T>((steps + 32).into()) * (travel.abs() + T::default_epsilon()));
    });
}

/// With s = −(u_n + Δ), u_n + Δ is multiplied by 1 − ρ every period, so (1 − ρ)ᵏ·Δ of it is left: it dies out for ρ < 2 and
/// grows for ρ > 2.
fn what_is_left_to_learn_decays_geometrically<T: Scalar>() {
    let delta = real::<T>(0.7);
    let left = |wanted: f64, steps: u32| {
        let e = [0.3, -0.2];
        let unit = learned::<T>(T::one(), e, 0, |_| T::zero()).1;
        let (u_n, rho) = learned(real::<T>(wanted) / unit, e, steps, |u_n| -(u_n + delta));
        (u_n + delta, (T::one() - rho).powi(steps as i32) * delta)
    };
    for wanted in [0.01, 0.5, 1.0, 1.5, 1.99] {
        let (left, closed_form) = left(wanted, 40);
        // ρ is off by a few ulps, and |1 − ρ| ≤ 1 does not amplify what a step adds.
        assert_abs_diff_eq!(left, closed_form, epsilon = ulps(800.0));
    }
    assert!(left(1.9, 400).0.abs() < real(1e-6));
    let (grown, closed_form) = left(2.1, 40);
    // 1.1⁴⁰ = 45 amplifies what the first steps add, and 40 steps amplify the error of ρ.
    assert_abs_diff_eq!(grown, closed_form, epsilon = ulps(45.0 * 800.0));
    assert!(grown.abs() > real(40.0 * 0.7));
}

fn a_rate_that_is_not_positive_and_finite_is_refused<T: Scalar>() {
    let attempt = |bad: f64| GradientDescent::<T>::new(real(bad)).unwrap_err();
    for bad in [0.0, -1.0] {
        assert_eq!(attempt(bad), Error::NotPositive { name: "learning rate", value: bad });
    }
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "learning rate", .. }));
    }
}
