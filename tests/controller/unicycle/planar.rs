//! What a planar reference asks of the robot, against circles, an independent quadrature and the range of the scalar.

use core::f64::consts::{PI, TAU};

use brunovsky::{
    Error, Scalar,
    controller::{
        Reference,
        unicycle::{Direction, Heading, feedforward_speed, feedforward_yaw_rate, heading},
    },
    trajectory::{Circle, FigureEight, Trajectory},
};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{num, real},
};

const BOTH: [Direction; 2] = [Direction::Forward, Direction::Reverse];

/// A planar reference in the origin with the given velocity and acceleration.
fn moving<T: Scalar>(v: [f64; 2], a: [f64; 2]) -> [Reference<T, 2>; 2] {
    core::array::from_fn(|i| Reference::new([T::zero(), num(v[i])], num(a[i])))
}

/// `angle` in [−π, π): a difference of angles that ought to be none.
fn wrapped(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

/// On a circle v = ±R·|rate|, ω = rate whichever way the robot faces, and the heading is a quarter turn ahead of the arm.
fn circles_ask_for_their_speed_and_rate<T: Scalar>() {
    let epsilon = real(T::default_epsilon());
    for rate in [0.7, -1.9] {
        let circle =
            Circle::<T>::new([num(3.0), num(-1.0)], num(2.0), num(rate), num(0.3)).unwrap();
        for t in [0.0, 0.4, 1.7, 3.1] {
            let r = circle.references::<2>(num(t));
            let omega = real(feedforward_yaw_rate(&r).unwrap());
            approx::assert_relative_eq!(omega, rate, max_relative = 8.0 * epsilon);
            for direction in BOTH {
                let sign: f64 = direction.sign();
                let v = real(feedforward_speed(&r, direction));
                approx::assert_relative_eq!(
                    v,
                    sign * 2.0 * rate.abs(),
                    max_relative = 8.0 * epsilon
                );
                let arm = rate * t + 0.3 + rate.signum() * PI / 2.0;
                let expected = arm + if direction == Direction::Forward { 0.0 } else { PI };
                let off = wrapped(real(heading(&r, direction).unwrap()) - expected);
                // Angles below 8 are rounded.
                assert!(off.abs() < 8.0 * 4.0 * epsilon, "{off}");
                // v·(cos θ, sin θ) is the velocity of the reference: the robot stays on it.
                let theta = real(heading(&r, direction).unwrap());
                for (axis, unit) in r.iter().zip([theta.cos(), theta.sin()]) {
                    let expected = real(axis.r[1]);
                    approx::assert_abs_diff_eq!(v * unit, expected, epsilon = 4.0 * 32.0 * epsilon);
                }
            }
        }
    }
}

/// After n samples a hundredth of a turn apart the heading has turned by n/100 turns, and is never beside the wrapped one.
fn unwraps_turn_after_turn<T: Scalar>() {
    for (direction, rate) in BOTH.into_iter().flat_map(|d| [(d, 1.0), (d, -1.0)]) {
        let circle = Circle::<T>::new([T::zero(); 2], T::one(), num(rate), T::zero()).unwrap();
        let mut unwrapped = Heading::new(direction);
        let first = real(unwrapped.update(&circle.references(T::zero())).unwrap());
        assert_eq!(first, real(heading(&circle.references(T::zero()), direction).unwrap()));
        for k in 1..=2000_u32 {
            let t = f64::from(k) * TAU / 100.0;
            let r = circle.references(num(t));
            let turned = real(unwrapped.update(&r).unwrap()) - first;
            // t ≤ 126 is rounded to T, and the angle with it.
            let tolerance = 130.0 * 4.0 * real(T::default_epsilon());
            approx::assert_abs_diff_eq!(turned, rate * t, epsilon = tolerance);
        }
    }
}

/// ∫ω_d dt is the change of the heading, by Simpson's rule over 2000 panels; a figure eight turns as much left as right.
fn the_yaw_rate_integrates_to_the_heading<T: Scalar>() {
    let eight = FigureEight::<T>::new(num(2.0), num(1.0), num(0.5)).unwrap();
    let omega = |t: f64| real(feedforward_yaw_rate(&eight.references(num(t))).unwrap());
    let mut unwrapped = Heading::new(Direction::Reverse);
    let first = real(unwrapped.update(&eight.references(T::zero())).unwrap());
    let panels = 2000_u32;
    let h = 2.0 * TAU / f64::from(panels);
    let (mut integral, mut most) = (0.0, 0.0_f64);
    for k in 0..panels {
        let t = f64::from(k) * h;
        integral += h / 6.0 * (omega(t) + 4.0 * omega(t + 0.5 * h) + omega(t + h));
        let turned = real(unwrapped.update(&eight.references(num(t + h))).unwrap()) - first;
        // Simpson's h⁴ is 2e-9 here; at f32 the curve itself is rounded, and its slope with it.
        let tolerance = 1e-7 + 200.0 * real(T::default_epsilon());
        approx::assert_abs_diff_eq!(turned, integral, epsilon = tolerance);
        most = most.max(turned.abs());
    }
    // Either lobe turns by more than half a turn, or the check above would have had nothing to unwrap.
    assert!(most > PI, "{most}");
}

/// Speeds whose square is out of range have a speed, a heading and a yaw rate all the same.
fn the_range_of_the_scalar_does_not_matter<T: Scalar>(exponent: i32) {
    for scale in [2.0_f64.powi(exponent), 2.0_f64.powi(-exponent)] {
        let r = moving::<T>([3.0 * scale, 4.0 * scale], [-4.0 * scale, 3.0 * scale]);
        let (v, omega) = (feedforward_speed(&r, Direction::Reverse), feedforward_yaw_rate(&r));
        // Powers of two scale without rounding: v = 5·scale and ω = (3·3 + 4·4)/25 = 1.
        let tolerance = 8.0 * real(T::default_epsilon());
        approx::assert_relative_eq!(real(v) / scale, -5.0, max_relative = tolerance);
        approx::assert_relative_eq!(real(omega.unwrap()), 1.0, max_relative = tolerance);
        let theta = real(heading(&r, Direction::Forward).unwrap());
        approx::assert_abs_diff_eq!(theta, 4.0_f64.atan2(3.0), epsilon = tolerance);
    }
}

fn extreme_speeds<T: Scalar>() {
    // 2^±664 ≈ 1e±200 at f64, 2^±100 ≈ 1e±30 at f32.
    let widest = real(T::max_value().unwrap()).log2();
    the_range_of_the_scalar_does_not_matter::<T>(if widest > 200.0 { 664 } else { 100 });
}

at_f32_and_f64! {
    a_circle_asks_for_its_speed_its_rate_and_the_tangent => circles_ask_for_their_speed_and_rate,
    the_heading_goes_on_turn_after_turn_both_ways => unwraps_turn_after_turn,
    the_yaw_rate_of_a_figure_eight_integrates_to_its_heading => the_yaw_rate_integrates_to_the_heading,
    tiny_and_huge_speeds_have_the_same_heading_and_rate => extreme_speeds,
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn forward_and_reverse_differ_by_half_a_turn_and_the_sign_of_the_speed(
        v in prop::array::uniform2(-9.0..9.0_f64), a in prop::array::uniform2(-9.0..9.0_f64),
    ) {
        let r = moving::<f64>(v, a);
        let [forward, reverse] = BOTH.map(|direction| heading(&r, direction).unwrap());
        prop_assert_eq!(reverse, forward + PI);
        prop_assert!((-PI..=PI).contains(&forward));
        prop_assert_eq!(
            feedforward_speed(&r, Direction::Forward), -feedforward_speed(&r, Direction::Reverse),
        );
    }

    /// The formula of the paper, where its squares are in range.
    #[test]
    fn the_yaw_rate_is_the_cross_product_over_the_squared_speed(
        v in prop::array::uniform2(-9.0..9.0_f64), a in prop::array::uniform2(-9.0..9.0_f64),
    ) {
        let squared = v[0] * v[0] + v[1] * v[1];
        prop_assume!(squared > 1e-6);
        let expected = (a[1] * v[0] - a[0] * v[1]) / squared;
        let found = feedforward_yaw_rate(&moving::<f64>(v, a)).unwrap();
        // The two products may cancel: the rounding is relative to |a|·|v|/|v|².
        let scale = a[0].hypot(a[1]) / squared.sqrt();
        prop_assert!((found - expected).abs() <= 16.0 * f64::EPSILON * scale, "{found} {expected}");
    }

    #[test]
    fn a_heading_that_goes_on_from_the_robots_own_is_within_half_a_turn_of_it(
        v in prop::array::uniform2(-9.0..9.0_f64), last in -1000.0..1000.0_f64, reverse in any::<bool>(),
    ) {
        let direction = BOTH[usize::from(reverse)];
        let r = moving::<f64>(v, [0.0; 2]);
        let found = Heading::from(direction, last).unwrap().update(&r).unwrap();
        // last < 1000 and the whole turns up to it are rounded.
        let rounding = 1000.0 * 4.0 * f64::EPSILON;
        prop_assert!((found - last).abs() <= PI + rounding);
        prop_assert!(wrapped(found - heading(&r, direction).unwrap()).abs() <= rounding);
    }

    /// Whatever the numbers: an answer or a reason.
    #[test]
    fn no_reference_gives_nan(v in prop::array::uniform2(any::<f64>()), a in prop::array::uniform2(any::<f64>()), last in any::<f64>()) {
        let r = moving::<f64>(v, a);
        for result in [feedforward_yaw_rate(&r), heading(&r, Direction::Reverse)].into_iter().flatten() {
            prop_assert!(result.is_finite());
        }
        if let Ok(mut unwrapped) = Heading::from(Direction::Forward, last)
            && let Ok(theta) = unwrapped.update(&r)
        {
            prop_assert!(theta.is_finite(), "{last} {theta}");
        }
    }
}

#[test]
fn a_reference_that_stands_still_has_no_heading_and_is_named() {
    for zero in [0.0, -0.0] {
        let r = moving::<f64>([zero, zero], [1.0, 2.0]);
        let expected = Error::Singular { name: "reference speed", value: 0.0 };
        assert_eq!(feedforward_yaw_rate(&r), Err(expected));
        for direction in BOTH {
            assert_eq!(heading(&r, direction), Err(expected));
            let mut unwrapped = Heading::from(direction, 9.0).unwrap();
            let before = unwrapped;
            assert_eq!(unwrapped.update(&r), Err(expected));
            assert_eq!(unwrapped, before);
        }
    }
}

#[test]
fn what_is_not_finite_is_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for v in [[bad, 1.0], [1.0, bad], [bad, bad]] {
            let r = moving::<f64>(v, [1.0, 1.0]);
            let found = feedforward_yaw_rate(&r);
            assert!(matches!(found, Err(Error::NonFinite { name: "reference speed", .. })));
            let found = heading(&r, Direction::Forward);
            assert!(matches!(found, Err(Error::NonFinite { name: "reference speed", .. })));
        }
        for a in [[bad, 1.0], [1.0, bad]] {
            // Along the axes the infinite term meets a factor of zero.
            for v in [[1.0, 2.0], [1.0, 0.0], [0.0, 1.0]] {
                let found = feedforward_yaw_rate(&moving::<f64>(v, a));
                assert!(
                    matches!(found, Err(Error::NonFinite { name: "omega_d", .. })),
                    "{v:?} {a:?}"
                );
            }
        }
        let found = Heading::from(Direction::Forward, bad);
        assert!(matches!(found, Err(Error::NonFinite { name: "heading", .. })));
    }
}
