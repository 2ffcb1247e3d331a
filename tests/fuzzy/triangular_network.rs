use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::{Grid, Inputs, Network, Over, Triangular, TriangularNetwork},
    nalgebra::SVector,
};
use proptest::{collection::vec, prelude::*};

use crate::support::{cases, digit, real, ulps};

in_both_precisions! {
    a_function_linear_in_each_input_is_reproduced,
    at_the_peaks_of_a_rule_it_is_its_consequent,
    at_most_two_memberships_an_input_fire_and_they_sum_to_one,
    beyond_the_outermost_peaks_it_goes_on_as_a_constant,
    in_a_gap_the_nearest_fires_alone,
    consequents_are_read_back_or_refused,
    a_range_that_is_not_positive_and_finite_is_refused,
}

fn evenly_spaced<T: Scalar, const I: usize, const K: usize>() -> TriangularNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    TriangularNetwork::evenly_spaced([real(2.0); I]).unwrap()
}

/// The peaks of rule `rule`.
fn peaks<T: Scalar, const I: usize, const K: usize>(
    network: &TriangularNetwork<T, I, K>,
    rule: usize,
) -> SVector<T, I>
where
    Inputs<I>: Grid,
{
    let memberships = network.memberships();
    SVector::from_fn(|i, _| memberships[i][digit::<I, K>(rule, i)].peak())
}

/// Πᵢ (aᵢ + bᵢ·eᵢ), which covers the linear functions and the products.
fn multilinear<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    if K == 1 {
        // One membership alone is a constant.
        return;
    }
    let coefficients = vec((-1.0..1.0_f64, -1.0..1.0_f64), I);
    proptest!(cases(48), |(coefficients in coefficients, e in vec(-2.0..2.0_f64, I))| {
        let mut network = evenly_spaced::<T, I, K>();
        let function = |e: &SVector<T, I>| {
            coefficients.iter().zip(e.iter()).fold(T::one(), |product, ((a, b), e)| product * (real::<T>(*a) + real::<T>(*b) * *e))
        };
        let values: Vec<T> = (0..K.pow(I as u32)).map(|rule| function(&peaks(&network, rule))).collect();
        network.set_consequents(&values).unwrap();
        let e = SVector::from_fn(|i, _| real::<T>(e[i]));
        // Each factor is at most 3, the mean rounds once an input.
        let rounding = ulps::<T>((8 * I) as f64) * real(3.0_f64.powi(I as i32));
        assert_abs_diff_eq!(network.evaluate(&e).unwrap(), function(&e), epsilon = rounding);
    });
}

fn a_function_linear_in_each_input_is_reproduced<T: Scalar>() {
    for_every_shape!(multilinear::<T>);
}

fn on_peaks<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let mut network = evenly_spaced::<T, I, K>();
    let values: Vec<T> = (0..K.pow(I as u32)).map(|rule| real(rule as f64 - 3.5)).collect();
    network.set_consequents(&values).unwrap();
    for (rule, value) in values.iter().enumerate() {
        let e = peaks(&network, rule);
        assert_eq!(network.evaluate(&e).unwrap(), *value);
        assert_eq!(network.fire(&e).norm_squared(), T::one());
    }
}

fn at_the_peaks_of_a_rule_it_is_its_consequent<T: Scalar>() {
    for_every_shape!(on_peaks::<T>);
}

fn few_fire<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let network = evenly_spaced::<T, I, K>();
    proptest!(cases(48), |(e in vec(-5.0..5.0_f64, I))| {
        let firing = network.fire(&SVector::from_fn(|i, _| real::<T>(e[i])));
        let strengths = firing.strengths();
        prop_assert!(strengths.iter().filter(|w| !w.is_zero()).count() <= 2_usize.pow(I as u32));
        prop_assert!(strengths.iter().all(|w| *w >= T::zero() && *w <= T::one()));
        let (sum, squares) = strengths.iter().fold((T::zero(), T::zero()), |(a, b), w| (a + *w, b + *w * *w));
        assert_abs_diff_eq!(sum, T::one(), epsilon = ulps((4 * I * K) as f64));
        assert_abs_diff_eq!(firing.norm_squared(), squares, epsilon = ulps((4 * I * K) as f64));
    });
}

fn at_most_two_memberships_an_input_fire_and_they_sum_to_one<T: Scalar>() {
    for_every_shape!(few_fire::<T>);
}

/// The peaks are at −2, 0 and 2, the outermost feet at ±4: continued from 2 on, through the foot, to the end of the numbers.
fn beyond_the_outermost_peaks_it_goes_on_as_a_constant<T: Scalar>() {
    let mut network = evenly_spaced::<T, 1, 3>();
    network.set_consequents(&[1.0, 5.0, -3.0].map(real)).unwrap();
    let most = nalgebra::try_convert::<_, f64>(T::max_value().unwrap()).unwrap();
    for e in [2.0, 2.5, 3.999, 4.0, 4.001, 1e30, most] {
        assert_eq!(network.evaluate(&SVector::from([real::<T>(e)])).unwrap(), real(-3.0));
        assert_eq!(network.evaluate(&SVector::from([real::<T>(-e)])).unwrap(), T::one());
    }
}

/// Supports from −3 to −1 and from 2 to 4, so the middle of the gap is at 1/2.
fn in_a_gap_the_nearest_fires_alone<T: Scalar>() {
    let triangle =
        |left: f64| Triangular::new(real::<T>(left), real(left + 1.0), real(left + 2.0)).unwrap();
    let mut network = TriangularNetwork::<T, 1, 2>::new([[triangle(-3.0), triangle(2.0)]]);
    network.set_consequents(&[1.0, 5.0].map(real)).unwrap();
    for (e, wanted) in [(-1.1, 1.0), (-1.0, 1.0), (0.49, 1.0), (0.5, 3.0), (0.51, 5.0), (2.0, 5.0)]
    {
        assert_eq!(network.evaluate(&SVector::from([real::<T>(e)])).unwrap(), real(wanted));
    }
}

fn consequents_are_read_back_or_refused<T: Scalar>() {
    let mut network = evenly_spaced::<T, 2, 3>();
    let values = [1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0].map(real::<T>);
    network.set_consequents(&values).unwrap();
    assert_eq!(*network.consequents(), values);
    let before = network;
    assert_eq!(
        network.set_consequents(&values[..8]).unwrap_err(),
        Error::Length { name: "consequents", expected: 9, found: 8 }
    );
    let mut bad = values;
    bad[8] = real(f64::NAN);
    assert!(matches!(
        network.set_consequents(&bad),
        Err(Error::NonFinite { name: "consequent", .. })
    ));
    assert_eq!(network, before);
    let nowhere = SVector::from([T::zero(), real(f64::INFINITY)]);
    assert!(matches!(
        network.evaluate(&nowhere),
        Err(Error::NonFiniteEntry { name: "e", index: 1, .. })
    ));
}

fn a_range_that_is_not_positive_and_finite_is_refused<T: Scalar>() {
    let attempt =
        |bad: f64| TriangularNetwork::<T, 2, 3>::evenly_spaced([T::one(), real(bad)]).unwrap_err();
    for bad in [0.0, -2.0] {
        assert_eq!(attempt(bad), Error::NotPositive { name: "range", value: bad });
    }
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "range", .. }));
    }
}
