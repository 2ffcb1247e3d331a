//! What holds for every trajectory: derivative k + 1 is the rate of derivative k. A new trajectory is one more line in a list.

use brunovsky::{
    Scalar,
    trajectory::{
        Boundary, Circle, ConstantSpeed, FigureEight, Line, MinimumJerk, Quintic, Trajectory,
    },
};
use nalgebra::SVector;
use num_dual::Dual64;
use proptest::prelude::*;

use crate::support::{NOT_FINITE, WINDING, assert_equal_to_rounding, cases, num, nums, order};

const TIMES: [f64; 6] = [-0.5, 0.25, 1.5, 2.0, 3.5, 4.5];

fn line<T: Scalar>() -> Line<T, 2> {
    Line::new([1.0, -2.0].map(num), [0.3, 0.7].map(num)).unwrap()
}

fn circle<T: Scalar>() -> Circle<T> {
    Circle::new([1.0, -2.0].map(num), num(1.5), num(-0.75), num(0.5)).unwrap()
}

fn figure_eight<T: Scalar>() -> FigureEight<T> {
    FigureEight::new(num(2.0), num(0.5), num(0.75)).unwrap()
}

fn quintic<T: Scalar>() -> Quintic<T, 2> {
    let [p, v, a, q, w, b] =
        [[1.0, 2.0], [-1.0, 0.5], [0.25, 1.0], [2.0, -1.0], [0.5, 1.5], [-0.5, 0.75]]
            .map(|entries: [f64; 2]| entries.map(num));
    Quintic::new(Boundary::new(p, v, a), Boundary::new(q, w, b), num(2.5)).unwrap()
}

fn minimum_jerk<T: Scalar>() -> MinimumJerk<T, 2, 6> {
    MinimumJerk::new(nums(WINDING), TIMES.map(num)).unwrap()
}

fn constant_speed<T: Scalar>() -> ConstantSpeed<T, 2, 6> {
    ConstantSpeed::new(nums(WINDING), num(2.5)).unwrap()
}

/// A dual number t + ε carries derivative k to derivative k + 1 without truncation: r⁽ᵏ⁾(t + ε) = r⁽ᵏ⁾(t) + ε·r⁽ᵏ⁺¹⁾(t).
fn dual_numbers_agree(trajectory: &impl Trajectory<2, Scalar = Dual64>, t: f64) {
    let jet = trajectory.jet::<6>(Dual64::new(t, 1.0));
    for pair in jet.windows(2) {
        let (rate, next) = (pair[0].map(|x| x.eps), pair[1].map(|x| x.re));
        assert_equal_to_rounding(rate, next, 1e4);
    }
}

/// Central differences of derivative k miss derivative k + 1 by h²/6·r⁽ᵏ⁺³⁾.
fn differences_agree(trajectory: &impl Trajectory<2, Scalar = f64>, t: f64) {
    let jet = trajectory.jet::<6>(t);
    let error = |k: usize, h: f64| {
        let [before, after] = [t - h, t + h].map(|t| trajectory.jet::<6>(t)[k]);
        ((after - before) / (2.0 * h) - jet[k + 1]).norm()
    };
    for k in 0..5 {
        let (coarse, fine) = (error(k, 0.02), error(k, 0.01));
        // Below this the derivative k + 3 vanishes, or nearly, and what is left are roundings (of 1e-15·100/h) and h⁴.
        if fine > 1e-6 {
            let measured = order(coarse, fine);
            assert!((measured - 2.0).abs() < 0.1, "derivative {k}: order {measured}");
        } else {
            assert!(coarse < 1e-5);
        }
    }
}

fn all_ways_to_ask_agree<R: Trajectory<2>>(trajectory: &R, t: f64) {
    let t = num(t);
    let jet = trajectory.jet::<4>(t);
    assert_eq!(trajectory.position(t), jet[0]);
    let references = trajectory.references::<3>(t);
    for (dimension, reference) in references.iter().enumerate() {
        assert_eq!(reference.r, SVector::from([0, 1, 2].map(|k| jet[k][dimension])));
        assert_eq!(reference.r_n_dot, jet[3][dimension]);
    }
    assert_eq!(trajectory.references::<1>(t)[1].r_n_dot, jet[1][1]);
    // Behind a reference, and behind one whose type is not known, it is the same curve.
    let erased: &dyn Trajectory<2, Scalar = R::Scalar> = &trajectory;
    assert_eq!((&erased).jet::<4>(t), jet);
}

fn nothing_at_no_time(trajectory: &impl Trajectory<2, Scalar = f64>) {
    for t in NOT_FINITE {
        assert!(trajectory.position(t).iter().all(|x| !x.is_finite()), "{t}");
    }
}

/// Derivatives grow with their order, and so does what rounding the parameters does to them.
fn precisions_agree(
    single: &impl Trajectory<2, Scalar = f32>,
    double: &impl Trajectory<2, Scalar = f64>,
    t: f32,
) {
    let (single, double) = (single.jet::<5>(t), double.jet::<5>(t.into()));
    let scale = double.iter().fold(1.0, |scale: f64, derivative| scale.max(derivative.amax()));
    for (single, double) in single.into_iter().zip(double) {
        let difference = (single.map(f64::from) - double).amax();
        assert!(difference <= 1e3 * f64::from(f32::EPSILON) * scale, "{difference} of {scale}");
    }
}

/// The tests of one trajectory, a function generic over the scalar, for times in a range where it is smooth.
macro_rules! trajectories {
    ($($name:ident in $times:expr),+ $(,)?) => {
        $(mod $name {
            use super::*;

            #[test]
            fn an_infinite_time_has_no_position() {
                nothing_at_no_time(&$name::<f64>());
            }

            #[test]
            fn behind_a_reference_it_has_the_same_limits() {
                let trajectory = $name::<f64>();
                let erased: &dyn Trajectory<2, Scalar = f64> = &&trajectory;
                assert_eq!(erased.limits(0.5, 1.5), trajectory.limits(0.5, 1.5));
                assert!(trajectory.limits(0.5, 1.5).unwrap().speed > 0.0);
            }

            proptest! {
                #![proptest_config(cases(200))]

                #[test]
                fn each_derivative_is_the_rate_of_the_one_before(t in $times) {
                    dual_numbers_agree(&$name(), t);
                }

                #[test]
                fn differences_converge_to_the_derivative_with_order_two(t in $times) {
                    differences_agree(&$name(), t);
                }

                #[test]
                fn positions_jets_and_references_agree(t in $times) {
                    all_ways_to_ask_agree(&$name::<f64>(), t);
                    all_ways_to_ask_agree(&$name::<f32>(), t);
                }

                #[test]
                fn both_precisions_agree(t in $times) {
                    precisions_agree(&$name(), &$name(), t as f32);
                }
            }
        })+
    };
}

trajectories! {
    line in -3.0..3.0_f64,
    circle in -3.0..3.0_f64,
    figure_eight in -3.0..3.0_f64,
    quintic in 0.05..2.45_f64,
    minimum_jerk in 0.3..1.45_f64,
    constant_speed in 0.1..0.7_f64,
}
