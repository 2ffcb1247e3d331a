//! Measurements: optional parts are absent until given, and all that is given is checked.

use brunovsky::{Error, Scalar, controller::Measurement};
use nalgebra::SVector;

use crate::{at_f32_and_f64, support::num};

fn has_only_what_was_given<T: Scalar>() {
    let (x, x_dot, u) = (
        SVector::from([1.0, 2.0].map(num::<T>)),
        SVector::from([3.0, 4.0].map(num::<T>)),
        SVector::from([num::<T>(5.0)]),
    );
    let state = Measurement::<T, 2, 1>::new(x);
    assert_eq!(state, Measurement { x, x_dot: None, applied: None });
    let x_dot_given = Measurement { x_dot: Some(x_dot), ..state };
    assert_eq!(state.with_rate(x_dot), x_dot_given);
    let u_given = Measurement { applied: Some(u), ..state };
    assert_eq!(state.with_applied(u), u_given);
    // The two are independent and commute.
    assert_eq!(state.with_rate(x_dot).with_applied(u), state.with_applied(u).with_rate(x_dot));
    for given in [state, x_dot_given, u_given] {
        assert_eq!(given.validate(), Ok(()));
    }
}

fn names_the_entry_that_is_not_finite<T: Scalar>() {
    let good = Measurement::<T, 2, 1>::new([T::one(); 2])
        .with_rate([T::one(); 2])
        .with_applied([T::one()]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let spoiled = |index: usize| {
            let mut vector = SVector::<T, 2>::repeat(T::one());
            vector[index] = num(bad);
            vector
        };
        for i in 0..2 {
            let error = Measurement { x: spoiled(i), ..good }.validate().unwrap_err();
            assert!(matches!(error, Error::NonFiniteEntry { name: "x", index, .. } if index == i));
            let error = good.with_rate(spoiled(i)).validate().unwrap_err();
            assert!(
                matches!(error, Error::NonFiniteEntry { name: "x_dot", index, .. } if index == i)
            );
        }
        let error = good.with_applied([num::<T>(bad)]).validate().unwrap_err();
        assert!(matches!(error, Error::NonFiniteEntry { name: "applied", index: 0, .. }));
    }
}

at_f32_and_f64! {
    it_has_only_what_was_given => has_only_what_was_given,
    entries_that_are_not_finite_are_named => names_the_entry_that_is_not_finite,
}
