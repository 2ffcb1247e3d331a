//! Minimum-jerk curves: interpolation, smoothness at the knots, optimality, exactness for quintics, order six, symmetries.

mod optimality;

use brunovsky::{
    Error, Scalar,
    trajectory::{Boundary, MinimumJerk, Quintic, Trajectory},
};
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{
        NOT_FINITE, WINDING, assert_equal_to_rounding, assert_jets_equal, cases, num, nums, order,
    },
};

const TIMES: [f64; 6] = [-0.5, 0.25, 1.5, 2.0, 3.5, 4.5];

type Curve = MinimumJerk<f64, 2, 6>;
type Ends = [[[f64; 2]; 2]; 2];

/// Points anywhere, segments between 0.4 and 2 s long.
fn any() -> impl Strategy<Value = ([[f64; 2]; 6], [f64; 6], Ends)> {
    let pair = || prop::array::uniform2(-3.0..3.0_f64);
    let durations = prop::array::uniform6(0.4..2.0_f64);
    let ends = prop::array::uniform2(prop::array::uniform2(pair()));
    (prop::array::uniform6(pair()), durations, ends).prop_map(|(points, durations, ends)| {
        let mut t = -1.0;
        let times = durations.map(|h| {
            t += h;
            t
        });
        (points, times, ends)
    })
}

fn curve((points, times, [start, end]): &([[f64; 2]; 6], [f64; 6], Ends)) -> Curve {
    MinimumJerk::with_ends(*points, *times, *start, *end).unwrap()
}

fn passes_its_points_in_time_and_rests_at_the_ends<T: Scalar>() {
    let curve = MinimumJerk::<T, 2, 6>::new(nums(WINDING), TIMES.map(num)).unwrap();
    for (point, t) in WINDING.iter().zip(TIMES) {
        assert_equal_to_rounding(curve.position(num(t)), SVector::from(point.map(num)), 64.0);
    }
    for (point, ends) in [(WINDING[0], [-0.5, -7.0]), (WINDING[5], [4.5, 9.0])] {
        let rest = [SVector::from(point.map(num::<T>)), SVector::zeros(), SVector::zeros()];
        for t in ends {
            assert_jets_equal(curve.jet(num(t)), rest, 256.0);
        }
    }
}

fn with_two_points_is_the_quintic<T: Scalar>() {
    let [p, v, a, q, w, b] =
        [[1.0, 2.0], [-1.0, 0.5], [0.25, 1.0], [2.0, -1.0], [0.5, 1.5], [-0.5, 0.75]]
            .map(|entries: [f64; 2]| entries.map(num::<T>));
    let curve = MinimumJerk::with_ends([p, q], [num(1.0), num(3.5)], [v, a], [w, b]).unwrap();
    let quintic = Quintic::new(Boundary::new(p, v, a), Boundary::new(q, w, b), num(2.5)).unwrap();
    for t in [-0.5, 0.0, 0.5, 1.25, 2.0, 2.5, 4.0] {
        assert_jets_equal(curve.jet::<6>(num(1.0 + t)), quintic.jet(num(t)), 1e3);
    }
}

/// Time and space in other units: positions in 2¹⁰ m and times in 2⁻¹⁰ s give the same numbers, up to roundings.
fn has_no_preferred_units<T: Scalar>() {
    let curve = MinimumJerk::<T, 2, 6>::new(nums(WINDING), TIMES.map(num)).unwrap();
    for (length, duration) in [(1024.0, 1.0 / 1024.0), (1.0 / 1024.0, 1024.0)] {
        let points = WINDING.map(|point| point.map(|x| num::<T>(x * length)));
        let scaled = MinimumJerk::new(points, TIMES.map(|t| num(t * duration))).unwrap();
        for t in [0.0, 1.0, 1.75, 3.0, 4.0] {
            let found = scaled.jet::<4>(num(t * duration));
            for (k, (found, expected)) in found.into_iter().zip(curve.jet::<4>(num(t))).enumerate()
            {
                let unit = length / duration.powi(k as i32);
                assert_equal_to_rounding(found / num::<T>(unit), expected, 1e3);
            }
        }
    }
}

