use brunovsky::{
    Error, Scalar,
    learning::{ClosedLoop, Conditional, ErrorRate, FilteredDifference, Measured},
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, at_error, cases, quiet, real};

in_both_precisions! {
    it_stops_where_learning_pushes_into_the_limit_and_only_there,
    a_tolerance_out_of_range_is_refused,
    a_rate_beyond_the_range_is_refused_and_not_replaced,
}

/// s = −(u_n + Δ) by the source inside. It stays, unless more than the tolerance is missing of what was asked for and u_n would go the
/// way that is missing: asked 3, got 1, with b = −2 means that ẋ_n got 4 more than asked, and only a further fall of u_n is refused.
fn it_stops_where_learning_pushes_into_the_limit_and_only_there<T: Scalar>() {
    let tolerance = 0.5;
    let parts = (-9.0..9.0_f64, -9.0..9.0_f64, -9.0..9.0_f64, -9.0..9.0_f64);
    proptest!(cases(2000), |((gain, u, asked, delta) in parts, u_b in -9.0..9.0_f64)| {
        let at = ClosedLoop {
            gain: real(gain),
            u: real(u),
            asked: real(asked),
            u_b: real(u_b),
            rate: Some(real::<T>(gain) * real(u) + real(delta)),
            ..quiet::<T, 2>()
        };
        let free = Measured.error_rate(&at, T::zero(), T::one()).unwrap();
        let mut source = Conditional::new(Measured, real(tolerance)).unwrap();
        let found = source.error_rate(&at, T::zero(), T::one()).unwrap();
        let (missing, s) = (gain * (u - asked), -delta);
        // Near the edges of the rule rounding decides.
        prop_assume!((missing.abs() - tolerance).abs() > 1e-3 && s.abs() > 1e-3);
        let stopped = missing.abs() > tolerance && missing.signum() != s.signum();
        prop_assert_eq!(found, if stopped { -at.u_b } else { free });
    });
}

/// Were the infinite rate replaced where learning pushes into the limit, the filter would keep it and answer nothing any more.
fn a_rate_beyond_the_range_is_refused_and_not_replaced<T: Scalar>() {
    let filter = FilteredDifference::new(T::zero()).unwrap();
    let mut source = Conditional::new(filter, T::zero()).unwrap();
    let at = |e_n: T| ClosedLoop { u: T::one(), ..at_error(e_n) };
    assert_eq!(source.error_rate(&at(T::one()), T::zero(), T::one()), Ok(T::zero()));
    let error =
        source.error_rate(&at(T::zero()), T::zero(), T::max_value().unwrap().recip() * real(0.25));
    assert!(matches!(error, Err(Error::NonFinite { name: "rate of e_n", .. })), "{error:?}");
}

fn a_tolerance_out_of_range_is_refused<T: Scalar>() {
    let attempt = |bad| Conditional::new(Measured, real::<T>(bad)).unwrap_err();
    assert_eq!(attempt(-1.0), Error::Negative { name: "tolerance", value: -1.0 });
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "tolerance", .. }));
    }
}
