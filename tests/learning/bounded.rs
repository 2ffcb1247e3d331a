use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::FuzzyNetwork,
    learning::{AdaptationRule, Bounded, GradientDescent, SlidingMode},
    nalgebra::{self, SVector},
};

use crate::support::{NOT_FINITE, real, ulps};

in_both_precisions! {
    the_output_is_the_integral_cut_at_the_bound,
    an_outlier_moves_the_output_to_the_bound_and_spoils_nothing,
    a_bound_out_of_range_is_refused,
}

/// The output of `rule` after each of the sliding variables `s`, at a fixed input, with periods of 1/4 s.
fn outputs<T: Scalar>(mut rule: impl AdaptationRule<T, 2, 3>, s: &[f64]) -> Vec<T> {
    let mut network = FuzzyNetwork::evenly_spaced([T::one(), real(2.0)]).unwrap();
    let e = SVector::from([0.3, -0.7].map(real));
    let mut sample = |s: &f64| {
        rule.follow(&mut network, &e);
        let firing = network.fire(&e);
        rule.adapt(&mut network, &firing, real(*s), real(0.25));
        network.output(&firing)
    };
    s.iter().map(&mut sample).collect()
}

/// u_n ← clamp(u_n + α·ς·h, −U, U): up to the bound, along it, and off it as soon as s turns.
fn the_output_is_the_integral_cut_at_the_bound<T: Scalar>() {
    let rule = SlidingMode::new(T::one()).unwrap();
    let s = [9.0, 9.0, 9.0, 9.0, -9.0, -9.0, -9.0, -9.0, -9.0, -9.0, 9.0, 0.125];
    let mut wanted = 0.0_f64;
    for (s, u_n) in s.iter().zip(outputs(Bounded::new(rule, real(0.6)).unwrap(), &s)) {
        wanted = (wanted + s.clamp(-0.25, 0.25)).clamp(-0.6, 0.6);
        assert_abs_diff_eq!(u_n, real(wanted), epsilon = ulps(16.0));
    }
    // A bound that is never reached changes nothing.
    assert_eq!(outputs(Bounded::new(rule, real(10.0)).unwrap(), &s), outputs(rule, &s));
}

/// u_n ← clamp(u_n + η·w̃ᵀw̃·s·h, −U, U) under gradient descent. A step of 10²⁰, had it been made and taken back by a difference, would leave
/// 10⁴ behind in f64.
fn an_outlier_moves_the_output_to_the_bound_and_spoils_nothing<T: Scalar>() {
    let (rate, bound) = (0.5, 0.6);
    let network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(), real(2.0)]).unwrap();
    let firing = network.fire(&SVector::from([0.3, -0.7].map(real)));
    let gain = rate * 0.25 * nalgebra::try_convert::<_, f64>(firing.norm_squared()).unwrap();
    let s = [1.0, 1e20, -2.0, -0.5, -1e30, -1e20, 3.0, 1.0];
    let rule = GradientDescent::new(real::<T>(rate)).unwrap();
    let mut wanted = 0.0_f64;
    for (s, u_n) in s.iter().zip(outputs(Bounded::new(rule, real(bound)).unwrap(), &s)) {
        wanted = (wanted + gain * s).clamp(-bound, bound);
        assert_abs_diff_eq!(u_n, real(wanted), epsilon = ulps(32.0));
    }
}

fn a_bound_out_of_range_is_refused<T: Scalar>() {
    let attempt =
        |bad| Bounded::new(SlidingMode::new(T::one()).unwrap(), real::<T>(bad)).unwrap_err();
    for bad in [0.0, -1.0] {
        assert_eq!(attempt(bad), Error::NotPositive { name: "bound", value: bad });
    }
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "bound", .. }));
    }
}
