use brunovsky::{Error, Scalar, channel::Saturation, nalgebra::SVector};
use proptest::prelude::*;

use super::{arrived, num};

/// What arrives is the command where it is within the limits, and otherwise the limit that it passed.
fn what_is_within_the_limits_arrives<T: Scalar>() {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) };
    proptest!(config, |(least in -9.0..9.0_f64, width in 0.1..9.0_f64, u in -30.0..30.0_f64)| {
        let (least, most) = (num::<T>(least), num::<T>(least + width));
        let saturation = Saturation::new([least], [most]).unwrap();
        let arrived = arrived(&saturation, [u])[0];
        let u = num::<T>(u);
        let wanted = if u < least { least } else if u > most { most } else { u };
        prop_assert_eq!(arrived, wanted);
    });
}

#[test]
fn what_is_within_the_limits_arrives_in_both_precisions() {
    what_is_within_the_limits_arrives::<f32>();
    what_is_within_the_limits_arrives::<f64>();
}

#[test]
fn each_input_has_its_own_limits() {
    let saturation = Saturation::new([-1.0, 0.0], [2.0, 0.5]).unwrap();
    assert_eq!(arrived(&saturation, [-9.0, 9.0]), SVector::from([-1.0, 0.5]));
    assert_eq!(arrived(&saturation, [9.0, -9.0]), SVector::from([2.0, 0.0]));
    assert_eq!(
        Saturation::symmetric([3.0, 0.1]).unwrap(),
        Saturation::new([-3.0, -0.1], [3.0, 0.1]).unwrap()
    );
}

#[test]
fn limits_that_leave_no_room_are_refused() {
    let refused = Saturation::new([0.0, 1.0], [1.0, 1.0]).unwrap_err();
    assert_eq!(refused, Error::NotBelow { name: "least", value: 1.0, limit: 1.0 });
    assert!(Saturation::symmetric([-1.0]).is_err());
    let refused = Saturation::new([0.0, f64::NAN], [1.0, 1.0]).unwrap_err();
    assert!(matches!(refused, Error::NonFiniteEntry { name: "least", index: 1, .. }));
    let refused = Saturation::new([0.0], [f64::INFINITY]).unwrap_err();
    assert!(matches!(refused, Error::NonFiniteEntry { name: "most", index: 0, .. }));
}