fn refuses_parameters_by_name<T: Scalar>() {
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]];
    let new = |points: [[f64; 2]; 3], times: [f64; 3]| {
        MinimumJerk::<T, 2, 3>::new(nums(points), times.map(num))
    };
    for (times, value, limit) in [([0.0, 0.0, 1.0], 0.0, 0.0), ([0.0, 2.0, 1.0], 2.0, 1.0)] {
        let name = "time of the point before";
        assert_eq!(new(points, times), Err(Error::NotBelow { name, value, limit }));
    }
    for bad in NOT_FINITE {
        let mut away = points;
        away[1][1] = bad;
        let error = new(away, [0.0, 1.0, 2.0]).unwrap_err();
        assert!(matches!(error, Error::NonFiniteEntry { name: "points", index: 3, .. }));
        let error = new(points, [0.0, 1.0, bad]).unwrap_err();
        assert!(matches!(error, Error::NonFiniteEntry { name: "times", index: 2, .. }));
        for (name, end) in [
            ("velocity", [[num(bad); 2], [T::zero(); 2]]),
            ("acceleration", [[T::zero(); 2], [num(bad); 2]]),
        ] {
            let rest = [[T::zero(); 2]; 2];
            let times = [0.0, 1.0, 2.0].map(num);
            for (start, end) in [(rest, end), (end, rest)] {
                let error =
                    MinimumJerk::with_ends(nums::<T, 2, 3>(points), times, start, end).unwrap_err();
                assert!(
                    matches!(error, Error::NonFiniteEntry { name: found, .. } if found == name)
                );
            }
        }
    }
    // The numbers are finite and their differences are not.
    let huge = num::<T>(if T::default_epsilon() > num(1e-10) { 3e38 } else { 1e308 });
    let far = MinimumJerk::new([[-huge], [huge]], [T::zero(), T::one()]).unwrap_err();
    assert!(matches!(far, Error::NonFiniteEntry { name: "coefficients", .. }));
    let long = MinimumJerk::new([[T::zero()], [T::one()]], [-huge, huge]).unwrap_err();
    assert!(matches!(long, Error::NonFinite { .. }));
}

