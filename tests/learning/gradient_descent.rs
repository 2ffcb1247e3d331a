use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::FuzzyNetwork,
    learning::{AdaptationRule, GradientDescent},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, cases, real, rng, ulps};

in_both_precisions! {
    a_constant_s_moves_the_output_in_a_straight_line,
    what_is_left_to_learn_decays_geometrically,
    a_rate_that_is_not_positive_and_finite_is_refused,
    leakage_rests_where_it_balances_learning,
    leakage_is_stable_at_any_period,
    projection_is_the_nearest_point_within_the_bound,
    within_the_bound_the_output_is_bounded_everywhere,
    a_leakage_or_a_bound_out_of_range_is_refused,
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

/// σ·f_r = η·s·w̃_r with s = −(u_n + Δ): s = −Δ/(1 + g), g = η·w̃ᵀw̃/σ.
fn leakage_rests_where_it_balances_learning<T: Scalar>() {
    proptest!(cases(100), |(rate in 0.5..5.0_f64, leakage in 0.1..5.0_f64, delta in -5.0..5.0_f64, e1 in -2.0..2.0_f64, e2 in -2.0..2.0_f64)| {
        let (rate, leakage, delta) = (real::<T>(rate), real::<T>(leakage), real::<T>(delta));
        let mut network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
        let mut rule = GradientDescent::new(rate).unwrap().with_leakage(leakage).unwrap();
        let firing = network.fire(&SVector::from([e1, e2].map(real)));
        for _ in 0..4000 {
            let s = -(network.output(&firing) + delta);
            rule.adapt(&mut network, &firing, s, real(0.125));
        }
        let rest = -delta / (T::one() + rate * firing.norm_squared() / leakage);
        // Every step rounds; what is left of an error falls by 1/(1 + σh) ≤ 1/1.0125 a step, so up to 80 of them add up.
        let rounding = ulps::<T>(16.0 * 80.0) * delta.abs();
        assert_abs_diff_eq!(-(network.output(&firing) + delta), rest, epsilon = rounding);
        for (f, w) in network.consequents().iter().zip(firing.strengths().iter()) {
            let wanted = rate * rest * *w / leakage;
            assert_abs_diff_eq!(*f, wanted, epsilon = rounding * rate / leakage);
        }
    });
}

/// A forward Euler step would multiply every f_r by 1 − σh = −99 999.
fn leakage_is_stable_at_any_period<T: Scalar>() {
    let mut network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
    network.set_consequents(&[1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0].map(real)).unwrap();
    let mut rule = GradientDescent::new(T::one()).unwrap().with_leakage(real(1e3)).unwrap();
    let firing = network.fire(&SVector::from([0.3, -0.2].map(real)));
    let before = network.consequents();
    rule.adapt(&mut network, &firing, T::zero(), real(100.0));
    for (f, before) in network.consequents().iter().zip(before.iter()) {
        assert_abs_diff_eq!(*f, *before / real(100_001.0), epsilon = ulps::<T>(4.0) * before.abs());
    }
}

/// The box |f_r| ≤ F is a product of intervals, so its nearest point is the nearest in each of them.
fn projection_is_the_nearest_point_within_the_bound<T: Scalar>() {
    proptest!(cases(200), |(start in prop::array::uniform9(-2.0..2.0_f64), s in -50.0..50.0_f64, leakage in 0.0..2.0_f64, e1 in -2.0..2.0_f64)| {
        let mut free = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
        free.set_consequents(&start.map(real)).unwrap();
        let mut projected = free;
        let firing = free.fire(&SVector::from([e1, 0.4].map(real)));
        let mut rule = GradientDescent::new(T::one()).unwrap().with_leakage(real(leakage)).unwrap();
        rule.adapt(&mut free, &firing, real(s), real(0.125));
        let bound = T::one();
        let mut bounded = rule.with_projection(bound).unwrap();
        bounded.adapt(&mut projected, &firing, real(s), real(0.125));
        for (own, f) in projected.consequents().iter().zip(free.consequents().iter()) {
            let nearest = if *f > bound { bound } else if *f < -bound { -bound } else { *f };
            prop_assert_eq!(*own, nearest);
        }
    });
}

/// u_n is a mean of the consequents; an s beyond every bound moves it no farther.
fn within_the_bound_the_output_is_bounded_everywhere<T: Scalar>() {
    let (mut network, mut rng) =
        (FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap(), rng());
    let mut rule = GradientDescent::new(T::one()).unwrap().with_projection(real(2.0)).unwrap();
    for _ in 0..2000 {
        let mut input = || SVector::from([0, 1].map(|_| real::<T>(rng.random_range(-3.0..3.0))));
        let (here, elsewhere) = (input(), input());
        let firing = network.fire(&here);
        let size = 10.0_f64.powi(rng.random_range(-3..30));
        let s = if rng.random() { size } else { -size };
        rule.adapt(&mut network, &firing, real(s), real(0.125));
        for e in [here, elsewhere, SVector::from([real(100.0), -T::one()])] {
            assert!(network.evaluate(&e).unwrap().abs() <= real::<T>(2.0) + ulps(16.0));
        }
    }
}

fn a_leakage_or_a_bound_out_of_range_is_refused<T: Scalar>() {
    let rule = GradientDescent::new(T::one()).unwrap();
    assert!(rule.with_leakage(T::zero()).is_ok());
    assert_eq!(
        rule.with_leakage(-T::one()).unwrap_err(),
        Error::Negative { name: "leakage", value: -1.0 }
    );
    for bad in [0.0, -1.0] {
        assert_eq!(
            rule.with_projection(real(bad)).unwrap_err(),
            Error::NotPositive { name: "bound of the consequents", value: bad }
        );
    }
    for bad in NOT_FINITE.map(real) {
        let refused = [rule.with_leakage(bad).unwrap_err(), rule.with_projection(bad).unwrap_err()];
        assert!(refused.iter().all(|error| matches!(error, Error::NonFinite { .. })));
    }
}
