use approx::{assert_abs_diff_eq, assert_relative_eq};
use brunovsky::{
    Error, Scalar,
    fuzzy::{FuzzyNetwork, Gaussian},
    integrators::{Integrator, Rk4},
    learning::{Antecedents, Fixed, Flow, SlidingMode},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{Learner, NOT_FINITE, cases, real, rng, ulps};

in_both_precisions! {
    every_squared_distance_moves_by_twice_the_travel,
    the_firing_strengths_do_not_change_while_input_and_memberships_move,
    the_flow_stops_at_both_bounds_and_comes_back,
    memberships_beyond_the_ceiling_stay_until_the_flow_leads_back,
    the_flow_stops_before_the_distance_leaves_the_range,
    no_flow_makes_a_membership_function_that_is_none,
    an_input_on_a_centre_holds_its_distances_and_only_travels,
    an_input_near_a_centre_holds_below_the_floor,
    what_is_learned_elsewhere_is_seen_where_the_network_travels,
    fixed_memberships_stay_bit_for_bit,
    bounds_out_of_order_or_range_are_refused,
}

/// Far beyond every reach used here, so ς = ±1.
const FULL: f64 = 1e9;

/// α = 1, so that the travel τ of a period is its length; both inputs at zero, M² from 0.25 to 5.0625.
fn learner<T: Scalar, A: Antecedents<FuzzyNetwork<T, 2, 3>>>(
    antecedents: A,
) -> Learner<T, 2, 3, A> {
    let rows = [[(-1.5, 1.0), (-0.5, 1.0), (2.25, 1.0)], [(-1.0, 0.5), (0.75, 0.5), (3.0, 2.0)]];
    let memberships =
        rows.map(|row| row.map(|(c, width)| Gaussian::new(real(c), real(width)).unwrap()));
    let rule = SlidingMode::new(T::one()).unwrap().with_antecedents(antecedents);
    Learner { network: FuzzyNetwork::new(memberships), rule }
}

fn bounds<T: Scalar>(floor: f64, ceiling: f64) -> Flow<T> {
    Flow::new(real(floor), real(ceiling)).unwrap()
}

/// M·Ṁ = ας integrated over a period.
fn every_squared_distance_moves_by_twice_the_travel<T: Scalar>() {
    proptest!(cases(500), |(s in -1.0..1.0_f64, dt in 0.001..0.1_f64, e1 in -9.0..9.0_f64, e2 in -9.0..9.0_f64)| {
        let mut learner = learner::<T, _>(Flow::default());
        learner.step(SVector::zeros(), T::zero(), T::one());
        let before = learner.squares();
        // The set-valued sign of s = ςαh is ς.
        let travel = real::<T>(s * dt);
        learner.step(SVector::from([e1, e2].map(real)), travel, real(dt));
        for (before, after) in before.as_flattened().iter().zip(learner.squares().as_flattened()) {
            assert_abs_diff_eq!(*after, *before + travel * real(2.0), epsilon = ulps(32.0));
        }
    });
}

/// One number stands for the flow of an input, and no difference of M² ever sees it: the strengths are the same bits.
fn the_firing_strengths_do_not_change_while_input_and_memberships_move<T: Scalar>() {
    let mut learner = learner::<T, _>(bounds(0.0625, 9.0));
    learner.step(SVector::zeros(), T::zero(), T::one());
    let (before, mut rng) = (learner.strengths(), rng());
    for _ in 0..10_000 {
        let e = [rng.random_range(-1e3..1e3), rng.random_range(-1e-3..1e-3)].map(real);
        let dt = rng.random_range(0.001..0.1);
        learner.step(SVector::from(e), real(rng.random_range(-dt..dt)), real(dt));
        assert_eq!(learner.strengths(), before);
    }
}

fn the_flow_stops_at_both_bounds_and_comes_back<T: Scalar>() {
    let (floor, ceiling) = (0.01, 100.0);
    let mut learner = learner::<T, _>(Flow::default());
    learner.step(SVector::zeros(), T::zero(), T::one());
    let (strengths, before) = (learner.strengths(), learner.squares());
    let extreme = |squares: [T; 3]| {
        (squares.into_iter().reduce(T::min).unwrap(), squares.into_iter().reduce(T::max).unwrap())
    };
    let mut u_n = T::zero();
    for leg in 0..20_u32 {
        let down = leg % 2 == 0;
        for k in 0..1000_u32 {
            let e = SVector::from([f64::from(k).sin(), f64::from(k)].map(real));
            // Each leg is 125 long, and M² has less than 100 to go, at twice the pace.
            u_n = learner.step(e, real(if down { -FULL } else { FULL }), real(0.125));
            for square in learner.squares().as_flattened() {
                assert!(
                    *square >= real::<T>(floor) - ulps(64.0)
                        && *square <= real::<T>(ceiling) + ulps(6400.0)
                );
            }
        }
        // u_n goes on past the bounds: multiples of 1/8 up to 125, which w̃ weighs and adds up with some ulps of error.
        assert_abs_diff_eq!(
            u_n,
            real(if down { -125.0 } else { 0.0 }),
            epsilon = ulps(125.0 * 1000.0)
        );
        assert_eq!(learner.strengths(), strengths);
        for (squares, before) in learner.squares().into_iter().zip(before) {
            let ((low, high), (low_before, high_before)) = (extreme(squares), extreme(before));
            let (bound, found) = if down { (floor, low) } else { (ceiling, high) };
            assert_relative_eq!(
                found,
                real(bound),
                max_relative = ulps(64.0),
                epsilon = ulps(64.0)
            );
            // All by the same amount: their spread stays, up to the same rounding as above.
            assert_abs_diff_eq!(
                high - low,
                high_before - low_before,
                epsilon = ulps(141.0 * 800.0)
            );
        }
        for membership in learner.network.memberships().as_flattened() {
            assert!(
                membership.centre().is_finite()
                    && membership.width().is_finite()
                    && membership.width() > T::zero()
            );
        }
    }
}

/// M² of the first input is 0.25 to 5.0625. A ceiling of 4 below that neither pulls nor lets go farther.
fn memberships_beyond_the_ceiling_stay_until_the_flow_leads_back<T: Scalar>() {
    let mut learner = learner::<T, _>(bounds::<T>(0.1, 4.0));
    let before = learner.squares();
    learner.step(SVector::zeros(), T::zero(), T::one());
    learner.step(SVector::zeros(), real(FULL), real(0.0625));
    assert_eq!(learner.squares()[0], before[0]);
    learner.step(SVector::zeros(), real(-FULL), real(0.0625));
    for (after, before) in learner.squares()[0].iter().zip(before[0]) {
        assert_abs_diff_eq!(*after, before - real(0.125), epsilon = ulps(64.0));
    }
}

fn an_input_on_a_centre_holds_its_distances_and_only_travels<T: Scalar>() {
    let mut learner = learner::<T, _>(Flow::default());
    let strengths = learner.network.fire(&SVector::from([real(-0.5), T::zero()]));
    for (k, s) in [FULL, FULL, -FULL, FULL].into_iter().enumerate() {
        let e = SVector::from([real::<T>(k as f64 - 0.5), T::zero()]);
        let u_n = learner.step(e, real(s), real(0.125));
        let travel = [0.125, 0.25, 0.125, 0.25][k];
        assert_abs_diff_eq!(u_n, real(travel), epsilon = ulps(16.0));
        let [first, second] = learner.network.memberships();
        // −1.5, −0.5 and 2.25 have travelled k with the input; multiples of 1/4, so without rounding.
        let moved =
            [-1.5, -0.5, 2.25].map(|c| Gaussian::new(real(c + k as f64), T::one()).unwrap());
        assert_eq!(first, moved);
        // The other input is on no centre and flows.
        let m2 = second[0].distance(T::zero()).powi(2);
        assert_abs_diff_eq!(m2, real(4.0 + 2.0 * travel), epsilon = ulps(64.0));
        for (own, wanted) in learner.strengths().iter().zip(strengths.strengths().iter()) {
            assert_abs_diff_eq!(*own, *wanted, epsilon = ulps(64.0));
        }
    }
}

/// The floor is 0.01. From M² = 0.0081 the flow does not start at all; from 0.0121 it goes up freely, and down to the floor.
fn an_input_near_a_centre_holds_below_the_floor<T: Scalar>() {
    for (centre, flows) in [(0.09, false), (-0.09, false), (0.11, true), (-0.11, true)] {
        for s in [FULL, -FULL] {
            let mut learner = learner::<T, _>(Flow::default());
            let row = [centre, 1.0, -2.0].map(|c| Gaussian::new(real(c), T::one()).unwrap());
            learner.network.set_memberships([row; 2]);
            learner.step(SVector::zeros(), real(s), real(0.125));
            let rise = match (flows, s > 0.0) {
                (true, true) => 0.25,
                (true, false) => 0.01 - centre * centre,
                (false, _) => 0.0,
            };
            for (square, c) in learner.squares()[1].iter().zip([centre, 1.0, -2.0]) {
                assert_abs_diff_eq!(*square, real(c * c + rise), epsilon = ulps(16.0));
            }
            assert!(flows || learner.at_zero() == [row; 2]);
        }
    }
}

/// M² could go from 2500 down to 0.01, by which d would grow e^1250-fold; far inside the bounds, d could shrink e^−49-fold.
fn the_flow_stops_before_the_distance_leaves_the_range<T: Scalar>() {
    for (distance, s) in [(50.0, -FULL), (1e-18, FULL)] {
        let row = [[Gaussian::new(real(distance), real(distance / 50.0)).unwrap()]];
        let rule = SlidingMode::new(T::one()).unwrap().with_antecedents(bounds(0.01, 2600.0));
        let mut learner = Learner { network: FuzzyNetwork::<T, 1, 1>::new(row), rule };
        for _ in 0..1000 {
            learner.step(SVector::zeros(), real(s), real(2.0));
        }
        let [[reached]] = learner.network.memberships();
        assert!(reached.centre().is_finite() && reached.centre() > T::zero());
        assert!(reached.width().is_finite() && reached.width() > T::zero());
        assert_ne!(reached, row[0][0]);
    }
}

/// Centres stay finite, and widths finite and positive: where M² is beyond the range, or the width would be, or the floor is less than the
/// rounding of M², or input and centre are farther apart than the range reaches.
fn no_flow_makes_a_membership_function_that_is_none<T: Scalar>() {
    let most = T::max_value().unwrap();
    let power = |exponent: f64| (most.ln() * real(exponent)).exp();
    let (zero, one, end) = (T::zero(), T::one(), power(0.98));
    for (e, row, floor, ceiling, s) in [
        (zero, [(one, one), (one, power(-0.6))], real(0.01), real(100.0), -FULL),
        (zero, [(power(-0.25), power(-0.7)); 2], real(0.01), end, FULL),
        (zero, [(one, one); 2], one / end, one, -FULL),
        (zero, [(power(0.7), power(0.7)); 2], one / end, one, -FULL),
        (end, [(-end, one), (one, one)], real(0.01), real(100.0), -FULL),
        (-end, [(end, one), (end, end)], real(0.01), real(100.0), FULL),
    ] {
        let row = row.map(|(centre, width)| Gaussian::new(centre, width).unwrap());
        let flow = Flow::new(floor, ceiling).unwrap();
        let rule = SlidingMode::new(one).unwrap().with_antecedents(flow);
        let mut learner = Learner { network: FuzzyNetwork::<T, 1, 2>::new([row]), rule };
        for _ in 0..1000 {
            learner.step(SVector::from([e]), real(s), one);
        }
        for membership in learner.network.memberships().as_flattened() {
            let (centre, width) = (membership.centre(), membership.width());
            assert!(
                centre.is_finite() && width.is_finite() && width > zero,
                "{row:?} {membership:?}"
            );
        }
    }
}

/// The travelling network is an integrator, and still the network of its memberships and consequents.
fn what_is_learned_elsewhere_is_seen_where_the_network_travels<T: Scalar>() {
    let mut learner = learner::<T, _>(Flow::default());
    let e = SVector::from([0.25, -0.5].map(real));
    learner.step(e, real(0.1), real(0.1));
    let elsewhere = learner.network.fire(&SVector::from([-1.0, 0.5].map(real)));
    learner.network.move_consequents(&elsewhere, T::one());
    let mut resting = FuzzyNetwork::new(learner.network.memberships());
    resting.set_consequents(&learner.network.consequents()).unwrap();
    let u_n = learner.network.evaluate(&e).unwrap();
    assert_abs_diff_eq!(u_n, resting.evaluate(&e).unwrap(), epsilon = ulps(32.0));
}

fn fixed_memberships_stay_bit_for_bit<T: Scalar>() {
    let mut learner = learner::<T, _>(Fixed);
    let before = learner.network.memberships();
    proptest!(cases(200), |(e1 in -1e6..1e6_f64, e2 in -1.0..1.0_f64, s in -9.0..9.0_f64)| {
        let mut learner = learner;
        learner.step(SVector::from([e1, e2].map(real)), real(s), real(0.125));
        prop_assert_eq!(learner.network.memberships(), before);
    });
    learner.step(SVector::zeros(), T::one(), real(0.125));
    assert_ne!(*learner.network.consequents(), [T::zero(); 9]);
}

fn bounds_out_of_order_or_range_are_refused<T: Scalar>() {
    let attempt = |floor, ceiling| Flow::<T>::new(real(floor), real(ceiling)).unwrap_err();
    for bad in [0.0, -0.5] {
        assert_eq!(attempt(bad, 1.0), Error::NotPositive { name: "floor", value: bad });
        assert_eq!(attempt(1.0, bad), Error::NotPositive { name: "ceiling", value: bad });
    }
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad, 1.0), Error::NonFinite { name: "floor", .. }));
        assert!(matches!(attempt(1.0, bad), Error::NonFinite { name: "ceiling", .. }));
    }
    for (value, limit) in [(2.0, 1.0), (1.0, 1.0)] {
        assert_eq!(attempt(value, limit), Error::NotBelow { name: "floor", value, limit });
    }
}

