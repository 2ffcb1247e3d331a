//! Limits against closed forms, in themselves and found by search, and their units.

use brunovsky::{
    Error, Scalar,
    trajectory::{
        Circle, ConstantSpeed, FigureEight, Limits, Line, MinimumJerk, Quintic, Trajectory,
    },
};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{Hidden, NOT_FINITE, WINDING, cases, num, nums},
};

#[track_caller]
fn assert_limits<T: Scalar>(
    found: Limits<T>,
    speed: f64,
    acceleration: f64,
    yaw_rate: Option<f64>,
    roundings: f64,
) {
    let close = |found: T, expected: f64| {
        let expected = num::<T>(expected);
        (found - expected).abs() <= expected * T::default_epsilon() * num(roundings)
    };
    assert!(close(found.speed, speed), "{found:?}: not {speed}");
    assert!(close(found.acceleration, acceleration), "{found:?}: not {acceleration}");
    match (found.yaw_rate, yaw_rate) {
        (Some(found), Some(expected)) => assert!(close(found, expected), "{found}: not {expected}"),
        (found, expected) => {
            assert!(found.is_none() && expected.is_none(), "{found:?}: not {expected:?}")
        }
    }
}

/// R·|ω|, R·ω² and |ω|, whichever way round, in closed form and by search.
fn of_a_circle_are_known<T: Scalar>() {
    for rate in [0.5, -0.5] {
        let circle = Circle::new([1.0, 2.0].map(num::<T>), num(3.0), num(rate), num(0.7)).unwrap();
        let (from, to) = (num(-1.0), num(2.0));
        assert_limits(circle.limits(from, to).unwrap(), 1.5, 0.75, Some(0.5), 4.0);
        assert_limits(Hidden(circle).limits(from, to).unwrap(), 1.5, 0.75, Some(0.5), 16.0);
    }
}

fn of_a_line_are_known<T: Scalar>() {
    let (from, to) = (num(-1.0), num(2.0));
    let plane = Line::new([1.0, 2.0].map(num::<T>), [3.0, -4.0].map(num)).unwrap();
    assert_limits(plane.limits(from, to).unwrap(), 5.0, 0.0, Some(0.0), 4.0);
    assert_eq!(Hidden(plane).limits(from, to), plane.limits(from, to));
    let space = Line::new([1.0, 2.0, 0.0].map(num::<T>), [3.0, 0.0, -4.0].map(num)).unwrap();
    assert_limits(space.limits(from, to).unwrap(), 5.0, 0.0, None, 4.0);
    assert_eq!(Hidden(space).limits(from, to), space.limits(from, to));
}

/// Resting, or stopping for an instant: the tangent has no direction.
fn what_stops_has_no_yaw_rate<T: Scalar>() {
    let (from, to) = (num(0.25), num(2.0));
    let point = Line::new([1.0, 2.0].map(num::<T>), [T::zero(); 2]).unwrap();
    assert_limits(point.limits(from, to).unwrap(), 0.0, 0.0, None, 0.0);
    assert_limits(Hidden(point).limits(from, to).unwrap(), 0.0, 0.0, None, 0.0);
    let still = Circle::new([T::zero(); 2], T::one(), T::zero(), T::zero()).unwrap();
    assert_limits(still.limits(from, to).unwrap(), 0.0, 0.0, None, 0.0);
    let rest =
        Quintic::rest_to_rest([0.0, 0.0].map(num::<T>), [1.0, 1.0].map(num), num(3.0)).unwrap();
    assert!(rest.limits(T::zero(), num(3.0)).unwrap().yaw_rate.is_none());
    assert!(rest.limits(T::one(), num(2.0)).unwrap().yaw_rate.is_some());
    // Through (1, 1/2) and back within 2 s: it stops there, between samples.
    let back = MinimumJerk::<T, 2, 3>::new(
        nums([[0.0, 0.0], [1.0, 0.5], [0.0, 0.0]]),
        [0.0, 1.0, 2.0].map(num),
    )
    .unwrap();
    assert!(back.limits(num(0.51), num(1.503)).unwrap().yaw_rate.is_none());
    assert!(back.limits(num(0.51), num(0.9)).unwrap().yaw_rate.is_some());
}

/// Speed 15/8·L/T half-way, acceleration 10/√3·L/T² at τ = 1/2 ± √3/6.
fn from_rest_to_rest_are_known<T: Scalar>() {
    let rest =
        Quintic::rest_to_rest([0.0; 3].map(num::<T>), [2.0, 4.0, 4.0].map(num), num(3.0)).unwrap();
    let found = rest.limits(num(-1.0), num(4.0)).unwrap();
    assert_limits(found, 1.875 * 6.0 / 3.0, 10.0 / 3.0_f64.sqrt() * 6.0 / 9.0, None, 64.0);
}

/// A vehicle turns at v·κ, and a parabola y = x² has κ = 2 in its vertex.
fn of_constant_speed_are_speed_times_curvature<T: Scalar>() {
    let r = ConstantSpeed::<T, 2, 3>::new(nums([[-1.0, 1.0], [0.0, 0.0], [1.0, 1.0]]), num(1.5))
        .unwrap();
    // In parts that do not have the vertex on a sample.
    let found = r.limits(num(0.1), num(1.9)).unwrap();
    assert_limits(found, 1.5, 1.5 * 1.5 * 2.0, Some(3.0), 64.0);
}

