//! Curves of constant speed: a parabola with its arc length in closed form, the identities of |ṙ| = v, circles, symmetries.

mod convergence;
mod symmetry;

use brunovsky::{
    Error, Scalar,
    trajectory::{ConstantSpeed, Trajectory},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{
        NOT_FINITE, WINDING, assert_equal_to_rounding, assert_jets_equal, cases, integral, num,
        nums,
    },
};

/// The curve of least ∫|x⃛|² through three points is a parabola (its x⃛ vanishes), and with equal distances between them, as here,
/// this one: y = x².
fn parabola<T: Scalar>(speed: f64) -> ConstantSpeed<T, 2, 3> {
    ConstantSpeed::new(nums([[-1.0, 1.0], [0.0, 0.0], [1.0, 1.0]]), num(speed)).unwrap()
}

/// The arc length of y = x² from its vertex: (2x·√(1 + 4x²) + asinh 2x)/4.
fn length_of_the_parabola(x: f64) -> f64 {
    (2.0 * x * (1.0 + 4.0 * x * x).sqrt() + (2.0 * x).asinh()) / 4.0
}

/// r, ṙ and r̈ at abscissa x: (x, x²), v·T and v²·κ·N with κ = 2/(1 + 4x²)^(3/2).
fn runs_along_a_parabola<T: Scalar>() {
    let r = parabola::<T>(2.0);
    let half = length_of_the_parabola(1.0);
    let error = (r.length() - num(2.0 * half)).abs();
    assert!(error <= T::default_epsilon() * num(16.0));
    for i in -10..=10 {
        let x = f64::from(i) / 10.0;
        let t = (half + length_of_the_parabola(x)) / 2.0;
        let tangent = SVector::from([1.0, 2.0 * x]).normalize();
        let curvature = 2.0 / (1.0 + 4.0 * x * x).powf(1.5);
        let normal = SVector::from([-tangent[1], tangent[0]]) * curvature;
        let expected = [SVector::from([x, x * x]), tangent * 2.0, normal * 4.0];
        // At i = ±10, t may round to beyond the ends, where the acceleration is 0.
        let t = num::<T>(t).max(T::zero()).min(r.duration());
        assert_jets_equal(r.jet(t), expected.map(|r| r.map(num)), 256.0);
    }
}

/// |ṙ|² = v², differentiated up to four times.
fn keeps_its_speed<T: Scalar>() {
    let v = num::<T>(0.75);
    let r = ConstantSpeed::<T, 2, 6>::new(nums(WINDING), v).unwrap();
    for i in -50..=1050 {
        let t = r.duration() * num(f64::from(i) / 1000.0);
        let [_, r1, r2, r3, r4, r5] = r.jet(t);
        let n = num::<T>;
        let zeros = [
            r1.norm_squared() - v * v,
            r1.dot(&r2),
            r1.dot(&r3) + r2.norm_squared(),
            r1.dot(&r4) + n(3.0) * r2.dot(&r3),
            r1.dot(&r5) + n(4.0) * r2.dot(&r4) + n(3.0) * r3.norm_squared(),
        ];
        for (k, zero) in zeros.into_iter().enumerate() {
            assert_equal_to_rounding(
                SVector::from([zero]),
                SVector::zeros(),
                64.0 * 4_f64.powi(k as i32),
            );
        }
    }
}

/// Unevenly spaced on a line in space; also with two points, and beyond both ends.
fn follows_a_line<T: Scalar>() {
    let [start, direction] =
        [[1.0, 2.0, -1.0], [2.0, -1.0, 2.0]].map(|v: [f64; 3]| SVector::from(v));
    let at = |s: f64| <[T; 3]>::from((start + direction * (s / 3.0)).map(num::<T>));
    let many = ConstantSpeed::new([0.0, 0.5, 2.0, 3.0, 7.0].map(at), num(0.5)).unwrap();
    let two = ConstantSpeed::new([0.0, 7.0].map(at), num(0.5)).unwrap();
    for i in -10..=200 {
        let t = f64::from(i) / 10.0;
        let expected =
            [at(t / 2.0).into(), (direction / 6.0).map(num), SVector::zeros(), SVector::zeros()];
        assert_jets_equal(two.jet::<4>(num(t)), expected, 64.0);
        assert_jets_equal(many.jet::<4>(num(t)), expected, 2048.0);
    }
    assert_equal_to_rounding(SVector::from([many.length()]), SVector::from([num::<T>(7.0)]), 16.0);
    assert_equal_to_rounding(
        SVector::from([many.duration()]),
        SVector::from([num::<T>(14.0)]),
        16.0,
    );
}

fn goes_on_straight_before_and_after<T: Scalar>() {
    let r = ConstantSpeed::<T, 2, 6>::new(nums(WINDING), num(1.5)).unwrap();
    for (point, end, sign) in [(WINDING[0], T::zero(), -1.0), (WINDING[5], r.duration(), 1.0)] {
        let [position, velocity] = r.jet(end);
        assert_equal_to_rounding(position, SVector::from(point.map(num)), 64.0);
        let away = num::<T>(sign * 2.0);
        let expected = [position + velocity * away, velocity, SVector::zeros(), SVector::zeros()];
        assert_jets_equal(r.jet(end + away), expected, 64.0);
    }
}

