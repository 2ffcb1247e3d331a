//! Actuators: what arrives of a command, against the definition of each limit.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod rate_limit;
mod saturation;

use brunovsky::{
    Error, Scalar,
    actuator::{Actuator, Ideal, RateLimit, Saturation},
    nalgebra::{self, SVector},
};

/// `value` in the scalar type of the check.
fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// What arrives of `u`, and the actuator afterwards is dropped.
fn arrived<T: Scalar, A: Actuator<T, N>, const N: usize>(
    actuator: &A,
    u: [f64; N],
) -> SVector<T, N> {
    actuator.driven(&SVector::from(u.map(num)), T::one()).unwrap().1
}

fn bad_calls_are_refused<T: Scalar>(actuator: &impl Actuator<T, 2>) {
    let good = SVector::<T, 2>::zeros();
    for bad in [0.0, -1.0] {
        let refused = actuator.driven(&good, num(bad)).err();
        assert_eq!(refused, Some(Error::NotPositive { name: "dt", value: bad }));
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let of_time = actuator.driven(&good, num(bad)).err();
        assert!(matches!(of_time, Some(Error::NonFinite { name: "dt", .. })));
        let of_input = actuator.driven(&SVector::from([T::zero(), num(bad)]), T::one()).err();
        assert!(matches!(of_input, Some(Error::NonFiniteEntry { name: "u", index: 1, .. })));
    }
}

#[test]
fn every_actuator_refuses_bad_calls() {
    let saturation = Saturation::symmetric([1.0, 2.0]).unwrap();
    let rate_limit = RateLimit::new([1.0, 2.0]).unwrap();
    bad_calls_are_refused::<f64>(&Ideal);
    bad_calls_are_refused(&saturation);
    bad_calls_are_refused(&rate_limit);
    bad_calls_are_refused(&(saturation, rate_limit));
    bad_calls_are_refused::<f32>(&Ideal);
}

#[test]
fn the_ideal_actuator_changes_nothing() {
    let u = [1e300, -0.0, f64::MIN_POSITIVE];
    assert_eq!(arrived(&Ideal, u).map(f64::to_bits), SVector::from(u.map(f64::to_bits)));
}

/// The limits do not commute: which of two stands first matters.
#[test]
fn a_pair_is_one_actuator_behind_the_other() {
    let saturation = Saturation::new([-1.0], [1.0]).unwrap();
    let rate_limit = RateLimit::new([3.0]).unwrap().starting_at([5.0]).unwrap();
    assert_eq!(arrived::<f64, _, 1>(&(saturation, rate_limit), [9.0])[0], 2.0);
    assert_eq!(arrived::<f64, _, 1>(&(rate_limit, saturation), [9.0])[0], 1.0);
}
