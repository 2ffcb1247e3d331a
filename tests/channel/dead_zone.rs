use brunovsky::{Scalar, channel::DeadZone, nalgebra::SVector};
use proptest::prelude::*;

use super::{arrived, at_f32_and_f64, num};

/// Multiples of 1/8, so that there is no rounding.
fn what_is_within_is_lost_and_the_rest_is_less<T: Scalar>() {
    let zone = DeadZone::new([0.5, 0.0].map(num::<T>)).unwrap();
    let expected = [(-1.25, -0.75), (-0.5, 0.0), (0.375, 0.0), (0.5, 0.0), (0.625, 0.125)];
    for (sent, comes) in expected {
        assert_eq!(arrived::<T, _, 2>(&zone, [sent, sent]), SVector::from([comes, sent].map(num)));
    }
}

at_f32_and_f64! {
    what_is_within_the_zone_is_lost => what_is_within_is_lost_and_the_rest_is_less,
}

proptest! {
    /// Odd, never of the other sign, and with a slope between 0 and 1.
    #[test]
    fn it_is_an_odd_contraction(a in -1e3..1e3_f64, b in -1e3..1e3_f64, width in 0.0..100.0_f64) {
        let zone = DeadZone::new([width, width]).unwrap();
        let [at_a, at_b] = arrived::<f64, _, 2>(&zone, [a, b]).into();
        prop_assert_eq!(arrived::<f64, _, 2>(&zone, [-a, -b]), SVector::from([-at_a, -at_b]));
        prop_assert!(at_a * a >= 0.0);
        prop_assert!((at_a - at_b).abs() <= (a - b).abs() + 1e-12);
    }
}