fn refuses_parameters_by_name<T: Scalar>() {
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]];
    let new =
        |points: [[f64; 2]; 3], speed| ConstantSpeed::<T, 2, 3>::new(nums(points), num(speed));
    for value in [0.0, -1.0] {
        assert_eq!(new(points, value), Err(Error::NotPositive { name: "speed", value }));
    }
    let twice = [points[0], points[1], points[1]];
    let name = "distance between consecutive points";
    assert_eq!(new(twice, 1.0), Err(Error::NotPositive { name, value: 0.0 }));
    for bad in NOT_FINITE {
        let error = new(points, bad).unwrap_err();
        assert!(matches!(error, Error::NonFinite { name: "speed", .. }));
        let mut away = points;
        away[2][0] = bad;
        let error = new(away, 1.0).unwrap_err();
        assert!(matches!(error, Error::NonFiniteEntry { name: "points", index: 4, .. }));
    }
}

/// There and back: the curve has to stop, or to turn on the spot.
fn refuses_to_turn_on_the_spot<T: Scalar>() {
    let there_and_back = [[0.0, 0.0], [1.0, 0.5], [0.0, 0.0]];
    let error = ConstantSpeed::<T, 2, 3>::new(nums(there_and_back), T::one()).unwrap_err();
    assert!(
        matches!(error, Error::Singular { name: "speed along the spline", value } if value < 0.1)
    );
    let one_dimension = ConstantSpeed::<T, 1, 4>::new(nums([[0.0], [1.0], [2.5], [0.5]]), T::one());
    assert!(matches!(one_dimension, Err(Error::Singular { .. })));
}

at_f32_and_f64! {
    it_runs_along_a_parabola_whose_length_is_known => runs_along_a_parabola,
    it_keeps_its_speed_and_so_do_the_derivatives_of_that => keeps_its_speed,
    waypoints_on_a_line_give_that_line => follows_a_line,
    it_goes_on_straight_before_and_after => goes_on_straight_before_and_after,
    parameters_out_of_range_are_refused_by_name => refuses_parameters_by_name,
    it_refuses_to_turn_on_the_spot => refuses_to_turn_on_the_spot,
}

#[test]
fn derivatives_beyond_the_fifth_are_not_computed() {
    let r = parabola::<f64>(1.0);
    let jet = r.jet::<8>(0.5);
    assert!(jet[..6].iter().flatten().all(|x| x.is_finite()));
    assert!(jet[6..].iter().flatten().all(|x| x.is_nan()));
    assert!(r.references::<6>(0.5)[0].validate().is_err());
    assert!(r.references::<5>(0.5)[0].validate().is_ok());
}

/// The time at which `r` is nearest to `point`: by sampling, then Newton's method on (r − p)·ṙ = 0.
fn passing<const M: usize>(r: &ConstantSpeed<f64, 2, M>, point: [f64; 2]) -> f64 {
    let point = SVector::from(point);
    let times = (0..=1000).map(|i| r.duration() * f64::from(i) / 1000.0);
    let distance = |t: &f64| (r.position(*t) - point).norm();
    let nearest = times.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
    (0..10).fold(nearest, |t, _| {
        let [x, v, a] = r.jet(t);
        t - (x - point).dot(&v) / (v.norm_squared() + (x - point).dot(&a))
    })
}

#[test]
fn it_passes_the_waypoints_in_order_with_four_continuous_derivatives() {
    let r = ConstantSpeed::new(WINDING, 1.5).unwrap();
    let times = WINDING.map(|point| passing(&r, point));
    assert!(times.is_sorted());
    for (t, point) in times.into_iter().zip(WINDING) {
        assert_equal_to_rounding(r.position(t), point.into(), 64.0);
    }
    for t in &times[1..5] {
        // The fifth derivative is below 100, so over 2e-10 s the fourth moves by 2e-8 at most; a jump would stay.
        let (before, after) = (r.jet::<6>(t - 1e-10), r.jet::<6>(t + 1e-10));
        for k in 0..5 {
            let jump = (after[k] - before[k]).amax();
            assert!(jump < 5e-8, "derivative {k} jumps by {jump}");
        }
        // And the two sides are different polynomials.
        assert!((after[5] - before[5]).amax() > 1e-3);
    }
}

fn waypoints() -> impl Strategy<Value = [[f64; 2]; 6]> {
    // Steps ahead and to the side: no way back, so no spot to turn on.
    let step = prop::array::uniform2(0.0..1.0_f64);
    prop::array::uniform6(step).prop_map(|steps| {
        let mut x = 0.0;
        steps.map(|[ahead, side]| {
            x += 0.5 + ahead;
            [x, side]
        })
    })
}

proptest! {
    #![proptest_config(cases(200))]

    /// The speed is right whatever the inversion of the arc length says; that the position keeps up with it is this.
    #[test]
    fn the_way_is_the_integral_of_the_velocity(points in waypoints(), tau in 0.0..0.95_f64) {
        let r = ConstantSpeed::new(points, 1.0).unwrap();
        let (from, to) = (tau * r.duration(), (tau + 0.05) * r.duration());
        let way = r.position(to) - r.position(from);
        let velocity = |t| r.jet::<2>(t)[1];
        // Order 6 where it is smooth, 5 across a waypoint, with panels that are short against any bend.
        for i in 0..2 {
            prop_assert!((way[i] - integral(|t| velocity(t)[i], from, to, 50)).abs() < 1e-10);
        }
        prop_assert!((velocity(from).norm() - 1.0).abs() < 1e-10);
    }
}
