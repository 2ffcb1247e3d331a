//! Figure eights: the equation of the curve, the differential equations of its waves, and symmetries.

use brunovsky::{
    Error, Scalar,
    trajectory::{FigureEight, Trajectory},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{NOT_FINITE, assert_equal_to_rounding, assert_jets_equal, cases, num},
};

fn crosses_the_origin_at_its_greatest_speed<T: Scalar>() {
    let eight = FigureEight::new(num::<T>(2.0), num(0.5), num(0.25)).unwrap();
    let [r, v, a] = eight.jet(T::zero());
    assert_eq!((r, a), (SVector::zeros(), SVector::zeros()));
    // (a·ω, 2b·ω).
    assert_eq!(v, SVector::from([0.5, 0.25].map(num)));
    let quarter = T::frac_pi_2() / num(0.25);
    assert_equal_to_rounding(eight.position(quarter), SVector::from([2.0, 0.0].map(num)), 4.0);
}

fn refuses_parameters_by_name<T: Scalar>() {
    let new = |length, width, rate| FigureEight::new(num::<T>(length), num(width), num(rate));
    for value in [0.0, -1.0] {
        assert_eq!(new(value, 1.0, 1.0), Err(Error::NotPositive { name: "length", value }));
        assert_eq!(new(1.0, value, 1.0), Err(Error::NotPositive { name: "width", value }));
        assert!(new(1.0, 1.0, value).is_ok());
    }
    for bad in NOT_FINITE {
        for (name, eight) in [
            ("length", new(bad, 1.0, 1.0)),
            ("width", new(1.0, bad, 1.0)),
            ("rate", new(1.0, 1.0, bad)),
        ] {
            let error = eight.unwrap_err();
            assert!(matches!(error, Error::NonFinite { name: found, .. } if found == name));
        }
    }
}

at_f32_and_f64! {
    it_crosses_the_origin_at_its_greatest_speed => crosses_the_origin_at_its_greatest_speed,
    parameters_out_of_range_are_refused_by_name => refuses_parameters_by_name,
}

proptest! {
    #![proptest_config(cases(500))]

    /// sin 2θ = 2·sin θ·cos θ: (y/2b)² = (x/a)²·(1 − (x/a)²).
    #[test]
    fn it_stays_on_its_curve(
        a in 0.1..5.0_f64, b in 0.1..5.0_f64, rate in -3.0..3.0_f64, t in -10.0..10.0_f64,
    ) {
        let r = FigureEight::new(a, b, rate).unwrap().position(t);
        let (x, y) = (r[0] / a, r[1] / (2.0 * b));
        prop_assert!((y * y - x * x * (1.0 - x * x)).abs() <= 64.0 * f64::EPSILON);
    }

    /// ẍ = −ω²·x and ÿ = −4ω²·y, for every derivative.
    #[test]
    fn it_is_made_of_two_harmonic_waves(
        a in 0.1..5.0_f64, b in 0.1..5.0_f64, rate in -3.0..3.0_f64, t in -10.0..10.0_f64,
    ) {
        let jet = FigureEight::new(a, b, rate).unwrap().jet::<8>(t);
        let squares = SVector::from([rate * rate, 4.0 * rate * rate]);
        for k in 0..6 {
            assert_equal_to_rounding(jet[k + 2], -jet[k].component_mul(&squares), 16.0);
        }
    }

    /// r(−t) = −r(t), and with −ω it runs backwards; half a period later it is mirrored in the y axis.
    #[test]
    fn it_is_symmetric_in_time_and_space(
        a in 0.1..5.0_f64, b in 0.1..5.0_f64, rate in 0.1..3.0_f64, t in -10.0..10.0_f64,
    ) {
        let eight = FigureEight::new(a, b, rate).unwrap();
        prop_assert_eq!(eight.position(-t), -eight.position(t));
        prop_assert_eq!(FigureEight::new(a, b, -rate).unwrap().position(t), eight.position(-t));
        let mirror = |r: SVector<f64, 2>| SVector::from([-r[0], r[1]]);
        let half = std::f64::consts::PI / rate;
        // Angles of up to 70 rad are rounded, and derivatives multiply by up to 6 each.
        assert_jets_equal(eight.jet::<3>(t + half), eight.jet::<3>(t).map(mirror), 1e4);
    }
}