fn refuse_a_span_that_is_none<T: Scalar>() {
    let circle = Circle::new([T::zero(); 2], T::one(), T::one(), T::zero()).unwrap();
    for (from, to) in [(1.0, 1.0), (2.0, 1.0)] {
        let refused = Err(Error::NotBelow { name: "from", value: from, limit: to });
        assert_eq!(circle.limits(num(from), num(to)), refused);
        assert_eq!(Hidden(circle).limits(num(from), num(to)), refused);
    }
    for bad in NOT_FINITE {
        for (name, from, to) in [("from", bad, 1.0), ("to", 0.0, bad)] {
            for found in
                [circle.limits(num(from), num(to)), Hidden(circle).limits(num(from), num(to))]
            {
                let error = found.unwrap_err();
                assert!(matches!(error, Error::NonFinite { name: n, .. } if n == name));
            }
        }
    }
}

at_f32_and_f64! {
    those_of_a_circle_are_known => of_a_circle_are_known,
    those_of_a_line_are_known => of_a_line_are_known,
    what_stops_has_no_yaw_rate_there => what_stops_has_no_yaw_rate,
    those_from_rest_to_rest_are_known => from_rest_to_rest_are_known,
    those_of_constant_speed_are_speed_times_curvature => of_constant_speed_are_speed_times_curvature,
    a_span_without_duration_is_refused => refuse_a_span_that_is_none,
}

#[test]
fn a_trajectory_that_is_not_finite_has_no_limits() {
    struct Broken;
    impl Trajectory<2> for Broken {
        type Scalar = f64;
        fn derivatives(&self, t: f64, out: &mut [nalgebra::SVector<f64, 2>]) {
            out.fill(nalgebra::SVector::from([t, if t > 0.7 { f64::NAN } else { 1.0 }]));
        }
    }
    assert!(matches!(Broken.limits(0.0, 1.0), Err(Error::NonFinite { name: "speed", .. })));
    assert!(Broken.limits(0.0, 0.7).is_ok());
}

proptest! {
    #![proptest_config(cases(100))]

    /// Over a period, with z = sin²θ: speed² = ω²·(a²·cos²θ + 4b²·cos²2θ) is greatest in the crossing; acceleration² =
    /// ω⁴·(a²·z + 64b²·z·(1 − z)) is a parabola in z; |yaw rate| = 2|ω|·ab·√z·(3 − 2z)/(a²·(1 − z) + 4b²·(1 − 2z)²).
    #[test]
    fn those_of_a_figure_eight_are_known(a in 0.5..4.0_f64, b in 0.25..4.0_f64, rate in 0.2..2.0_f64) {
        let found = FigureEight::new(a, b, -rate).unwrap().limits(0.1, 0.1 + 2.0 * std::f64::consts::PI / rate).unwrap();
        let speed = rate * (a * a + 4.0 * b * b).sqrt();
        let peak = ((a * a + 64.0 * b * b) / (128.0 * b * b)).min(1.0);
        let acceleration = rate * rate * (a * a * peak + 64.0 * b * b * peak * (1.0 - peak)).sqrt();
        let yaw = |z: f64| {
            2.0 * rate * a * b * z.sqrt() * (3.0 - 2.0 * z) / (a * a * (1.0 - z) + 4.0 * b * b * (1.0 - 2.0 * z).powi(2))
        };
        // The yaw rate has its peak near z = 1/2 or at z = 1: a fine grid is within 1e-12 of a peak that is 1/100 wide.
        let highest = (0..=1_000_000).map(|i| yaw(f64::from(i) * 1e-6)).fold(0.0, f64::max);
        prop_assert!((found.speed - speed).abs() <= 1e-14 * speed);
        prop_assert!((found.acceleration - acceleration).abs() <= 1e-13 * acceleration);
        let yaw_rate = found.yaw_rate.unwrap();
        prop_assert!((yaw_rate - highest).abs() <= 1e-8 * highest, "{yaw_rate} {highest}");
    }
}

/// c times as fast: speed and yaw rate times c, acceleration times c².
#[test]
fn they_have_their_units() {
    let one = ConstantSpeed::new(WINDING, 1.0).unwrap();
    let of_one = one.limits(0.0, one.duration()).unwrap();
    for c in [0.25, 0.7, 3.0] {
        let fast = ConstantSpeed::new(WINDING, c).unwrap();
        let found = fast.limits(0.0, fast.duration()).unwrap();
        let close = |found: f64, expected: f64| (found - expected).abs() <= 1e-12 * expected;
        assert!(close(found.speed, c * of_one.speed));
        assert!(close(found.acceleration, c * c * of_one.acceleration));
        assert!(close(found.yaw_rate.unwrap(), c * of_one.yaw_rate.unwrap()));
        // With |ṙ| = v all acceleration is v times the yaw rate.
        assert!(close(found.acceleration, c * found.yaw_rate.unwrap()));
    }
}
