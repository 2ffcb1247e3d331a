use brunovsky::{Scalar, channel::Quantization};
use proptest::prelude::*;

use super::{all_arrived, arrived, at_f32_and_f64, num};

fn the_nearest_multiple_arrives<T: Scalar>() {
    let sent = [-0.375, -0.25, 0.1, 0.125, 0.2, 0.374, 100.0];
    let comes = [-0.5, -0.25, 0.0, 0.25, 0.25, 0.25, 100.0].map(num::<T>);
    assert_eq!(all_arrived(Quantization::new([num::<T>(0.25)]).unwrap(), &sent, 0.1), comes);
}

at_f32_and_f64! {
    the_nearest_step_arrives => the_nearest_multiple_arrives,
}

/// What has more steps than the scalar can count passes as it is.
#[test]
fn a_step_that_is_lost_in_the_signal_changes_nothing() {
    let quantization = Quantization::new([1e-300, f64::MAX]).unwrap();
    let comes = arrived::<f64, _, 2>(&quantization, [f64::MAX, -f64::MAX]);
    assert_eq!(<[f64; 2]>::from(comes), [f64::MAX, -f64::MAX]);
}

proptest! {
    #[test]
    fn the_error_is_at_most_half_a_step(signal in -1e3..1e3_f64, step in 1e-3..10.0_f64) {
        let comes = arrived::<f64, _, 1>(&Quantization::new([step]).unwrap(), [signal])[0];
        let rounding = 4.0 * f64::EPSILON * signal.abs();
        prop_assert!((comes - signal).abs() <= step / 2.0 + rounding);
        let steps = comes / step;
        prop_assert!((steps - steps.round()).abs() <= 4.0 * f64::EPSILON * steps.abs());
    }
}
