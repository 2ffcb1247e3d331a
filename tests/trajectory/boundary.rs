//! Boundary states.

use brunovsky::{Error, Scalar, trajectory::Boundary};

use crate::{
    at_f32_and_f64,
    support::{NOT_FINITE, num},
};

fn names_the_entry_that_is_not_finite<T: Scalar>() {
    assert_eq!(Boundary::rest([1.0, 2.0].map(num::<T>)).validate(), Ok(()));
    for bad in NOT_FINITE {
        for (part, name) in ["position", "velocity", "acceleration"].into_iter().enumerate() {
            let mut parts = [[T::zero(); 2]; 3];
            parts[part][1] = num(bad);
            let [p, v, a] = parts;
            let error = Boundary::new(p, v, a).validate().unwrap_err();
            assert!(matches!(error, Error::NonFiniteEntry { name: n, index: 1, .. } if n == name));
        }
    }
}

at_f32_and_f64! {
    entries_that_are_not_finite_are_named => names_the_entry_that_is_not_finite,
}
