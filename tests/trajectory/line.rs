//! Lines against their equation.

use brunovsky::{
    Error, Scalar,
    trajectory::{Line, Trajectory},
};
use nalgebra::SVector;

use crate::{
    at_f32_and_f64,
    support::{NOT_FINITE, num},
};

/// Dyadic numbers: no roundings.
fn moves_along_its_velocity<T: Scalar>() {
    let line = Line::new([1.0, 2.0, 3.0].map(num::<T>), [0.5, 0.0, -2.0].map(num)).unwrap();
    for t in [-4.0, 0.0, 0.25, 1024.0] {
        let [r, v, a, jerk] = line.jet(num(t));
        assert_eq!(r, SVector::from([1.0 + 0.5 * t, 2.0, 3.0 - 2.0 * t].map(num)));
        assert_eq!(v, SVector::from([0.5, 0.0, -2.0].map(num)));
        assert_eq!((a, jerk), (SVector::zeros(), SVector::zeros()));
    }
}

fn refuses_what_is_not_finite<T: Scalar>() {
    for bad in NOT_FINITE {
        for index in 0..2 {
            let mut entries = [T::zero(); 2];
            entries[index] = num(bad);
            let zero = [T::zero(); 2];
            for (name, line) in
                [("start", Line::new(entries, zero)), ("velocity", Line::new(zero, entries))]
            {
                let error = line.unwrap_err();
                assert!(
                    matches!(error, Error::NonFiniteEntry { name: n, index: i, .. } if (n, i) == (name, index))
                );
            }
        }
    }
}

at_f32_and_f64! {
    it_moves_along_its_velocity => moves_along_its_velocity,
    parameters_that_are_not_finite_are_named => refuses_what_is_not_finite,
}