/// eq_c_ik and eq_sigma_ik as they are printed, integrated over one period with e(t) = sin t: the errors against the flow fall
/// like h⁴, the order of the integrator, and end below 10⁻⁹.
#[test]
fn the_flow_is_the_solution_of_the_laws_for_centre_and_width() {
    let period = 0.2;
    for (sign, centre, width) in
        [(1.0, 1.5, 1.0), (-1.0, 1.5, 1.0), (1.0, -0.8, 0.5), (-1.0, -0.8, 0.5)]
    {
        let alpha = 2.0;
        let law = |t: f64, x: &SVector<f64, 2>| {
            let (d, sigma) = (t.sin() - x[0], x[1]);
            SVector::from([
                t.cos() + d * alpha * sign,
                -(sigma + sigma.powi(3) / (d * d)) * alpha * sign,
            ])
        };
        let mut learner = Learner {
            network: FuzzyNetwork::<f64, 1, 1>::new([[Gaussian::new(centre, width).unwrap()]]),
            rule: SlidingMode::new(alpha).unwrap(),
        };
        learner.step(SVector::zeros(), sign * FULL, period);
        learner.step(SVector::from([period.sin()]), 0.0, period);
        let [[flowed]] = learner.network.memberships();
        let wanted = SVector::from([flowed.centre(), flowed.width()]);
        let error = |steps| {
            let start = SVector::from([centre, width]);
            (Rk4.integrate(law, 0.0, &start, period, steps).unwrap() - wanted).norm()
        };
        let order = (error(16) / error(32)).log2();
        assert!((3.8..4.3).contains(&order), "order {order}");
        assert!(error(512) < 1e-9);
    }
}