at_f32_and_f64! {
    it_passes_its_points_in_time_and_rests_at_the_ends => passes_its_points_in_time_and_rests_at_the_ends,
    with_two_points_it_is_the_quintic => with_two_points_is_the_quintic,
    it_has_no_preferred_units => has_no_preferred_units,
    parameters_out_of_range_are_refused_by_name => refuses_parameters_by_name,
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn it_interpolates_with_four_continuous_derivatives(case in any()) {
        let r = curve(&case);
        let (points, times, [start, end]) = case;
        for (point, t) in points.into_iter().zip(times) {
            assert_equal_to_rounding(r.position(t), point.into(), 1e3);
        }
        for (t, [velocity, acceleration]) in [(times[0], start), (times[5], end)] {
            let [_, v, a] = r.jet(t);
            assert_equal_to_rounding(v, velocity.into(), 1e4);
            assert_equal_to_rounding(a, acceleration.into(), 1e5);
        }
        for t in &times[1..5] {
            // The last number before a knot belongs to the segment before it. It is 1e-16 s away, over which even the fifth derivative of
            // up to 1e5 changes nothing.
            let before = t - f64::EPSILON * t.abs();
            let (left, right) = (r.jet::<5>(before), r.jet::<5>(*t));
            for (left, right) in left.into_iter().zip(right) {
                assert_equal_to_rounding(left, right, 1e6);
            }
        }
    }

    /// Points and ends of a polynomial of degree 5, which has all its derivatives continuous, give that polynomial.
    #[test]
    fn any_polynomial_of_degree_five_comes_back(c in prop::collection::vec(-1.0..1.0_f64, 6), at in 0.0..5.0_f64) {
        let value = |k: usize, t: f64| {
            let mut c = c.clone();
            (0..k).for_each(|_| c = derivative(&c));
            evaluate(&c, t)
        };
        let times = [-1.0, -0.5, 0.25, 0.5, 1.0, 1.75];
        let ends = [times[0], times[5]].map(|t| [[value(1, t)], [value(2, t)]]);
        let r = MinimumJerk::with_ends(times.map(|t| [value(0, t)]), times, ends[0], ends[1]).unwrap();
        let t = -1.0 + at * 0.55;
        for (k, found) in r.jet::<6>(t).into_iter().enumerate() {
            // Fifth derivatives over segments of 1/4 s magnify roundings by 4⁵.
            prop_assert!((found[0] - value(k, t)).abs() <= 1e-9, "{k}: {found} {}", value(k, t));
        }
    }

    #[test]
    fn backwards_it_is_the_curve_through_the_reversed_points(case in any(), tau in 0.0..1.0_f64) {
        let (mut points, mut times, [start, end]) = case;
        let t = times[0] + (times[5] - times[0]) * tau;
        let forth = curve(&case).jet::<4>(t);
        points.reverse();
        times.reverse();
        let back = |[v, a]: [[f64; 2]; 2]| [v.map(|v| -v), a];
        let back = curve(&(points, times.map(|t| -t), [back(end), back(start)])).jet::<4>(-t);
        let mirrored = [forth[0], -forth[1], forth[2], -forth[3]];
        assert_jets_equal(back, mirrored, 1e6);
    }

    /// The law is linear in the points and knows no direction of space: turn and stretch them, and the curve follows.
    #[test]
    fn an_affine_map_of_the_points_maps_the_curve(case in any(), m in prop::array::uniform4(-2.0..2.0_f64), tau in 0.0..1.0_f64) {
        let (points, times, ends) = case;
        let matrix = SMatrix::<f64, 2, 2>::from_row_slice(&m);
        let map = |x: [f64; 2]| (matrix * SVector::from(x)).into();
        let shift = |x: [f64; 2]| [x[0] + 1.0, x[1] - 2.0];
        let mapped = curve(&(points.map(map).map(shift), times, ends.map(|end| end.map(map))));
        let t = times[0] + (times[5] - times[0]) * tau;
        let mut expected = curve(&case).jet::<4>(t).map(|r| matrix * r);
        expected[0] += SVector::from([1.0, -2.0]);
        assert_jets_equal(mapped.jet(t), expected, 1e6);
    }
}

/// Through M points of sin t, with its ends: splines of degree 5 converge with order 6, and derivative k with order 6 − k.
#[test]
fn it_converges_to_a_smooth_curve_with_order_six() {
    fn errors<const M: usize>() -> [f64; 3] {
        let times: [f64; M] = core::array::from_fn(|i| 4.0 * i as f64 / (M - 1) as f64);
        let ends = [0.0, 4.0].map(|t: f64| [[t.cos()], [-t.sin()]]);
        let points = times.map(|t| [t.sin()]);
        let r = MinimumJerk::with_ends(points, times, ends[0], ends[1]).unwrap();
        let mut errors = [0.0_f64; 3];
        for i in 0..2000 {
            let t = f64::from(i) / 500.0;
            let exact = [t.sin(), t.cos(), -t.sin()];
            for ((error, found), exact) in errors.iter_mut().zip(r.jet::<3>(t)).zip(exact) {
                *error = error.max((found[0] - exact).abs());
            }
        }
        errors
    }
    for (k, (coarse, fine)) in errors::<17>().into_iter().zip(errors::<33>()).enumerate() {
        let measured = order(coarse, fine);
        assert!((measured - (6 - k) as f64).abs() < 0.3, "derivative {k}: order {measured}");
    }
}

fn derivative(c: &[f64]) -> Vec<f64> {
    c.iter().enumerate().skip(1).map(|(j, c)| c * j as f64).collect()
}

fn evaluate(c: &[f64], t: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * t + c)
}
