use brunovsky::{
    Scalar,
    fuzzy::FuzzyNetwork,
    learning::{AdaptationRule, GradientDescent, NullRule},
    nalgebra::SVector,
};

use crate::support::real;

in_both_precisions! {
    the_null_rule_changes_nothing,
    a_rule_follows_the_input_with_nothing_unless_it_says_so,
}

fn network<T: Scalar>() -> FuzzyNetwork<T, 2, 3> {
    let mut network = FuzzyNetwork::evenly_spaced([real(1.0), real(2.0)]).unwrap();
    network.set_consequents(&[1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0].map(real)).unwrap();
    network
}

/// One sample of `rule`.
fn sampled<T: Scalar>(
    rule: &mut impl AdaptationRule<FuzzyNetwork<T, 2, 3>>,
    s: f64,
    learn: bool,
) -> FuzzyNetwork<T, 2, 3> {
    let (mut network, e) = (network(), SVector::from([0.3, -0.2].map(real)));
    rule.follow(&mut network, &e);
    let firing = network.fire(&e);
    if learn {
        rule.adapt(&mut network, &firing, real(s), real(0.1));
    }
    network
}

fn the_null_rule_changes_nothing<T: Scalar>() {
    for s in [0.0, 1.0, -1e30] {
        let mut rule = NullRule;
        assert_eq!(sampled::<T>(&mut rule, s, true), network());
        assert_eq!(rule, NullRule);
    }
}

fn a_rule_follows_the_input_with_nothing_unless_it_says_so<T: Scalar>() {
    let mut rule = GradientDescent::new(T::one()).unwrap();
    assert_eq!(sampled(&mut rule, 1.0, false), network());
    assert_eq!(rule, GradientDescent::new(T::one()).unwrap());
    assert_ne!(sampled(&mut rule, 1.0, true), network());
}
