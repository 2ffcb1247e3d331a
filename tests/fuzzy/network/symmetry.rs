use approx::assert_abs_diff_eq;
use brunovsky::{
    Scalar,
    fuzzy::{Gaussian, Grid, Inputs},
};
use proptest::prelude::*;

use crate::support::{Case, case, cases, digit, real, ulps};

in_both_precisions! {
    moving_centres_and_input_alike_changes_nothing,
    inputs_may_be_given_in_the_opposite_order,
}

fn translated<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    // Multiples of 2⁻¹⁰ below 2¹¹: e − c is the same number before and after, bit for bit.
    proptest!(cases(24), |(case in case::<T, I, K>(), shift in -1000..1000_i32)| {
        let shift = real::<T>(shift.into());
        let moved = Case {
            memberships: case.memberships.map(|row| {
                row.map(|membership| Gaussian::new(membership.centre() + shift, membership.width()).unwrap())
            }),
            e: case.e.add_scalar(shift),
            ..case.clone()
        };
        prop_assert_eq!(moved.network().fire(&moved.e), case.network().fire(&case.e));
    });
}

fn moving_centres_and_input_alike_changes_nothing<T: Scalar>() {
    for_every_shape!(translated::<T>);
}

fn reversed<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(24), |(case in case::<T, I, K>())| {
        let transposed = |rule| (0..I).fold(0, |number, i| number + digit::<I, K>(rule, i) * K.pow(i as u32));
        let mut other = case.clone();
        other.memberships.reverse();
        other.e.as_mut_slice().reverse();
        for rule in 0..case.consequents.len() {
            other.consequents[transposed(rule)] = case.consequents[rule];
        }
        // The products and sums are the same numbers in another order; Σ|w̃·f| ≤ 1.
        let (own, wanted) = (other.network().evaluate(&other.e), case.network().evaluate(&case.e));
        assert_abs_diff_eq!(own.unwrap(), wanted.unwrap(), epsilon = ulps((4 * I * K) as f64));
    });
}

fn inputs_may_be_given_in_the_opposite_order<T: Scalar>() {
    for_every_shape!(reversed::<T>);
}
