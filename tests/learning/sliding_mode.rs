use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::{FuzzyNetwork, Gaussian},
    learning::{Antecedents, Certificate, Fixed, Flow, SlidingMode, Switching},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{Learner, NOT_FINITE, cases, real, rng, ulps};

in_both_precisions! {
    the_output_follows_the_integral_of_the_sign,
    before_the_first_sample_no_membership_moves,
    between_samples_centres_travel_as_far_as_the_input,
    memberships_may_be_replaced_in_the_middle_of_a_run,
    the_consequents_of_a_network_on_the_move_never_leave_the_line_of_the_strengths,
    a_parameter_out_of_range_is_refused,
    the_certificate_is_that_of_the_parameters,
    nothing_becomes_non_finite_in_ten_million_adversarial_steps,
}

fn switchings<T: Scalar>() -> [Switching<T>; 4] {
    let delta = real(0.05);
    let bare = Switching::Implicit { delta: T::zero() };
    [Switching::Explicit { delta }, Switching::Implicit { delta }, bare, Switching::SetValued]
}

fn learner<T: Scalar>(alpha: f64, switching: Switching<T>) -> Learner<T, 2, 3> {
    Learner {
        network: FuzzyNetwork::evenly_spaced([real(1.0), real(2.0)]).unwrap(),
        rule: SlidingMode::new(real(alpha)).unwrap().with_switching(switching).unwrap(),
    }
}

/// u_n(k) = u_n(0) + Σ α·ς·h, whatever the input does. 2000 additions of at most 0.5 round by an ulp of |u_n| < 64 each, in
/// random directions; in `f64` the tolerance is 6·10⁻¹², in `f32` it is 0.003. The firing strengths add their own random walk.
fn the_output_follows_the_integral_of_the_sign<T: Scalar>() {
    for switching in switchings::<T>() {
        let (mut learner, mut rng) = (learner(5.0, switching), rng());
        learner
            .network
            .set_consequents(&[1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0].map(real))
            .unwrap();
        let mut wanted = learner.network.evaluate(&SVector::from([real(0.3), real(0.1)])).unwrap();
        for k in 0..2000 {
            let e = if k == 0 {
                [0.3, 0.1]
            } else {
                [rng.random_range(-9.0..9.0), rng.random_range(-1e3..1e3)]
            };
            let (s, dt) =
                (real::<T>(rng.random_range(-2.0..2.0)), real::<T>(rng.random_range(0.001..0.1)));
            let reach = dt * real(5.0);
            wanted += reach * switching.sign(s, reach);
            let u_n = learner.step(SVector::from(e.map(real)), s, dt);
            assert_abs_diff_eq!(u_n, wanted, epsilon = ulps(64.0 * 400.0));
        }
    }
}

/// Multiples of 1/8 below 2¹¹ differ without rounding.
fn before_the_first_sample_no_membership_moves<T: Scalar>() {
    proptest!(cases(200), |(e1 in -8000..8000_i32, e2 in -8000..8000_i32)| {
        let mut learner = learner::<T>(5.0, Switching::SetValued);
        let before = learner.network.memberships();
        learner.step(SVector::from([e1, e2].map(|e| real(f64::from(e) / 8.0))), T::zero(), T::one());
        prop_assert_eq!(learner.network.memberships(), before);
    });
}

fn between_samples_centres_travel_as_far_as_the_input<T: Scalar>() {
    proptest!(cases(200), |(e1 in -800..800_i32, e2 in -800..800_i32, d1 in -800..800_i32, d2 in -800..800_i32)| {
        let mut learner = learner::<T>(5.0, Switching::SetValued);
        let eighths = |e: [i32; 2]| e.map(|e| real::<T>(f64::from(e) / 8.0));
        let (from, by) = (eighths([e1, e2]), eighths([d1, d2]));
        let before = learner.network.memberships();
        learner.step(from.into(), T::zero(), T::one());
        learner.step([from[0] + by[0], from[1] + by[1]].into(), T::zero(), T::one());
        for i in 0..2 {
            let moved = before[i].map(|m| Gaussian::new(m.centre() + by[i], m.width()).unwrap());
            // s = 0 flows by τ = 0, which may still round a width that has been divided and multiplied again.
            for (own, wanted) in learner.network.memberships()[i].iter().zip(moved) {
                prop_assert_eq!(own.centre(), wanted.centre());
                assert_abs_diff_eq!(own.width(), wanted.width(), epsilon = ulps(4.0));
            }
        }
    });
}

