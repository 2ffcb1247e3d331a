use brunovsky::{
    Error, Scalar,
    learning::{BackwardDifference, ClosedLoop, Compensator, Measured, NullCompensator},
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, any_magnitude, at_error, cases, quiet, real};

in_both_precisions! {
    the_null_compensator_changes_no_sum,
    the_null_compensator_watches_s,
    an_advance_leaves_the_compensator_itself_alone,
    a_sample_without_a_finite_s_is_refused,
}

/// −0 is the one number with x + u_n = x for every x, the sign of a zero included.
fn the_null_compensator_changes_no_sum<T: Scalar>() {
    let (_, compensation) = NullCompensator::new(BackwardDifference::new())
        .advanced(&quiet::<T, 2>(), T::one())
        .unwrap();
    let u_n = compensation.u_n;
    assert!(u_n == T::zero() && u_n.is_sign_negative());
    assert!((-T::zero() + u_n).is_sign_negative() && (T::zero() + u_n).is_sign_positive());
    proptest!(cases(200), |(x in any_magnitude::<T>())| prop_assert_eq!(x + u_n, x));
}

/// s = ė_n + u_b, the rate being that of a ramp of eighths.
fn the_null_compensator_watches_s<T: Scalar>() {
    proptest!(cases(200), |(slope in -50..50_i32, u_b in -50..50_i32)| {
        let (slope, u_b) = (f64::from(slope), real::<T>(u_b.into()));
        let mut watch = NullCompensator::new(BackwardDifference::new());
        for k in 0..5_u32 {
            let at = ClosedLoop { u_b, ..at_error(real(slope * 0.125 * f64::from(k))) };
            let (next, compensation) = watch.advanced(&at, real(0.125)).unwrap();
            prop_assert_eq!(compensation.s, if k == 0 { u_b } else { u_b + real(slope) });
            watch = next;
        }
    });
}

fn an_advance_leaves_the_compensator_itself_alone<T: Scalar>() {
    let watch = NullCompensator::new(BackwardDifference::new());
    let (next, first) = watch.advanced(&at_error::<T>(T::one()), T::one()).unwrap();
    assert_eq!(watch, NullCompensator::new(BackwardDifference::new()));
    assert_ne!(next, watch);
    // Asked again, it answers the same.
    assert_eq!(watch.advanced(&at_error(T::one()), T::one()), Ok((next, first)));
}

fn a_sample_without_a_finite_s_is_refused<T: Scalar>() {
    let watch = NullCompensator::new(BackwardDifference::new());
    let (watch, _) = watch.advanced(&at_error::<T>(T::one()), T::one()).unwrap();
    for bad in NOT_FINITE {
        let parts =
            [("e_n/dt", at_error(real(bad))), ("s", ClosedLoop { u_b: real(bad), ..quiet() })];
        for (part, at) in parts {
            let error = watch.advanced(&at, T::one());
            assert!(matches!(error, Err(Error::NonFinite { name, .. }) if name == part));
        }
    }
    let missing = NullCompensator::new(Measured).advanced(&quiet::<T, 2>(), T::one()).unwrap_err();
    assert_eq!(missing, Error::Missing { name: "measured rate of x_n" });
}
