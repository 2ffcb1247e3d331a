//! What holds for every differentiator.

use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    differentiator::{
        BackwardDifference, Differentiator, FilteredDifference, HighGain, RobustExact, Tracking,
    },
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, cases, real, rng, ulps};

in_both_precisions! {
    a_bad_sample_is_refused_and_changes_nothing,
    an_outlier_is_refused_or_does_not_silence_what_follows,
    a_signal_at_rest_has_no_rate_and_the_first_sample_none_either,
    a_signal_turned_over_has_the_opposite_rate,
    what_is_known_of_a_signal_does_not_appear_in_its_rate,
    after_a_reset_it_is_as_new,
    a_ramp_that_was_caught_stays_exact_while_the_period_varies,
}

/// A check generic over the differentiator.
trait Check<T: Scalar> {
    fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
        &mut self,
        new: D,
    );
}

/// Every law, in every order, with parameters fit for signals of a few units and seconds.
fn every<T: Scalar>(mut check: impl Check<T>) {
    every_but_tracking(&mut check);
    check.check(Tracking::new(real(40.0), real(0.25)).unwrap());
}

fn every_but_tracking<T: Scalar>(check: &mut impl Check<T>) {
    check.check(BackwardDifference::new());
    check.check(FilteredDifference::new(real(0.3)).unwrap());
    check.check(HighGain::first_order(real(4.0)).unwrap());
    check.check(HighGain::second_order(real(4.0)).unwrap());
    check.check(RobustExact::first_order(real(4.0)).unwrap());
    check.check(RobustExact::second_order(real(8.0)).unwrap());
    check.check(RobustExact::third_order(real(16.0)).unwrap());
}

/// Samples of `signal` at varying periods, fed to `source`.
fn feed<T: Scalar>(
    source: &mut impl Differentiator<Scalar = T>,
    signal: impl Fn(f64) -> f64,
) -> Vec<T> {
    let (mut t, mut rng) = (0.0, rng());
    let mut next = || {
        let dt = rng.random_range(0.06..0.14);
        t += dt;
        source.update(real(signal(t)), real(dt)).unwrap()
    };
    (0..60).map(|_| next()).collect()
}

fn wave(t: f64) -> f64 {
    (2.0 * t).sin() + 0.5 * t
}

fn a_bad_sample_is_refused_and_changes_nothing<T: Scalar>() {
    struct Refusal;
    impl<T: Scalar> Check<T> for Refusal {
        fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
            &mut self,
            new: D,
        ) {
            let mut used = new.clone();
            feed(&mut used, wave);
            for mut source in [new, used] {
                let before = source.clone();
                let one = T::one();
                for bad in NOT_FINITE.map(real) {
                    let name = |result: Result<T, Error>| match result {
                        Err(Error::NonFinite { name, .. }) => name,
                        other => panic!("{other:?}"),
                    };
                    assert_eq!(name(source.update(bad, one)), "y");
                    assert_eq!(name(source.update_beyond(one, bad, one)), "known change of y");
                    assert_eq!(name(source.update(one, bad)), "dt");
                }
                for bad in [0.0, -1.0] {
                    let refused = Err(Error::NotPositive { name: "dt", value: bad });
                    assert_eq!(source.update(one, real(bad)), refused);
                }
                assert_eq!(source, before);
            }
        }
    }
    every::<T>(Refusal);
}

/// Numbers of any size: after whatever was taken, small samples are.
fn an_outlier_is_refused_or_does_not_silence_what_follows<T: Scalar>() {
    struct Outlier;
    impl<T: Scalar> Check<T> for Outlier {
        fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
            &mut self,
            new: D,
        ) {
            let mut used = new.clone();
            feed(&mut used, wave);
            let largest = T::max_value().unwrap();
            for source in [new, used] {
                for shrink in 0..60 {
                    let outlier = largest * real(0.25_f64.powi(shrink));
                    let mut source = source.clone();
                    let _ = source.update(outlier, real(0.1));
                    for y in [1.0, -1.0, 0.5] {
                        source.update(real(y), real(0.1)).unwrap();
                    }
                }
            }
        }
    }
    every::<T>(Outlier);
}

fn a_signal_at_rest_has_no_rate_and_the_first_sample_none_either<T: Scalar>() {
    struct Rest;
    impl<T: Scalar> Check<T> for Rest {
        fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
            &mut self,
            mut new: D,
        ) {
            assert!(feed(&mut new, |_| 1.7).into_iter().all(|rate| rate.is_zero()));
        }
    }
    every::<T>(Rest);
}

fn a_signal_turned_over_has_the_opposite_rate<T: Scalar>() {
    struct Mirror;
    impl<T: Scalar> Check<T> for Mirror {
        fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
            &mut self,
            new: D,
        ) {
            let rates = feed(&mut new.clone(), wave);
            let turned = feed(&mut new.clone(), |t| -wave(t));
            assert!(rates.into_iter().zip(turned).all(|(rate, turned)| rate == -turned));
        }
    }
    every::<T>(Mirror);
}

/// y + k with the change of k known, for a k that jumps about: the rate is that of y, to rounding.
fn what_is_known_of_a_signal_does_not_appear_in_its_rate<T: Scalar>() {
    struct Known;
    impl<T: Scalar> Check<T> for Known {
        fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
            &mut self,
            new: D,
        ) {
            proptest!(cases(20), |(jumps in prop::collection::vec(-3.0..3.0_f64, 40))| {
                let (mut plain, mut beside, mut known) = (new.clone(), new.clone(), 0.0);
                for (k, jump) in jumps.into_iter().enumerate() {
                    known += jump;
                    let (y, dt) = (wave(0.1 * k as f64), real(0.1));
                    let rate = plain.update(real(y), dt).unwrap();
                    let rest = beside.update_beyond(real(y + known), real(jump), dt).unwrap();
                    // y + k < 130 is rounded, divided by dt, and again in the second and third derivative; of those some 10 are remembered.
                    assert_abs_diff_eq!(rate, rest, epsilon = ulps(130.0 * 10.0 * 40.0));
                }
            });
        }
    }
    every::<T>(Known);
}

fn after_a_reset_it_is_as_new<T: Scalar>() {
    struct Reset;
    impl<T: Scalar> Check<T> for Reset {
        fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
            &mut self,
            new: D,
        ) {
            let mut used = new.clone();
            feed(&mut used, wave);
            assert_ne!(used, new);
            used.reset();
            assert_eq!(used, new);
        }
    }
    every::<T>(Reset);
}

/// Of the start e^(−4·30) or less is left after 300 samples of 0.1 s, or nothing at all. The lag of `Tracking` depends on the period.
fn a_ramp_that_was_caught_stays_exact_while_the_period_varies<T: Scalar>() {
    struct Ramp;
    impl<T: Scalar> Check<T> for Ramp {
        fn check<D: Differentiator<Scalar = T> + Clone + PartialEq + core::fmt::Debug>(
            &mut self,
            mut new: D,
        ) {
            let (mut y, slope, mut rng) = (0.5, -0.75, rng());
            for k in 0..400 {
                let dt = if k < 300 { 0.1 } else { rng.random_range(0.06..0.14) };
                y += slope * dt;
                let rate = new.update(real(y), real(dt)).unwrap();
                if k >= 300 {
                    // y < 31 is rounded and divided by dt > 0.06; in higher orders the last derivatives carry ten times as much along.
                    assert_abs_diff_eq!(rate, real(slope), epsilon = ulps(31.0 / 0.06 * 20.0));
                }
            }
        }
    }
    every_but_tracking::<T>(&mut Ramp);
}
