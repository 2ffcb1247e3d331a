use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::FuzzyNetwork,
    learning::{
        AdaptationRule, Bounded, ClosedLoop, Compensation, Compensator, Fixed, GradientDescent,
        LearningMode, Measured, NeuroFuzzy, SlidingMode,
    },
    nalgebra::SVector,
};

use crate::support::{NOT_FINITE, quiet, real, ulps};

in_both_precisions! {
    the_output_is_the_integral_cut_at_the_bound,
    a_step_is_cut_at_the_rate,
    an_outlier_of_any_size_moves_the_output_by_the_rate_alone,
    an_outlier_beyond_the_range_of_the_scalar_is_not_learned_from,
    the_bound_holds_at_every_input_and_in_every_mode,
    a_limit_out_of_range_is_refused,
    an_outlier_moves_the_output_to_the_bound_and_spoils_nothing,
}

/// The output of `rule` after each of the sliding variables `s`, at a fixed input, with periods of 1/4 s.
fn outputs<T: Scalar>(mut rule: impl AdaptationRule<FuzzyNetwork<T, 2, 3>>, s: &[f64]) -> Vec<T> {
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

fn a_limit_out_of_range_is_refused<T: Scalar>() {
    let attempt =
        |bad| Bounded::new(SlidingMode::new(T::one()).unwrap(), real::<T>(bad)).unwrap_err();
    for bad in [0.0, -1.0] {
        assert_eq!(attempt(bad), Error::NotPositive { name: "bound", value: bad });
    }
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "bound", .. }));
    }
    let bounded = Bounded::new(SlidingMode::new(T::one()).unwrap(), T::one()).unwrap();
    let attempt = |bad| bounded.with_rate(real::<T>(bad)).unwrap_err();
    for bad in [0.0, -1.0] {
        assert_eq!(attempt(bad), Error::NotPositive { name: "rate of u_n", value: bad });
    }
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "rate of u_n", .. }));
    }
}

/// u_n ← clamp(u_n + clamp(αςh, −R·h, R·h), −U, U), with R·h = 0.125 < αh = 0.25.
fn a_step_is_cut_at_the_rate<T: Scalar>() {
    let rule = SlidingMode::new(T::one()).unwrap();
    let s = [9.0, 9.0, 0.0625, 9.0, 9.0, 9.0, 9.0, -0.0625, -9.0, -9.0, -9.0, -9.0];
    let bounded = Bounded::new(rule, real(0.6)).unwrap();
    let mut wanted = 0.0_f64;
    for (s, u_n) in s.iter().zip(outputs(bounded.with_rate(real(0.5)).unwrap(), &s)) {
        wanted = (wanted + s.clamp(-0.125, 0.125)).clamp(-0.6, 0.6);
        assert_abs_diff_eq!(u_n, real(wanted), epsilon = ulps(16.0));
    }
    // A rate that is never reached changes nothing.
    let wide = Bounded::new(rule, real(10.0)).unwrap().with_rate(real(1.5)).unwrap();
    assert_eq!(outputs(wide, &s), outputs(rule, &s));
}

/// What was learned before survives to rounding, which it would not if 10²⁰ were added and taken back.
fn an_outlier_of_any_size_moves_the_output_by_the_rate_alone<T: Scalar>() {
    let bounded = Bounded::new(GradientDescent::new(T::one()).unwrap(), real(10.0)).unwrap();
    let rule = bounded.with_rate(real(0.5)).unwrap();
    for outlier in [1e3, 1e20, -1e20, 1e30] {
        let learned = outputs(rule, &[1.0, 1.0, 1.0, outlier, 0.0]);
        let reach = real::<T>(0.125).copysign(real(outlier));
        assert_abs_diff_eq!(learned[3], learned[2] + reach, epsilon = ulps(8.0));
        assert_eq!(learned[4], learned[3]);
    }
}

fn an_outlier_beyond_the_range_of_the_scalar_is_not_learned_from<T: Scalar>() {
    let most = T::max_value().unwrap();
    let bounded = Bounded::new(GradientDescent::new(real(100.0)).unwrap(), real(10.0)).unwrap();
    let network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
    let learner = NeuroFuzzy::new(network, Measured, bounded.with_rate(T::one()).unwrap());
    let at = |rate: T| ClosedLoop { rate: Some(rate), ..quiet() };
    let (learner, _) = learner.advanced(&at(real(0.25)), T::one()).unwrap();
    let (after, Compensation { u_n, .. }) = learner.advanced(&at(most), T::one()).unwrap();
    assert_eq!(after, learner);
    assert_eq!(u_n, learner.network().evaluate(&SVector::zeros()).unwrap());
}

/// Learning at one input moves the output at others too, where nothing clamps it; at a frozen one nothing ever would. U holds to the last bit.
fn the_bound_holds_at_every_input_and_in_every_mode<T: Scalar>() {
    let rule = SlidingMode::new(real(4.0)).unwrap().with_antecedents(Fixed);
    let network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
    let bounded = Bounded::new(rule, real(0.3)).unwrap();
    let mut learner = NeuroFuzzy::new(network, Measured, bounded);
    let at = |e: [f64; 2], learning| ClosedLoop {
        e: SVector::from(e.map(real)),
        rate: Some(real(-9.0)),
        learning,
        ..quiet()
    };
    // Between the centres: the consequents around grow beyond what is their mean there.
    for _ in 0..20 {
        learner = learner.advanced(&at([0.5, 0.5], LearningMode::Active), real(0.25)).unwrap().0;
    }
    let corner = SVector::from([real::<T>(0.9), real(0.9)]);
    assert!(learner.network().evaluate(&corner).unwrap() > real(0.31));
    for learning in [LearningMode::Frozen, LearningMode::Active] {
        let (next, Compensation { u_n, s }) =
            learner.advanced(&at([0.9, 0.9], learning), real(0.25)).unwrap();
        assert_eq!(s, real::<T>(9.0) - real(0.3));
        assert!(u_n <= real(0.3) && u_n > real(0.2999));
        assert_eq!(next == learner, learning == LearningMode::Frozen);
    }
}
