//! Circles: their equation, the differential equation of a rotation, and symmetries.

use brunovsky::{
    Error, Scalar,
    trajectory::{Circle, Trajectory},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{NOT_FINITE, assert_equal_to_rounding, assert_jets_equal, cases, num},
};

fn starts_at_its_phase_and_turns_counter_clockwise<T: Scalar>() {
    let circle = Circle::new([1.0, 2.0].map(num::<T>), num(3.0), num(0.5), T::zero()).unwrap();
    let [r, v, a] = circle.jet(T::zero());
    assert_eq!(r, SVector::from([4.0, 2.0].map(num)));
    assert_eq!(v, SVector::from([0.0, 1.5].map(num)));
    assert_eq!(a, SVector::from([-0.75, 0.0].map(num)));
    let up = Circle::new([1.0, 2.0].map(num::<T>), num(3.0), num(0.5), T::frac_pi_2()).unwrap();
    assert_equal_to_rounding(up.position(T::zero()), SVector::from([1.0, 5.0].map(num)), 4.0);
}

fn refuses_parameters_by_name<T: Scalar>() {
    let new = |centre: f64, radius: f64, rate: f64, phase: f64| {
        Circle::new([T::zero(), num(centre)], num(radius), num(rate), num(phase))
    };
    for value in [0.0, -1.0] {
        let refused = Error::NotPositive { name: "radius", value };
        assert_eq!(new(0.0, value, 1.0, 0.0), Err(refused));
    }
    for bad in NOT_FINITE {
        let error = new(bad, 1.0, 1.0, 0.0).unwrap_err();
        assert!(matches!(error, Error::NonFiniteEntry { name: "centre", index: 1, .. }));
        let scalars = [
            ("radius", new(0.0, bad, 1.0, 0.0)),
            ("rate", new(0.0, 1.0, bad, 0.0)),
            ("phase", new(0.0, 1.0, 1.0, bad)),
        ];
        for (name, circle) in scalars {
            let error = circle.unwrap_err();
            assert!(matches!(error, Error::NonFinite { name: found, .. } if found == name));
        }
    }
}

at_f32_and_f64! {
    it_starts_at_its_phase_and_turns_counter_clockwise => starts_at_its_phase_and_turns_counter_clockwise,
    parameters_out_of_range_are_refused_by_name => refuses_parameters_by_name,
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn it_keeps_its_distance_and_turns_a_quarter_with_every_derivative(
        centre in prop::array::uniform2(-5.0..5.0_f64), radius in 0.1..5.0_f64, rate in -3.0..3.0_f64,
        phase in -3.0..3.0_f64, t in -10.0..10.0_f64,
    ) {
        let jet = Circle::new(centre, radius, rate, phase).unwrap().jet::<8>(t);
        let arm = jet[0] - SVector::from(centre);
        prop_assert!((arm.norm() - radius).abs() <= 16.0 * f64::EPSILON * 10.0);
        // v = ω·J·(r − c) with J the quarter turn, and every second derivative is −ω² times the one two before.
        let velocity = SVector::from([-arm[1], arm[0]]) * rate;
        assert_equal_to_rounding(jet[1], velocity, 64.0);
        assert_equal_to_rounding(jet[2], arm * (-rate * rate), 256.0);
        for k in 1..6 {
            assert_equal_to_rounding(jet[k + 2], jet[k] * (-rate * rate), 16.0);
        }
    }

    #[test]
    fn it_returns_after_a_period_and_mirrors_with_its_rate(
        radius in 0.1..5.0_f64, rate in 0.1..3.0_f64, phase in -3.0..3.0_f64, t in -10.0..10.0_f64,
    ) {
        let circle = Circle::new([1.0, 0.0], radius, rate, phase).unwrap();
        let period = 2.0 * std::f64::consts::PI / rate;
        // Angles of up to 40 rad are rounded, and derivatives multiply by 3 each.
        assert_jets_equal(circle.jet::<4>(t + period), circle.jet(t), 1e4);
        let mirrored = Circle::new([1.0, 0.0], radius, -rate, -phase).unwrap();
        let mirror = |r: SVector<f64, 2>| SVector::from([r[0], -r[1]]);
        assert_jets_equal(mirrored.jet::<6>(t), circle.jet::<6>(t).map(mirror), 4.0);
    }
}
