mod spacing;
mod symmetry;

use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::{FuzzyNetwork, Gaussian, Grid, Inputs, Travelling},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{Case, case, cases, evenly_spaced, real, textbook, ulps};

in_both_precisions! {
    the_network_agrees_with_the_textbook,
    the_strengths_are_a_partition_of_unity_with_the_stated_norm,
    far_from_every_centre_the_strengths_stay_a_partition_of_unity,
    far_out_the_nearest_membership_takes_all,
    what_is_lost_in_rounding_is_zero_and_not_subnormal,
    parameters_are_read_back_as_they_were_set,
    refused_consequents_leave_the_network_as_it_was,
    an_input_that_is_not_finite_is_refused,
    an_output_beyond_the_range_of_the_scalar_is_refused,
    a_travel_does_not_start_beyond_the_range_of_the_scalar,
    moving_the_consequents_moves_the_output_by_the_squared_norm,
}

fn sum<T: Scalar>(values: &[T]) -> T {
    values.iter().fold(T::zero(), |sum, value| sum + *value)
}

fn as_the_textbook<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(48), |(case in case::<T, I, K>())| {
        let (strengths, u_n) = textbook(&case);
        let network = case.network();
        // The exponents reach I·5²/2 = 75, and exp makes their rounding errors relative ones of the strengths, some 75·4 ulps
        // on either side. In f64 the tolerance is 2·10⁻¹³.
        for (own, wanted) in network.fire(&case.e).strengths().iter().zip(&strengths) {
            assert_abs_diff_eq!(*own, *wanted, epsilon = ulps(1000.0));
        }
        assert_abs_diff_eq!(network.evaluate(&case.e).unwrap(), u_n, epsilon = ulps(1000.0));
    });
}

fn the_network_agrees_with_the_textbook<T: Scalar>() {
    for_every_shape!(as_the_textbook::<T>);
}

fn partition<T: Scalar, const I: usize, const K: usize>(case: &Case<T, I, K>)
where
    Inputs<I>: Grid,
{
    let firing = case.network().fire(&case.e);
    let rounding = ulps::<T>((4 * I * K) as f64);
    assert!(firing.strengths().iter().all(|w| *w >= T::zero() && *w <= T::one()));
    assert_abs_diff_eq!(sum(&firing.strengths()), T::one(), epsilon = rounding);
    let squares: Vec<T> = firing.strengths().iter().map(|w| *w * *w).collect();
    let norm = firing.norm_squared();
    assert_abs_diff_eq!(norm, sum(&squares), epsilon = rounding);
    let least = real::<T>((K as f64).powi(-(I as i32)));
    assert!(norm >= least * (T::one() - rounding) && norm <= T::one() + rounding);
}

fn random_partition<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(48), |(case in case::<T, I, K>())| partition(&case));
}

fn the_strengths_are_a_partition_of_unity_with_the_stated_norm<T: Scalar>() {
    for_every_shape!(random_partition::<T>);
}

fn far_partition<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    // |e − c| ≥ |e| − 1 and σ ≤ 2, so 102 is at least 50 widths from every centre. The last distance overflows for every σ < 1
    // in the difference or the quotient, and the square of the last three in f32 does anyway.
    let farthest = T::max_value().unwrap_or(T::one());
    let distances = [real(102.0), real(2e3 + 1.0), real(2e10), real(2e30), farthest];
    proptest!(cases(16), |(case in case::<T, I, K>(), side in prop::bool::ANY)| {
        for distance in distances {
            let e = SVector::repeat(if side { distance } else { -distance });
            let far = Case { e, ..case.clone() };
            partition(&far);
            prop_assert!(far.network().evaluate(&e).unwrap().abs() <= T::one() + ulps(100.0));
            // The quotient of sums is 0/0 there.
            prop_assert_ne!(textbook(&far).1, textbook(&far).1);
            // One input may be far and the others near.
            let mut one_far = case.clone();
            one_far.e[I / 2] = far.e[I / 2];
            partition(&one_far);
        }
    });
}

fn far_from_every_centre_the_strengths_stay_a_partition_of_unity<T: Scalar>() {
    for_every_shape!(far_partition::<T>);
}

fn far_out_the_nearest_membership_takes_all<T: Scalar>() {
    // In widths, the widest membership is the nearest from afar: M² is a quarter of the others'. At 50 the next is behind by
    // (49² − 25²)/2 > 800, and e⁻⁸⁰⁰ is zero in both precisions.
    let row = [(-1.0, 1.0), (0.0, 2.0), (1.0, 1.0)]
        .map(|(c, width)| Gaussian::new(real::<T>(c), real(width)).unwrap());
    let mut network = FuzzyNetwork::<T, 2, 3>::new([row; 2]);
    network.set_consequents(&core::array::from_fn::<T, 9, _>(|r| real(r as f64))).unwrap();
    for distance in [50.0, 1e3, 1e10, 1e30] {
        for (e1, e2) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let e = SVector::from([real::<T>(distance * e1), real(distance * e2)]);
            assert_eq!(network.evaluate(&e).unwrap(), real(4.0));
            assert_eq!(network.fire(&e).norm_squared(), T::one());
        }
    }
}