fn memberships_may_be_replaced_in_the_middle_of_a_run<T: Scalar>() {
    let mut learner = learner::<T>(1.0, Switching::SetValued);
    let (here, away) =
        (SVector::from([6.5, -3.25].map(real)), SVector::from([-2.5, 40.25].map(real)));
    learner.step(SVector::zeros(), T::one(), real(0.25));
    learner.step(here, T::one(), real(0.25));
    let rows = [[5.0, 6.0, 7.25], [-4.0, -3.0, -2.0]];
    let replaced = rows.map(|row| row.map(|c| Gaussian::new(real(c), real(0.75)).unwrap()));
    learner.network.set_memberships(replaced);
    assert_eq!(learner.network.memberships(), replaced);
    let fresh = FuzzyNetwork::<T, 2, 3>::new(replaced).fire(&here);
    let before = learner.network.output(&fresh);
    assert_eq!(learner.network.fire(&here), fresh);
    // From here on the new firing strengths stay and the integral goes on.
    for (k, e) in [here, away, here, away].into_iter().enumerate() {
        let u_n = learner.step(e, -T::one(), real(0.25));
        assert_abs_diff_eq!(u_n, before - real(0.25 * (k + 1) as f64), epsilon = ulps(64.0));
        for (own, wanted) in learner.strengths().iter().zip(fresh.strengths().iter()) {
            assert_abs_diff_eq!(*own, *wanted, epsilon = ulps(64.0));
        }
    }
}

/// f = c·w̃ after any number of steps, each f_r with its own rounding and no more. Steps of ±αh and of less, as noise has them, around an
/// output of −5: were they added up one by one, f would go astray by an ulp of it every few hundred steps.
fn the_consequents_of_a_network_on_the_move_never_leave_the_line_of_the_strengths<T: Scalar>() {
    let (mut learner, mut rng) = (learner(5.0, Switching::SetValued), rng());
    let e = SVector::from([real::<T>(0.3), real(0.1)]);
    let mut u_n = T::zero();
    for _ in 0..100_000 {
        let s = real::<T>(rng.random_range(-0.1..0.1)) - (u_n + real(5.0));
        u_n = learner.step(e, s, real(0.01));
    }
    assert!((u_n + real(5.0)).abs() < real(0.2));
    let strengths = learner.strengths();
    let along = u_n / learner.network.fire(&e).norm_squared();
    for (f, w) in learner.network.consequents().iter().zip(strengths) {
        // u_n sums up nine products.
        assert_abs_diff_eq!(*f, along * w, epsilon = ulps::<T>(16.0) * f.abs());
    }
}

fn a_parameter_out_of_range_is_refused<T: Scalar>() {
    let rule = SlidingMode::new(T::one()).unwrap();
    let explicit = |delta| rule.with_switching(Switching::Explicit { delta: real(delta) });
    let implicit = |delta| rule.with_switching(Switching::Implicit { delta: real(delta) });
    for bad in [0.0, -1.0] {
        assert_eq!(
            SlidingMode::<T>::new(real(bad)).unwrap_err(),
            Error::NotPositive { name: "alpha", value: bad }
        );
        assert_eq!(explicit(bad).unwrap_err(), Error::NotPositive { name: "delta", value: bad });
    }
    assert!(implicit(0.0).is_ok());
    assert_eq!(implicit(-1.0).unwrap_err(), Error::Negative { name: "delta", value: -1.0 });
    for bad in NOT_FINITE {
        assert!(matches!(
            SlidingMode::<T>::new(real(bad)).unwrap_err(),
            Error::NonFinite { name: "alpha", .. }
        ));
        assert!(matches!(explicit(bad).unwrap_err(), Error::NonFinite { name: "delta", .. }));
        assert!(matches!(implicit(bad).unwrap_err(), Error::NonFinite { name: "delta", .. }));
    }
}

