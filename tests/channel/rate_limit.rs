use brunovsky::{Error, Scalar, channel::RateLimit};

use super::{all_arrived, num};

/// A step becomes a ramp of the limit's slope that ends at the step, exactly: all numbers are multiples of 1/8.
fn a_step_becomes_a_ramp<T: Scalar>() {
    let actuator = RateLimit::<T, 1>::new([num::<T>(0.5)]).unwrap();
    let ramp = all_arrived(actuator, &[1.0; 6], 0.5);
    assert_eq!(ramp, [0.25, 0.5, 0.75, 1.0, 1.0, 1.0].map(num));
    let down = all_arrived(actuator.starting_at([num::<T>(0.25)]).unwrap(), &[-0.5; 4], 0.5);
    assert_eq!(down, [0.0, -0.25, -0.5, -0.5].map(num));
}

#[test]
fn a_step_becomes_a_ramp_in_both_precisions() {
    a_step_becomes_a_ramp::<f32>();
    a_step_becomes_a_ramp::<f64>();
}

/// A signal whose slope stays below the limit passes unchanged to the last bit.
#[test]
fn a_slow_signal_passes() {
    let signal: Vec<f64> = (0..1000).map(|k| (0.01 * f64::from(k)).sin()).collect();
    assert_eq!(all_arrived(RateLimit::new([1.01]).unwrap(), &signal, 0.01), signal);
}

/// A fast one is followed at the limit, so no two values are farther apart, but for the rounding of one sum.
#[test]
fn no_input_moves_faster_than_its_limit() {
    let signal: Vec<f64> = (0..1000).map(|k| 5.0 * f64::from(k * k).sin()).collect();
    let arrived: Vec<f64> = all_arrived(RateLimit::new([20.0]).unwrap(), &signal, 0.01);
    let fastest = arrived.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
    assert!((fastest - 0.2).abs() <= 5.0 * f64::EPSILON, "{fastest}");
}

#[test]
fn a_rate_or_start_out_of_range_is_refused() {
    let refused = RateLimit::<f64, 2>::new([1.0, -2.0]).unwrap_err();
    assert_eq!(refused, Error::Negative { name: "rate", value: -2.0 });
    let refused = RateLimit::<f64, 1>::new([f64::NAN]).unwrap_err();
    assert!(matches!(refused, Error::NonFinite { name: "rate", .. }));
    let refused = RateLimit::new([1.0]).unwrap().starting_at([f64::INFINITY]).unwrap_err();
    assert!(matches!(refused, Error::NonFiniteEntry { name: "u", index: 0, .. }));
}