fn dwindling<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    // With centres one width apart grades differ by factors e^M: somewhere on the way out each is in every decade that there is.
    let network = evenly_spaced::<T, I, K>(T::one());
    let least = T::default_epsilon() * T::default_epsilon();
    for step in 0..4000 {
        let e = SVector::from_fn(|i, _| real::<T>(0.1 * f64::from(step) / (i + 1) as f64));
        for strength in network.fire(&e).strengths().iter() {
            assert!(strength.is_zero() || *strength >= least);
        }
    }
}

fn what_is_lost_in_rounding_is_zero_and_not_subnormal<T: Scalar>() {
    for_every_shape!(dwindling::<T>);
}

fn read_back<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(24), |(case in case::<T, I, K>(), other in case::<T, I, K>())| {
        let mut network = case.network();
        prop_assert_eq!(network.memberships(), case.memberships);
        prop_assert_eq!(&*network.consequents(), &case.consequents[..]);
        network.set_memberships(other.memberships);
        prop_assert_eq!(network.memberships(), other.memberships);
        prop_assert_eq!(&*network.consequents(), &case.consequents[..]);
        network.set_consequents(&other.consequents).unwrap();
        prop_assert_eq!(network, other.network());
    });
}

fn parameters_are_read_back_as_they_were_set<T: Scalar>() {
    for_every_shape!(read_back::<T>);
}

fn refused_consequents_leave_the_network_as_it_was<T: Scalar>() {
    let mut network = evenly_spaced::<T, 2, 3>(T::one());
    network.set_consequents(&[T::one(); 9]).unwrap();
    let before = network;
    for found in [0, 8, 10] {
        let refused = network.set_consequents(&vec![T::zero(); found]).unwrap_err();
        assert_eq!(refused, Error::Length { name: "consequents", expected: 9, found });
        assert_eq!(network, before);
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut consequents = [T::zero(); 9];
        consequents[8] = real(bad);
        let refused = network.set_consequents(&consequents).unwrap_err();
        assert!(matches!(refused, Error::NonFinite { name: "consequent", .. }));
        assert_eq!(network, before);
    }
}

fn an_input_that_is_not_finite_is_refused<T: Scalar>() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let e = SVector::from([T::zero(), real(bad), real(bad)]);
        let refused = evenly_spaced::<T, 3, 2>(T::one()).evaluate(&e).unwrap_err();
        assert!(matches!(refused, Error::NonFiniteEntry { name: "e", index: 1, .. }));
    }
}

/// Eleven times the quotient 1/11 rounds to more than 1 in `f64`, and ten times 1/10 in `f32`, so that an average of the
/// greatest numbers is greater still.
/// A network whose every rule wants the greatest number: the rounding of their mean may leave the range.
fn all_greatest<T: Scalar, const K: usize>() -> FuzzyNetwork<T, 1, K> {
    let alike = Gaussian::new(T::zero(), T::one()).unwrap();
    let mut network = FuzzyNetwork::new([[alike; K]]);
    network.set_consequents(&[T::max_value().unwrap(); K]).unwrap();
    network
}

fn an_output_beyond_the_range_of_the_scalar_is_refused<T: Scalar>() {
    let e = SVector::zeros();
    let [more, less] = [all_greatest::<T, 11>().evaluate(&e), all_greatest::<T, 10>().evaluate(&e)];
    let refused = more.and(less).unwrap_err();
    assert!(matches!(refused, Error::NonFinite { name: "u_n", .. }));
}

fn a_travel_does_not_start_beyond_the_range_of_the_scalar<T: Scalar>() {
    fn start<T: Scalar, const K: usize>() -> T {
        let mut network = all_greatest::<T, K>();
        let e = SVector::from([T::one()]);
        network.carry(&e, real(0.01), real(100.0));
        network.evaluate(&e).unwrap()
    }
    let rounding = T::max_value().unwrap() * ulps(8.0);
    for u_n in [start::<T, 11>(), start::<T, 10>()] {
        assert_abs_diff_eq!(u_n, T::max_value().unwrap(), epsilon = rounding);
    }
}

fn moved<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(24), |(case in case::<T, I, K>(), rate in -8..8_i32)| {
        let (mut network, rate) = (case.network(), real::<T>(rate.into()));
        let firing = network.fire(&case.e);
        let before = network.output(&firing);
        network.move_consequents(&firing, rate);
        // u_n, rate·w̃ᵀw̃ and the consequents are at most 9.
        let wanted = before + rate * firing.norm_squared();
        assert_abs_diff_eq!(network.output(&firing), wanted, epsilon = ulps((32 * I * K) as f64));
        prop_assert_eq!(network.memberships(), case.memberships);
    });
}

fn moving_the_consequents_moves_the_output_by_the_squared_norm<T: Scalar>() {
    for_every_shape!(moved::<T>);
}
