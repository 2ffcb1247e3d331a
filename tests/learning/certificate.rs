use approx::{assert_abs_diff_eq, assert_relative_eq};
use brunovsky::{
    Error, Scalar,
    integrators::{Integrator, Rk4},
    learning::{Certificate, Switching},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{
    ALPHA, DISTURBANCES, NOT_FINITE, PERIOD, REACH, SWITCHINGS, cases, real, sign_by_definition,
    trajectory, ulps,
};

in_both_precisions! {
    the_numbers_of_the_paper_come_out,
    nothing_is_promised_unless_learning_is_faster_than_the_uncertainty,
    the_boundary_layer_residual_is_where_learning_and_uncertainty_balance,
    the_tracking_bound_divides_by_the_steady_state_gain,
    the_set_valued_sign_has_no_boundary_layer,
    a_parameter_out_of_range_is_refused,
    what_parameters_in_range_make_out_of_range_is_refused,
}

fn certificate<T: Scalar>(switching: Switching<T>, bound: f64) -> Certificate<T> {
    Certificate::new(real(ALPHA), switching, real(PERIOD), real(bound)).unwrap()
}

/// Simulation: t_h = 90/(25 − 5) and αh/δ = 25·0.01/0.05. Robot: 5·0.2/0.05.
fn the_numbers_of_the_paper_come_out<T: Scalar>() {
    let simulation = certificate::<T>(Switching::Explicit { delta: real(0.05) }, 5.0);
    assert_relative_eq!(
        simulation.reaching_time(real(-90.0)).unwrap().unwrap(),
        real(4.5),
        max_relative = ulps(4.0)
    );
    assert_relative_eq!(simulation.step_ratio(), real(5.0), max_relative = ulps(4.0));
    assert_abs_diff_eq!(simulation.chattering_amplitude(), real(0.125 - 0.05), epsilon = ulps(1.0));
    assert!(simulation.holds() && simulation.explicit_chatters());
    let delta = real(0.05);
    let robot =
        Certificate::new(real::<T>(5.0), Switching::Implicit { delta }, real(0.2), real(0.1))
            .unwrap();
    assert_relative_eq!(robot.step_ratio(), real(20.0), max_relative = ulps(4.0));
}

fn nothing_is_promised_unless_learning_is_faster_than_the_uncertainty<T: Scalar>() {
    let delta = real(0.05);
    for switching in
        [Switching::Explicit { delta }, Switching::Implicit { delta }, Switching::SetValued]
    {
        for (bound, holds) in
            [(0.0, true), (24.0, true), (25.0, false), (26.0, false), (1e30, false)]
        {
            let certificate = certificate::<T>(switching, bound);
            assert_eq!(certificate.holds(), holds);
            let promises = [
                certificate.reaching_time(T::one()).unwrap(),
                certificate.boundary_layer_residual(),
                certificate.residual(),
                certificate.recovery_time(T::one(), T::one()).unwrap(),
                certificate.tracking_bound(T::one(), 3).unwrap(),
            ];
            assert!(promises.iter().all(|promise| promise.is_some() == holds));
        }
    }
}

/// α·r/(r + δ) = B.
fn the_boundary_layer_residual_is_where_learning_and_uncertainty_balance<T: Scalar>() {
    proptest!(cases(500), |(delta in 0.001..10.0_f64, bound in 0.0..24.9_f64)| {
        let delta = real::<T>(delta);
        for switching in [Switching::Explicit { delta }, Switching::Implicit { delta }] {
            let residual = certificate(switching, bound).boundary_layer_residual().unwrap();
            // The quotient rounds α − B ≥ 0.1 by some ulps of 25; balance forgives what is relative in r.
            assert_abs_diff_eq!(real::<T>(ALPHA) * residual / (residual + delta), real(bound), epsilon = ulps(25.0 * 8.0));
        }
    });
}

fn the_tracking_bound_divides_by_the_steady_state_gain<T: Scalar>() {
    let certificate = certificate::<T>(Switching::SetValued, 5.0);
    let residual = certificate.residual().unwrap();
    for (order, divisor) in [(1, 3.0), (2, 9.0), (3, 27.0)] {
        let bound = certificate.tracking_bound(real(3.0), order).unwrap().unwrap();
        assert_relative_eq!(bound * real(divisor), residual, max_relative = ulps(4.0));
    }
}

fn the_set_valued_sign_has_no_boundary_layer<T: Scalar>() {
    for switching in [Switching::SetValued, Switching::Implicit { delta: T::zero() }] {
        let certificate = certificate::<T>(switching, 5.0);
        assert!(!certificate.step_ratio().is_finite() && certificate.step_ratio() > T::zero());
        assert_eq!(certificate.boundary_layer_residual(), Some(T::zero()));
        assert_eq!(certificate.residual(), Some(real::<T>(5.0) * real(PERIOD)));
    }
}

fn a_parameter_out_of_range_is_refused<T: Scalar>() {
    let attempt = |parameters: [f64; 4]| {
        let [alpha, delta, dt, bound] = parameters.map(real::<T>);
        Certificate::new(alpha, Switching::Implicit { delta }, dt, bound)
    };
    let names = ["alpha", "delta", "dt", "bound on the rate of the uncertainty"];
    for (i, expected) in names.into_iter().enumerate() {
        let with = |bad: f64| core::array::from_fn(|j| if i == j { bad } else { 1.0 });
        for bad in NOT_FINITE {
            assert!(
                matches!(attempt(with(bad)), Err(Error::NonFinite { name, .. }) if name == expected)
            );
        }
        match (i % 2 == 0, attempt(with(0.0)), attempt(with(-1.0))) {
            (
                true,
                Err(Error::NotPositive { name, .. }),
                Err(Error::NotPositive { name: again, .. }),
            ) => {
                assert_eq!((name, again), (expected, expected));
            }
            (false, Ok(_), Err(Error::Negative { name, .. })) => assert_eq!(name, expected),
            other => panic!("{expected}: {other:?}"),
        }
    }
    let explicit =
        Certificate::new(T::one(), Switching::Explicit { delta: T::zero() }, T::one(), T::zero());
    assert_eq!(explicit.unwrap_err(), Error::NotPositive { name: "delta", value: 0.0 });
}

/// αh would be infinite or 0, B·h and the residual δB/(α − B) infinite: what a monitor carries along would be NaN.
fn what_parameters_in_range_make_out_of_range_is_refused<T: Scalar>() {
    let most = T::max_value().unwrap();
    let (big, small, one) = (most.sqrt() * real(4.0), real::<T>(0.25) / most.sqrt(), T::one());
    let small = small * T::default_epsilon();
    let implicit = |delta| Switching::Implicit { delta };
    for (alpha, delta, dt, bound, expected) in [
        (big, one, big, one, "alpha*dt"),
        (small, one, small, T::zero(), "alpha*dt"),
        (one, one, big, big, "bound*dt"),
        (real(4.0), most, one, real(3.0), "residual"),
    ] {
        match Certificate::new(alpha, implicit(delta), dt, bound) {
            Err(Error::NonFinite { name, .. } | Error::NotPositive { name, .. }) => {
                assert_eq!(name, expected);
            }
            other => panic!("{expected}: {other:?}"),
        }
    }
    let certificate = Certificate::new(one, implicit(one), one, real(0.5)).unwrap();
    let time = certificate.reaching_time(most);
    assert!(matches!(time, Err(Error::NonFinite { name: "reaching time", .. })));
    let bound = certificate.tracking_bound(small, 3);
    assert!(matches!(bound, Err(Error::NonFinite { name: "tracking bound", .. })));
}

/// The adversary moves Δ as it likes within its bound; once transients have died out, |s| is below the residual, to rounding.
/// For B = 24 the approach is slowest: 1 − (1 − B/α)²·αh/δ = 0.9992 a step for δ = 0.5, so 40000 steps leave e⁻³² of it.
#[test]
fn no_lawful_uncertainty_leaves_more_than_the_residual() {
    for switching in SWITCHINGS {
        for bound in [0.0, 5.0, 24.0] {
            let residual = certificate(switching, bound).residual().unwrap();
            for (kind, s0) in (0..DISTURBANCES).flat_map(|kind| [(kind, 12.0), (kind, -0.3)]) {
                let tail =
                    trajectory(switching, s0, bound * PERIOD, kind, 41_000, |_| 0.0).skip(40_000);
                let left = tail.fold(0.0, |left: f64, s| left.max(s.abs()));
                assert!(
                    left <= residual * (1.0 + 1e-9) + 1e-12,
                    "{switching:?}, B = {bound}, {kind}: {left} > {residual}"
                );
            }
        }
    }
}

/// An uncertainty at the constant rate B ends exactly there, so no smaller residual could be promised of the implicit signs.
#[test]
fn the_residual_of_the_implicit_signs_is_attained() {
    for switching in
        SWITCHINGS.into_iter().filter(|switching| !matches!(switching, Switching::Explicit { .. }))
    {
        for (bound, kind) in [(0.0, 0), (5.0, 0), (5.0, 1), (24.0, 0), (24.0, 1)] {
            let end =
                trajectory(switching, 1.0, bound * PERIOD, kind, 41_000, |_| 0.0).last().unwrap();
            let residual = certificate(switching, bound).residual().unwrap();
            assert_abs_diff_eq!(end.abs(), residual, epsilon = 1e-9);
        }
    }
}

/// The explicit sign attains it where chattering is the larger part: s = √(αhδ) − δ, which lies inside, is thrown the farthest.
#[test]
fn the_residual_of_a_chattering_explicit_sign_is_attained() {
    for switching in &SWITCHINGS[..2] {
        let residual = certificate(*switching, 5.0).residual().unwrap();
        let worst = (REACH * switching.delta()).sqrt() - switching.delta();
        assert!(worst < residual);
        let next = worst - REACH * sign_by_definition(*switching, worst, REACH) - 5.0 * PERIOD;
        assert_abs_diff_eq!(next, -residual, epsilon = 1e-15);
    }
}

/// Each sample takes off (α − B)·h at the least until less than αh is left, and then all but B·h.
#[test]
fn the_sampled_loop_reaches_the_residual_in_the_reaching_time() {
    proptest!(cases(100), |(s0 in -50.0..50.0_f64, bound in 0.0..20.0_f64, kind in 0..DISTURBANCES)| {
        let certificate = certificate(Switching::SetValued, bound);
        let samples = (certificate.reaching_time(s0).unwrap().unwrap() / PERIOD).ceil() as usize + 1;
        let later = trajectory(Switching::SetValued, s0, bound * PERIOD, kind, samples as u32 + 50, |_| 0.0).skip(samples);
        let left = later.fold(0.0, |left: f64, s| left.max(s.abs()));
        prop_assert!(left <= certificate.residual().unwrap() + 1e-12);
    });
}

/// A jump of Δ in the worst of directions, from the residual: after the recovery time |s| is within ε of the residual again, whatever Δ does.
#[test]
fn a_jump_has_left_no_more_than_was_asked_for_after_the_recovery_time() {
    for (switching, bound) in SWITCHINGS.into_iter().flat_map(|s| [(s, 0.0), (s, 5.0), (s, 20.0)]) {
        let certificate = certificate(switching, bound);
        let residual = certificate.residual().unwrap();
        for (jump, within) in [(0.01, 1e-3), (8.0, 0.1), (8.0, 1e-6), (0.1, 1.0)] {
            let time = certificate.recovery_time(jump, within).unwrap().unwrap();
            let samples = (time / PERIOD).floor() as usize;
            for kind in 0..DISTURBANCES {
                let s = trajectory(switching, residual + jump, bound * PERIOD, kind, 3000, |_| 0.0);
                let left = s.skip(samples).fold(0.0, |left: f64, s| left.max(s.abs()));
                assert!(left <= residual + within + 1e-12, "{switching:?}, B = {bound}, {kind}");
            }
        }
    }
    for (jump, within, name) in [(0.0, 1.0, "jump"), (1.0, 0.0, "within")] {
        let refused = certificate(Switching::SetValued, 5.0).recovery_time(jump, within);
        assert_eq!(refused, Err(Error::NotPositive { name, value: 0.0 }));
    }
}

/// Below the ratio of two a simulated explicit step dies out, above it |s| settles at the amplitude.
#[test]
fn the_chattering_amplitude_is_that_of_a_simulated_loop() {
    for delta in [0.01, 0.05, 0.1, 0.12, 0.13, 0.2, 1.0] {
        let switching = Switching::Explicit { delta };
        let certificate = certificate(switching, 0.0);
        let end = trajectory(switching, 0.3, 0.0, 0, 4000, |_| 0.0).last().unwrap();
        assert_abs_diff_eq!(end.abs(), certificate.chattering_amplitude(), epsilon = 1e-12);
        assert_eq!(certificate.explicit_chatters(), delta < 0.125);
    }
    // At the ratio of two exactly the cycle has shrunk to nothing.
    assert_eq!(
        certificate(Switching::Explicit { delta: REACH / 2.0 }, 0.0).chattering_amplitude(),
        0.0
    );
}

/// e₁ of s = (d/dt + λ)ⁿe₁ under a constant |s| ends at the bound, and under any other it stays below.
fn tracked<const N: usize>(bound: f64, residual: f64, lambda: f64) {
    let peak = |s: &dyn Fn(f64) -> f64| {
        let lags = |t: f64, y: &SVector<f64, N>| {
            SVector::from_fn(|i, _| if i == 0 { s(t) } else { y[i - 1] } - lambda * y[i])
        };
        let (mut y, mut peak, h) = (SVector::zeros(), 0.0_f64, 0.005);
        for k in 0..4000 {
            y = Rk4.step(lags, f64::from(k) * h, &y, h);
            peak = peak.max(y[N - 1].abs());
        }
        peak
    };
    // e^(−λt) with λt = 60 and a polynomial of degree N − 1 is below rounding.
    assert_relative_eq!(peak(&|_| residual), bound, max_relative = 1e-12);
    for omega in [0.3, 3.0, 30.0] {
        assert!(peak(&|t: f64| residual * (omega * t).sin()) < bound);
        assert!(peak(&|t: f64| residual * (omega * t).sin().signum()) <= bound * (1.0 + 1e-12));
    }
}

#[test]
fn the_tracking_error_of_a_bounded_s_stays_within_the_bound() {
    let (certificate, lambda) = (certificate(Switching::SetValued, 5.0), 3.0);
    let (residual, bound) = (certificate.residual().unwrap(), |order| {
        certificate.tracking_bound(lambda, order).unwrap().unwrap()
    });
    tracked::<1>(bound(1), residual, lambda);
    tracked::<2>(bound(2), residual, lambda);
    tracked::<3>(bound(3), residual, lambda);
}
