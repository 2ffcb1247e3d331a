use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::FuzzyNetwork,
    learning::{
        Antecedents, BackwardDifference, ClosedLoop, Compensation, Compensator, Fixed, Flow,
        GradientDescent, Measured, NeuroFuzzy, NullRule, SlidingMode,
    },
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{Learner, NOT_FINITE, cases, quiet, real, rng, ulps};

in_both_precisions! {
    it_is_its_parts_called_in_order,
    it_learns_a_constant_uncertainty_in_finite_time,
    without_uncertainty_it_learns_nothing,
    with_the_null_rule_it_is_the_network,
    an_advance_leaves_the_compensator_itself_alone,
    a_sample_that_is_not_finite_is_refused,
    an_output_beyond_the_range_of_the_scalar_is_refused,
}

type Learning<T, A> = NeuroFuzzy<FuzzyNetwork<T, 2, 3>, Measured, SlidingMode<T, A>>;

fn network<T: Scalar>() -> FuzzyNetwork<T, 2, 3> {
    FuzzyNetwork::evenly_spaced([real(1.0), real(2.0)]).unwrap()
}

fn learning<T: Scalar, A: Antecedents<FuzzyNetwork<T, 2, 3>>>(antecedents: A) -> Learning<T, A> {
    let rule = SlidingMode::new(real(4.0)).unwrap().with_antecedents(antecedents);
    NeuroFuzzy::new(network(), Measured, rule)
}

/// A sample at the error `e` of a plant ẋ_n = Δ with a = u = 0, u_b being some feedback.
fn sample<T: Scalar>(e: [f64; 2], delta: f64) -> ClosedLoop<T, 2> {
    let e = SVector::from(e.map(real));
    ClosedLoop { e, u_b: real(3.0), rate: Some(real(delta)), ..quiet() }
}

/// follow, fire, s, adapt, and the output with the firing strengths found before.
fn it_is_its_parts_called_in_order<T: Scalar>() {
    is_its_parts::<T, _>(Fixed);
    is_its_parts::<T, _>(Flow::default());
}

fn is_its_parts<T: Scalar, A: Antecedents<FuzzyNetwork<T, 2, 3>> + Copy>(antecedents: A) {
    let mut whole = learning::<T, A>(antecedents);
    let rule = SlidingMode::new(real(4.0)).unwrap().with_antecedents(antecedents);
    let (mut parts, mut rng) = (Learner { network: network::<T>(), rule }, rng());
    for _ in 0..200 {
        let e = [rng.random_range(-3.0..3.0), rng.random_range(-3.0..3.0)];
        let (next, Compensation { u_n, s }) =
            whole.advanced(&sample(e, rng.random_range(-3.0..3.0)), real(0.25)).unwrap();
        assert_eq!(parts.step(SVector::from(e.map(real)), s, real(0.25)), u_n);
        assert_eq!(next.network(), &parts.network);
        whole = next;
    }
}

/// u_n + Δ loses αh = 1 a period until less than that is left, which the set-valued sign takes off at once: after ⌈|Δ|⌉ periods
/// u_n = −Δ, and s follows one period behind.
fn it_learns_a_constant_uncertainty_in_finite_time<T: Scalar>() {
    proptest!(cases(100), |(delta in -20.0..20.0_f64, e1 in -9.0..9.0_f64, e2 in -9.0..9.0_f64)| {
        let mut learner = learning(Flow::<T>::default());
        let mut left = real::<T>(delta);
        for k in 0..25 {
            // The input moves all the time, which flowing antecedents do not mind.
            let (next, Compensation { u_n, s }) = learner.advanced(&sample([e1 * f64::from(k), e2], delta), real(0.25)).unwrap();
            // |u_n + Δ| ≤ 20, u_b = 3 and Σ|w̃·f| round with an ulp each in at most 25 periods.
            assert_abs_diff_eq!(s, -left, epsilon = ulps(2000.0));
            left -= left.abs().min(T::one()).copysign(left);
            assert_abs_diff_eq!(u_n + real(delta), left, epsilon = ulps(2000.0));
            learner = next;
        }
        prop_assert_eq!(left, T::zero());
    });
}

fn without_uncertainty_it_learns_nothing<T: Scalar>() {
    let mut learner = learning(Flow::<T>::default());
    for k in 0..100 {
        let (next, compensation) =
            learner.advanced(&sample([0.1 * f64::from(k), -0.2], 0.0), real(0.25)).unwrap();
        assert_eq!(compensation, Compensation { u_n: T::zero(), s: T::zero() });
        learner = next;
    }
}

