//! Every rule on every network that it can train.

use approx::assert_abs_diff_eq;
use brunovsky::{
    Scalar,
    fuzzy::{
        FuzzyNetwork, IntervalNetwork, Over, Rules, Strengths, TriangularNetwork, TypeReduction,
    },
    learning::{
        AdaptationRule, AdaptiveSlidingMode, Bounded, ClosedLoop, Compensator, Fixed,
        GradientDescent, Measured, NeuroFuzzy, NullRule, RecursiveLeastSquares, SlidingMode,
        Switching,
    },
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{any_magnitude, cases, quiet, real, rng, ulps};

in_both_precisions! {
    under_the_sliding_mode_the_output_follows_the_integral_of_the_sign,
    what_is_learned_at_rest_ends_where_nothing_is_left,
    numbers_of_any_size_are_answered_with_finite_ones_or_refused_without_a_trace,
}

/// Evaluates `$law!(network)` for one network of each kind.
macro_rules! on_every_network {
    ($T:ident, $law:ident) => {
        let ranges = [real::<$T>(1.0), real(2.0)];
        let (nie_tan, bmm) = (TypeReduction::NieTan, TypeReduction::Bmm { m: real(0.3) });
        let exponents = [0.6, 2.0].map(real);
        $law!(FuzzyNetwork::<$T, 2, 3>::evenly_spaced(ranges).unwrap());
        $law!(TriangularNetwork::<$T, 2, 3>::evenly_spaced(ranges).unwrap());
        $law!(IntervalNetwork::<_, $T, 2, 3>::gaussian(ranges, real(0.3), nie_tan).unwrap());
        $law!(IntervalNetwork::<_, $T, 2, 3>::gaussian(ranges, real(0.3), bmm).unwrap());
        $law!(IntervalNetwork::<_, $T, 2, 3>::elliptic(ranges, exponents, nie_tan).unwrap());
        $law!(IntervalNetwork::<_, $T, 2, 3>::elliptic(ranges, exponents, bmm).unwrap());
    };
}

/// u_n(k) − u_n at the same input before = α·ς·h, wherever the input is, in and out of every support.
fn follows_the_sign<W, T: Scalar>(mut network: W)
where
    W: Over<T, 2>,
    SlidingMode<T, Fixed>: AdaptationRule<W>,
{
    let mut rng = rng();
    network.change_consequents(|f| {
        for (r, f) in f.iter_mut().enumerate() {
            *f = real(r as f64 - 4.0);
        }
    });
    for switching in [
        Switching::SetValued,
        Switching::Explicit { delta: real(0.05) },
        Switching::Implicit { delta: real(0.05) },
    ] {
        let rule = SlidingMode::new(real::<T>(5.0)).unwrap().with_antecedents(Fixed);
        let mut rule = rule.with_switching(switching).unwrap();
        for _ in 0..500 {
            let e = [0, 1].map(|_| real::<T>(rng.random_range(-4.0..4.0)));
            let firing = network.fire(&e.into());
            let (s, before) = (real::<T>(rng.random_range(-0.3..0.3)), network.output(&firing));
            rule.adapt(&mut network, &firing, s, real(0.01));
            let reach = real::<T>(5.0) * real(0.01);
            let step = reach * switching.sign(s, reach);
            // The consequents stay below 32; nine products and their sum.
            assert_abs_diff_eq!(
                network.output(&firing) - before,
                step,
                epsilon = ulps(32.0 * 32.0)
            );
        }
    }
}

fn under_the_sliding_mode_the_output_follows_the_integral_of_the_sign<T: Scalar>() {
    macro_rules! law {
        ($network:expr) => {
            follows_the_sign::<_, T>($network)
        };
    }
    on_every_network!(T, law);
}

/// Δ = 0.7 at one input: 400 periods of 0.1 s bring u_n to −Δ, by all rules that leave nothing.
fn learns_at_rest<W: Over<T, 2>, T: Scalar, R: AdaptationRule<W>>(mut network: W, mut rule: R) {
    let e = SVector::from([0.3, -0.9].map(real));
    for _ in 0..400 {
        rule.follow(&mut network, &e);
        let firing = network.fire(&e);
        let s = -(rule.output(&network, &firing) + real(0.7));
        rule.adapt(&mut network, &firing, s, real(0.1));
    }
    // Least squares without a memory leave 1/(1 + p·k·w̃ᵀw̃) of it, p = 100 and w̃ᵀw̃ ≥ 1/9.
    let left = real(0.7 / (1.0 + 100.0 * 400.0 / 9.0));
    assert_abs_diff_eq!(network.evaluate(&e).unwrap(), real(-0.7), epsilon = left);
}

/// Evaluates `$law!(rule)` for one rule of each kind that is made for every network.
macro_rules! with_every_rule {
    ($T:ident, $law:ident) => {
        let sliding = SlidingMode::new(real::<$T>(2.0)).unwrap().with_antecedents(Fixed);
        let gradient = GradientDescent::new(real::<$T>(5.0)).unwrap();
        let least_squares = RecursiveLeastSquares::new(real::<$T>(100.0)).unwrap();
        $law!(sliding);
        $law!(AdaptiveSlidingMode::new(sliding, real(1.0), real(0.1)).unwrap());
        $law!(gradient);
        $law!(gradient.with_projection(real(3.0)).unwrap());
        $law!(least_squares);
        $law!(least_squares.with_memory(real(1.0)).unwrap());
        $law!(Bounded::new(sliding, real(5.0)).unwrap());
        $law!(Bounded::new(gradient, real(5.0)).unwrap().with_rate(real(3.0)).unwrap());
        $law!(Bounded::new(least_squares, real(5.0)).unwrap());
    };
}

fn what_is_learned_at_rest_ends_where_nothing_is_left<T: Scalar>() {
    macro_rules! on {
        ($network:expr) => {{
            let network = $network;
            macro_rules! with {
                ($rule:expr) => {
                    learns_at_rest::<_, T, _>(network, $rule)
                };
            }
            with_every_rule!(T, with);
        }};
    }
    on_every_network!(T, on);
}

fn bears_any_number<W, T, R>(network: W, rule: R)
where
    T: Scalar,
    W: Over<T, 2> + PartialEq + core::fmt::Debug,
    W::Firing: Strengths<T, Rules = Rules<T, 2, 3>>,
    R: AdaptationRule<W> + Clone + PartialEq + core::fmt::Debug,
{
    let calls = prop::collection::vec(
        (
            prop::array::uniform2(any_magnitude::<T>()),
            any_magnitude::<T>(),
            any_magnitude::<T>(),
            prop::bool::ANY,
        ),
        1..12,
    );
    proptest!(cases(24), |(calls in calls)| {
        let mut learner = NeuroFuzzy::new(network.clone(), Measured, rule.clone());
        for (e, rate, dt, moderate) in calls {
            let e = SVector::from(if moderate { e.map(|e| e.tanh()) } else { e });
            let rate = if moderate { rate.tanh() } else { rate };
            let dt = if moderate { real(0.01) } else { dt.abs() };
            let before = learner.clone();
            match learner.advance_if(&ClosedLoop { e, rate: Some(rate), ..quiet() }, dt, &mut |_| Ok(())) {
                Ok(compensation) => {
                    prop_assert!(compensation.u_n.is_finite() && compensation.s.is_finite());
                    let strengths = learner.network().fire(&e).strengths();
                    let sum = strengths.iter().fold(T::zero(), |sum, w| sum + *w);
                    prop_assert!((sum - T::one()).abs() <= ulps(64.0));
                }
                Err(_) => prop_assert_eq!(&learner, &before),
            }
        }
        let state = format!("{learner:?}");
        prop_assert!(!state.contains("NaN"), "{}", state);
    });
}

fn numbers_of_any_size_are_answered_with_finite_ones_or_refused_without_a_trace<T: Scalar>() {
    macro_rules! on {
        ($network:expr) => {{
            let network = $network;
            macro_rules! with {
                ($rule:expr) => {
                    bears_any_number::<_, T, _>(network, $rule)
                };
            }
            with_every_rule!(T, with);
            with!(NullRule);
            with!(GradientDescent::new(real(5.0)).unwrap().with_leakage(real(1.0)).unwrap());
        }};
    }
    on_every_network!(T, on);
}
