//! Total variation of signals for which it is known.

use brunovsky::{Error, Scalar, simulation::TotalVariation};
use proptest::prelude::*;

use crate::{at_f32_and_f64, num};

fn empty_and_single_signals_do_not_move<T: Scalar>() {
    assert_eq!(TotalVariation::<T>::of([]), Ok(T::zero()));
    assert_eq!(TotalVariation::of([num::<T>(-7.0)]), Ok(T::zero()));
    assert_eq!(TotalVariation::of([num::<T>(-7.0); 9]), Ok(T::zero()));
}

/// 4 for every period: up by 1, down by 2, up by 1. Samples at the quarters hit the extremes, and between them the sums telescope.
fn a_sine_moves_by_four<T: Scalar>() {
    let samples =
        (0..=3 * 400).map(|k| num::<T>((core::f64::consts::TAU * f64::from(k) / 400.0).sin()));
    let found = TotalVariation::of(samples).unwrap();
    let tolerance = num::<T>(1200.0) * T::default_epsilon();
    approx::assert_relative_eq!(found, num(12.0), max_relative = tolerance);
}

fn a_sample_that_is_not_finite_is_refused<T: Scalar>() {
    let mut variation = TotalVariation::<T>::default();
    variation.push(num(1.0)).unwrap();
    variation.push(num(3.0)).unwrap();
    let before = variation;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = variation.push(num(bad)).unwrap_err();
        assert!(matches!(error, Error::NonFinite { name: "u", .. }));
        assert_eq!(variation, before);
        assert!(TotalVariation::of([num::<T>(1.0), num(bad)]).is_err());
    }
    variation.push(num(2.0)).unwrap();
    assert_eq!(variation.value(), num(3.0));
}

fn a_sum_beyond_the_range_is_refused<T: Scalar>() {
    let most = T::max_value().unwrap();
    let mut variation = TotalVariation::default();
    variation.push(-most).unwrap();
    let before = variation;
    let error = variation.push(most).unwrap_err();
    assert!(matches!(error, Error::NonFinite { name: "total variation", .. }));
    assert_eq!(variation, before);
    variation.push(T::zero()).unwrap();
    assert_eq!(variation.value(), most);
}

at_f32_and_f64! {
    a_signal_of_one_value_does_not_move => empty_and_single_signals_do_not_move,
    a_sine_moves_by_four_a_period => a_sine_moves_by_four,
    what_is_not_finite_is_refused_and_not_taken => a_sample_that_is_not_finite_is_refused,
    a_sum_beyond_the_range_is_refused_and_not_taken => a_sum_beyond_the_range_is_refused,
}

/// Whole numbers, so that sums are exact and the laws hold without tolerance.
fn signal() -> impl Strategy<Value = Vec<f64>> {
    let entry = (-1000..1000_i32).prop_map(f64::from);
    prop::collection::vec(entry, 2..50)
}

proptest! {
    #[test]
    fn a_monotone_signal_moves_by_the_difference_of_its_ends(mut samples in signal()) {
        samples.sort_by(f64::total_cmp);
        let difference = samples[samples.len() - 1] - samples[0];
        prop_assert_eq!(TotalVariation::of(samples), Ok(difference));
    }

    #[test]
    fn it_does_not_depend_on_offset_sign_or_direction_and_scales_with_the_signal(samples in signal()) {
        let variation = |map: fn(f64) -> f64| TotalVariation::of(samples.iter().map(|u| map(*u))).unwrap();
        let plain = variation(|u| u);
        prop_assert_eq!(variation(|u| u + 17.0), plain);
        prop_assert_eq!(variation(|u| -u), plain);
        prop_assert_eq!(variation(|u| 3.0 * u), 3.0 * plain);
        prop_assert_eq!(TotalVariation::of(samples.iter().rev().copied()), Ok(plain));
    }

    #[test]
    fn parts_that_share_a_sample_add_up(samples in signal(), cut in any::<prop::sample::Index>()) {
        let cut = cut.index(samples.len());
        let of = |part: &[f64]| TotalVariation::of(part.iter().copied()).unwrap();
        prop_assert_eq!(of(&samples[..=cut]) + of(&samples[cut..]), of(&samples));
    }
}
