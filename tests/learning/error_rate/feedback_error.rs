use brunovsky::{
    Scalar,
    fuzzy::FuzzyNetwork,
    learning::{ClosedLoop, Compensator, ErrorRate, FeedbackError, NeuroFuzzy, SlidingMode},
};
use proptest::prelude::*;

use crate::support::{any_magnitude, cases, quiet, real};

in_both_precisions! {
    s_is_the_feedback_to_the_last_bit,
}

/// −0 included: its bits differ from those of 0.
fn s_is_the_feedback_to_the_last_bit<T: Scalar>() {
    let network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
    let learner = NeuroFuzzy::new(network, FeedbackError, SlidingMode::new(T::one()).unwrap());
    proptest!(cases(200), |(u_b in any_magnitude::<T>(), rate in any_magnitude::<T>(), drift in any_magnitude::<T>())| {
        let at = ClosedLoop { u_b, drift, rate: Some(rate), ..quiet() };
        prop_assert_eq!(learner.advanced(&at, real(0.1)).unwrap().1.s, u_b);
    });
    let rate = FeedbackError.error_rate(&quiet::<T, 2>(), T::one(), T::one()).unwrap();
    assert!((-T::zero() + rate).is_sign_negative() && rate.is_zero());
}