fn with_the_null_rule_it_is_the_network<T: Scalar>() {
    let mut network = network::<T>();
    network.set_consequents(&[1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0].map(real)).unwrap();
    let mut watch = NeuroFuzzy::new(network, Measured, NullRule);
    proptest!(cases(100), |(e1 in -9.0..9.0_f64, e2 in -9.0..9.0_f64, delta in -9.0..9.0_f64)| {
        let at = sample([e1, e2], delta);
        let (next, compensation) = watch.advanced(&at, T::one()).unwrap();
        prop_assert_eq!(Ok(compensation.u_n), network.evaluate(&at.e));
        prop_assert_eq!(next, watch);
    });
    // The network may be changed from outside.
    watch.network_mut().set_consequents(&[T::one(); 9]).unwrap();
    let (_, compensation) = watch.advanced(&sample([0.3, 0.1], 0.0), T::one()).unwrap();
    assert_abs_diff_eq!(compensation.u_n, T::one(), epsilon = ulps(16.0));
}

fn an_advance_leaves_the_compensator_itself_alone<T: Scalar>() {
    let fresh = NeuroFuzzy::new(
        network::<T>(),
        BackwardDifference::new(),
        SlidingMode::new(T::one()).unwrap(),
    );
    let (before, at) = (fresh, sample([0.3, -0.4], 1.0));
    let (next, first) = fresh.advanced(&at, T::one()).unwrap();
    assert_eq!(fresh, before);
    assert_ne!(next, fresh);
    assert_eq!(fresh.advanced(&at, T::one()), Ok((next, first)));
}

/// The quantity that a sample was refused for, if it was.
fn refused<T: Scalar, C: Compensator<T, 2>>(
    compensator: &C,
    at: &ClosedLoop<T, 2>,
) -> Option<&'static str> {
    match compensator.advanced(at, real(0.25)) {
        Err(Error::NonFinite { name, .. } | Error::NonFiniteEntry { name, .. }) => Some(name),
        _ => None,
    }
}

fn a_sample_that_is_not_finite_is_refused<T: Scalar>() {
    let gradient =
        NeuroFuzzy::new(network::<T>(), Measured, GradientDescent::new(T::one()).unwrap());
    for bad in NOT_FINITE.map(real::<T>) {
        let good = sample::<T>([0.3, -0.4], 1.0);
        let of_s = [
            ClosedLoop { u_b: bad, ..good },
            ClosedLoop { drift: bad, ..good },
            ClosedLoop { gain: bad, u: T::one(), ..good },
            ClosedLoop { u: bad, ..good },
            ClosedLoop { rate: Some(bad), ..good },
        ];
        for at in of_s {
            assert_eq!(refused(&learning(Fixed), &at), Some("s"));
            assert_eq!(refused(&learning(Flow::default()), &at), Some("s"));
            assert_eq!(refused(&gradient, &at), Some("s"));
        }
        for i in 0..2 {
            let mut at = good;
            at.e[i] = bad;
            assert_eq!(refused(&learning(Flow::default()), &at), Some("e"));
        }
    }
    let blind = ClosedLoop { rate: None, ..sample::<T>([0.3, -0.4], 1.0) };
    let missing = learning(Flow::default()).advanced(&blind, T::one()).unwrap_err();
    assert_eq!(missing, Error::Missing { name: "measured rate of x_n" });
}

/// Two steps of the greatest number there is add up to more than that.
fn an_output_beyond_the_range_of_the_scalar_is_refused<T: Scalar>() {
    let greatest = T::max_value().unwrap();
    let network = FuzzyNetwork::<T, 2, 1>::evenly_spaced([T::one(); 2]).unwrap();
    let fresh =
        NeuroFuzzy::new(network, BackwardDifference::new(), SlidingMode::new(greatest).unwrap());
    let at = ClosedLoop { u_b: greatest, ..quiet() };
    let (once, compensation) = fresh.advanced(&at, T::one()).unwrap();
    assert_eq!(compensation.u_n, greatest);
    let (before, refused) = (once, once.advanced(&at, T::one()).unwrap_err());
    assert!(matches!(refused, Error::NonFinite { name: "u_n", .. }));
    assert_eq!(once, before);
}

/// With fixed antecedents an infinite error is as far from every centre as from the next: the rules would fire
/// alike, and learning would go on as if nothing were wrong.
#[test]
fn an_error_that_is_not_finite_is_refused_with_fixed_antecedents() {
    for bad in NOT_FINITE {
        for e in [[bad, 0.0], [0.0, bad]] {
            let at = sample::<f64>(e, 1.0);
            assert_eq!(refused(&learning(Fixed), &at), Some("e"), "{e:?}");
        }
    }
}

/// A network that has not travelled yet does not make up for it: its centres stay where they are at its first sample, however far
/// the input is.
#[test]
fn a_network_put_in_place_of_the_old_one_stays_where_it_was_put() {
    let at = ClosedLoop { rate: Some(-3.0), ..sample::<f64>([5.0, 5.0], 0.0) };
    let (mut learner, _) = learning(Flow::default()).advanced(&at, 0.25).unwrap();
    let put = network::<f64>();
    *learner.network_mut() = put;
    assert_eq!(learner.network().memberships(), put.memberships());
    let still = ClosedLoop { rate: Some(0.0), ..at };
    let (learner, _) = learner.advanced(&still, 0.25).unwrap();
    assert_eq!(learner.network().memberships(), put.memberships());
}
