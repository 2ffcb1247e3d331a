//! References: what they hold, and that they are checked entry by entry.

use brunovsky::{Error, Scalar, controller::Reference};
use nalgebra::SVector;

use crate::{at_f32_and_f64, support::num};

fn keeps_the_derivatives_in_order<T: Scalar>() {
    let reference = Reference::<T, 3>::new([1.0, 2.0, 3.0].map(num), num(4.0));
    assert_eq!(reference.r, SVector::from([1.0, 2.0, 3.0].map(num)));
    assert_eq!(reference.r_n_dot, num(4.0));
    assert_eq!(reference.validate(), Ok(()));
}

fn rests_at_a_setpoint<T: Scalar>() {
    let setpoint = Reference::<T, 3>::setpoint(num(-5.0));
    assert_eq!(setpoint, Reference::new([-5.0, 0.0, 0.0].map(num), T::zero()));
    assert_eq!(setpoint.validate(), Ok(()));
}

fn names_the_entry_that_is_not_finite<T: Scalar>() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for index in 0..3 {
            let mut reference = Reference::<T, 3>::setpoint(T::one());
            reference.r[index] = num(bad);
            let error = reference.validate().unwrap_err();
            assert!(
                matches!(error, Error::NonFiniteEntry { name: "r", index: found, .. } if found == index)
            );
        }
        let mut reference = Reference::<T, 3>::setpoint(T::one());
        reference.r_n_dot = num(bad);
        let error = reference.validate().unwrap_err();
        assert!(matches!(error, Error::NonFinite { name: "r_n_dot", .. }));
    }
}

at_f32_and_f64! {
    it_holds_the_signal_and_its_derivatives_in_order => keeps_the_derivatives_in_order,
    a_setpoint_has_no_derivatives => rests_at_a_setpoint,
    entries_that_are_not_finite_are_named => names_the_entry_that_is_not_finite,
}
