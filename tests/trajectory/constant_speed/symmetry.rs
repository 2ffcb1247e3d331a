//! Reversed, turned, mirrored and faster, it is the same curve.

use brunovsky::trajectory::{ConstantSpeed, Trajectory};
use nalgebra::SVector;
use proptest::prelude::*;

use super::waypoints;
use crate::support::{assert_equal_to_rounding, assert_jets_equal, cases};

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn backwards_it_is_the_curve_through_the_reversed_points(mut points in waypoints(), tau in 0.01..0.99_f64) {
        let forth = ConstantSpeed::new(points, 1.5).unwrap();
        points.reverse();
        let back = ConstantSpeed::new(points, 1.5).unwrap();
        assert_equal_to_rounding(SVector::from([back.length()]), SVector::from([forth.length()]), 64.0);
        let t = tau * forth.duration();
        let [r, v, a, jerk] = forth.jet(t);
        assert_jets_equal(back.jet(back.duration() - t), [r, -v, a, -jerk], 1e6);
    }

    /// r_{cv}(t) = r_v(c·t), so derivatives are multiplied by cᵏ.
    #[test]
    fn at_another_speed_it_is_the_same_curve(points in waypoints(), c in 0.25..4.0_f64, tau in -0.2..1.2_f64) {
        let (one, other) = (ConstantSpeed::new(points, 1.0).unwrap(), ConstantSpeed::new(points, c).unwrap());
        let t = tau * one.duration();
        for (k, (r, other)) in one.jet::<6>(t).into_iter().zip(other.jet::<6>(t / c)).enumerate() {
            assert_equal_to_rounding(other / c.powi(k as i32), r, 1e6);
        }
    }

    #[test]
    fn turned_and_mirrored_waypoints_turn_and_mirror_the_curve(points in waypoints(), angle in -3.0..3.0_f64, tau in -0.2..1.2_f64) {
        let (sin, cos) = angle.sin_cos();
        // A rotation after a reflection, and a shift.
        let map = |[x, y]: [f64; 2]| [x * cos + y * sin, x * sin - y * cos];
        let r = ConstantSpeed::new(points, 1.0).unwrap();
        let mapped = ConstantSpeed::new(points.map(map).map(|[x, y]| [x + 3.0, y - 1.0]), 1.0).unwrap();
        let t = tau * r.duration();
        let mut expected = r.jet::<4>(t).map(|r| SVector::from(map(r.into())));
        expected[0] += SVector::from([3.0, -1.0]);
        assert_jets_equal(mapped.jet(t), expected, 1e6);
    }
}
