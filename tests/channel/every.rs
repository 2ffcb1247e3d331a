//! What holds for every channel, and for pairs.

use brunovsky::{
    Error, Scalar,
    channel::{
        Bias, Channel, DeadZone, Delay, Dropout, Ideal, Lag, Noise, Quantization, RateLimit,
        Saturation, Wander,
    },
    nalgebra::SVector,
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::{arrived, at_f32_and_f64, num};

fn random() -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(1)
}

fn bad_calls_are_refused<T: Scalar>(channel: &impl Channel<T, 2>) {
    let good = SVector::<T, 2>::zeros();
    for bad in [0.0, -1.0] {
        let refused = channel.passed(&good, num(bad)).err();
        assert_eq!(refused, Some(Error::NotPositive { name: "dt", value: bad }));
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let of_time = channel.passed(&good, num(bad)).err();
        assert!(matches!(of_time, Some(Error::NonFinite { name: "dt", .. })));
        let of_signal = channel.passed(&SVector::from([T::zero(), num(bad)]), T::one()).err();
        assert!(matches!(of_signal, Some(Error::NonFiniteEntry { name: "signal", index: 1, .. })));
    }
}

fn every_channel_refuses_bad_calls<T: Scalar>() {
    let [small, large] = [[0.25, 0.5], [1.0, 2.0]].map(|pair: [f64; 2]| pair.map(num::<T>));
    let saturation = Saturation::symmetric(large).unwrap();
    let rate_limit = RateLimit::new(large).unwrap();
    bad_calls_are_refused::<T>(&Ideal);
    bad_calls_are_refused(&saturation);
    bad_calls_are_refused(&rate_limit);
    bad_calls_are_refused(&(saturation, rate_limit));
    bad_calls_are_refused(&DeadZone::new(small).unwrap());
    bad_calls_are_refused(&Lag::new(small).unwrap());
    bad_calls_are_refused(&Delay::<T, 2, 3>::new());
    bad_calls_are_refused(&Quantization::new(small).unwrap());
    bad_calls_are_refused(&Bias::new(small).unwrap());
    bad_calls_are_refused(&Noise::new(small, random()).unwrap());
    bad_calls_are_refused(&Wander::new(small, T::one(), random()).unwrap());
    bad_calls_are_refused(&Dropout::<T, _, 2>::new(0.5, random()).unwrap());
}

at_f32_and_f64! {
    every_channel_refuses_a_bad_call => every_channel_refuses_bad_calls,
}

#[test]
fn the_ideal_channel_changes_nothing() {
    let u = [1e300, -0.0, f64::MIN_POSITIVE];
    assert_eq!(arrived(&Ideal, u).map(f64::to_bits), SVector::from(u.map(f64::to_bits)));
}

/// The limits do not commute: which of two stands first matters.
#[test]
fn a_pair_is_one_channel_behind_the_other() {
    let saturation = Saturation::new([-1.0], [1.0]).unwrap();
    let rate_limit = RateLimit::new([3.0]).unwrap().starting_at([5.0]).unwrap();
    assert_eq!(arrived::<f64, _, 1>(&(saturation, rate_limit), [9.0])[0], 2.0);
    assert_eq!(arrived::<f64, _, 1>(&(rate_limit, saturation), [9.0])[0], 1.0);
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    let negative = |name| Error::Negative { name, value: -1.0 };
    let not_positive = |name| Error::NotPositive { name, value: 0.0 };
    assert_eq!(DeadZone::new([1.0, -1.0]).unwrap_err(), negative("width"));
    assert_eq!(Noise::new([1.0, -1.0], random()).unwrap_err(), negative("deviation"));
    assert_eq!(Wander::new([-1.0], 1.0, random()).unwrap_err(), negative("deviation"));
    assert_eq!(Wander::new([1.0], 0.0, random()).unwrap_err(), not_positive("time constant"));
    assert_eq!(Lag::new([1.0, 0.0]).unwrap_err(), not_positive("time constant"));
    assert_eq!(Quantization::new([0.0]).unwrap_err(), not_positive("step"));
    let dropout = |probability| Dropout::<f64, _, 1>::new(probability, random()).unwrap_err();
    assert_eq!(dropout(-1.0), negative("probability"));
    assert_eq!(dropout(1.0), Error::NotBelow { name: "probability", value: 1.0, limit: 1.0 });
    assert!(matches!(dropout(f64::NAN), Error::NonFinite { name: "probability", .. }));
    let bias = Bias::new([0.0, f64::NAN]).unwrap_err();
    assert!(matches!(bias, Error::NonFiniteEntry { name: "bias", index: 1, .. }));
}
