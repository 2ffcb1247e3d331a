use brunovsky::{
    Error, Scalar,
    learning::{ClosedLoop, ErrorRate, Measured},
};
use proptest::prelude::*;

use crate::support::{cases, quiet, real, ulps};

in_both_precisions! {
    s_is_what_the_network_has_not_learned,
    without_a_measured_rate_there_is_none,
}

/// s = ė_n + u_b = −(u_n + Δ), whatever a, b, u and u_b are, at the first sample as at any other.
fn s_is_what_the_network_has_not_learned<T: Scalar>() {
    let numbers = || (-1e3..1e3_f64).prop_map(real::<T>);
    proptest!(cases(1000), |(drift in numbers(), gain in numbers(), u in numbers(), u_b in numbers(), u_n in numbers(), delta in numbers())| {
        let rate = drift + gain * u + delta;
        let at = ClosedLoop { drift, gain, u, u_b, rate: Some(rate), ..quiet::<T, 2>() };
        let s = Measured.error_rate(&at, u_n, real(0.1)).unwrap() + u_b;
        let sizes = [drift, gain * u, u_b, u_n, delta];
        let rounding = sizes.iter().fold(T::zero(), |sum, size| sum + size.abs()) * ulps(6.0);
        prop_assert!((s + (u_n + delta)).abs() <= rounding);
    });
}

fn without_a_measured_rate_there_is_none<T: Scalar>() {
    let missing = Measured.error_rate(&quiet::<T, 2>(), T::zero(), T::one()).unwrap_err();
    assert_eq!(missing, Error::Missing { name: "measured rate of x_n" });
}