fn the_certificate_is_that_of_the_parameters<T: Scalar>() {
    let (alpha, dt, bound) = (real(25.0), real(0.01), real(5.0));
    assert_eq!(
        SlidingMode::new(alpha).unwrap().certificate(dt, bound),
        Certificate::new(alpha, Switching::SetValued, dt, bound)
    );
    for switching in switchings::<T>() {
        let rule = SlidingMode::new(alpha).unwrap().with_switching(switching).unwrap();
        assert_eq!(rule.certificate(dt, bound), Certificate::new(alpha, switching, dt, bound));
        assert!(matches!(rule.certificate(dt, real(-5.0)), Err(Error::Negative { .. })));
    }
}

/// Inputs from far jumps to rest on a centre, s of every size the scalar has, and long runs of one sign that drive the flow
/// against both of its bounds. Now and then the memberships are put back around the input, or one of them on it. An eighth of
/// the ten million steps for each switching, with flow and with fixed antecedents.
fn nothing_becomes_non_finite_in_ten_million_adversarial_steps<T: Scalar>() {
    for switching in switchings::<T>() {
        let (floors, ceilings) = attacked(switching, Flow::default());
        assert!(floors > 500 && ceilings > 500, "{floors}, {ceilings}");
        attacked(switching, Fixed);
    }
}

/// A share of them, and how often an M² was found at the floor and at the ceiling of the flow.
fn attacked<T: Scalar, A: Antecedents<FuzzyNetwork<T, 2, 3>> + Copy>(
    switching: Switching<T>,
    antecedents: A,
) -> (i32, i32) {
    let (floor, ceiling) = (real::<T>(0.01), real::<T>(100.0));
    let margin = |square: T| square * ulps(64.0);
    let Learner { network, rule } = learner::<T>(25.0, switching);
    let mut learner = Learner { network, rule: rule.with_antecedents(antecedents) };
    let (mut rng, mut floors, mut ceilings) = (rng(), 0, 0);
    let (mut e, mut one_sign) = (SVector::<T, 2>::zeros(), 1.0);
    for k in 0..1_250_000_u32 {
        match rng.random_range(0..8_u32) {
            0 => e = SVector::from([0, 1].map(|_| real(rng.random_range(-1e6..1e6)))),
            1 => e = SVector::zeros(),
            _ => {}
        }
        if k % 2000 == 0 {
            one_sign = -one_sign;
        }
        if k % 50_000 == 0 {
            let on_a_centre = if k % 200_000 == 0 { 0.0 } else { 0.75 };
            let offsets = [-2.0, on_a_centre, 3.0].map(real::<T>);
            let row = offsets.map(|offset| Gaussian::new(offset, T::one()).unwrap());
            learner.step(SVector::zeros(), T::zero(), real(0.01));
            learner.network.set_memberships([row; 2]);
        }
        let size = 10.0_f64.powi(rng.random_range(-30..31));
        let structured = k / 100_000 % 2 == 0;
        let s = if structured || rng.random() { one_sign * size } else { -one_sign * size };
        let u_n = learner.step(e, real(s), real(0.01));
        assert!(u_n.is_finite());
        if k % 100 == 0 {
            let memberships = learner.network.memberships();
            for m in memberships.as_flattened() {
                assert!(m.centre().is_finite() && m.width().is_finite() && m.width() > T::zero());
            }
            let firing = learner.network.fire(&e);
            assert!(
                firing.norm_squared() > T::zero()
                    && firing.strengths().iter().all(|w| w.is_finite())
            );
            let squares = learner.squares()[0];
            floors += i32::from(squares.iter().any(|m2| *m2 <= floor + margin(floor)));
            ceilings += i32::from(squares.iter().any(|m2| *m2 >= ceiling - margin(ceiling)));
        }
    }
    (floors, ceilings)
}
