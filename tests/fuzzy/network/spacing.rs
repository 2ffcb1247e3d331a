use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::{FuzzyNetwork, Gaussian},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{cases, evenly_spaced, real, ulps};

in_both_precisions! {
    evenly_spaced_memberships_reach_from_end_to_end,
    evenly_spaced_memberships_mirror_each_other,
    one_evenly_spaced_membership_sits_at_zero,
    a_range_that_is_not_positive_and_finite_is_refused,
}

fn end_to_end<T: Scalar, const K: usize>() {
    for range in [0.75, 1e-20, 3e20].map(real::<T>) {
        let [row] = evenly_spaced::<T, 1, K>(range).memberships();
        let rounding = range * ulps(4.0);
        assert_abs_diff_eq!(row[0].centre(), -range, epsilon = rounding);
        assert_abs_diff_eq!(row[K - 1].centre(), range, epsilon = rounding);
        for pair in row.windows(2) {
            assert_abs_diff_eq!(
                pair[1].centre() - pair[0].centre(),
                pair[0].width(),
                epsilon = rounding
            );
            assert_eq!(pair[0].width(), pair[1].width());
        }
    }
}

fn evenly_spaced_memberships_reach_from_end_to_end<T: Scalar>() {
    end_to_end::<T, 2>();
    end_to_end::<T, 3>();
    end_to_end::<T, 4>();
    end_to_end::<T, 7>();
    end_to_end::<T, 50>();
    let [first, second] =
        FuzzyNetwork::<T, 2, 3>::evenly_spaced([real(1.0), real(5.0)]).unwrap().memberships();
    assert_eq!((first[2].centre(), second[2].centre()), (real(1.0), real(5.0)));
}

fn evenly_spaced_memberships_mirror_each_other<T: Scalar>() {
    let network = evenly_spaced::<T, 2, 5>(real(0.3));
    for row in network.memberships() {
        let mut mirrored = row.map(|membership| -membership.centre());
        mirrored.reverse();
        assert_eq!(row.map(|membership| membership.centre()), mirrored);
    }
    proptest!(cases(64), |(e1 in -1.0..1.0_f64, e2 in -1.0..1.0_f64)| {
        let e = SVector::from([real::<T>(e1), real(e2)]);
        let (strengths, mirrored) = (network.fire(&e), network.fire(&-e));
        // The distances are the same, bit for bit; only the order in which the grades are summed differs.
        for (w, mirrored) in strengths.strengths().iter().rev().zip(mirrored.strengths().iter()) {
            assert_abs_diff_eq!(*w, *mirrored, epsilon = ulps(8.0));
        }
    });
}

fn one_evenly_spaced_membership_sits_at_zero<T: Scalar>() {
    let network = evenly_spaced::<T, 3, 1>(real(0.7));
    let only = Gaussian::new(T::zero(), real(0.7)).unwrap();
    assert_eq!(network.memberships(), [[only]; 3]);
    assert_eq!(*network.consequents(), [T::zero()]);
}

fn a_range_that_is_not_positive_and_finite_is_refused<T: Scalar>() {
    let attempt =
        |bad: f64| FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(), real(bad)]).unwrap_err();
    for bad in [0.0, -2.0] {
        assert_eq!(attempt(bad), Error::NotPositive { name: "range", value: bad });
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "range", .. }));
    }
}
