use brunovsky::{
    Error, Scalar,
    learning::{Certificate, Monitor, Switching, Verdict, Watchdog},
};

use crate::support::{
    ALPHA, DISTURBANCES, NOT_FINITE, PERIOD, REACH, SWITCHINGS, real, trajectory, ulps,
};

in_both_precisions! {
    the_first_sample_sets_the_bound,
    no_lawful_uncertainty_is_reported,
    the_worst_case_of_an_implicit_sign_is_allowed_and_no_more,
    an_uncertainty_that_is_slightly_too_fast_is_reported,
    a_jump_beyond_the_residual_is_reported_once,
    noise_within_the_slack_is_not_reported,
    a_reset_monitor_is_a_new_one,
    an_s_that_is_not_finite_is_refused,
    a_slack_that_is_negative_or_not_finite_is_refused,
    a_bound_beyond_the_range_is_refused,
}

/// The same discretization with its δ in `T`.
fn switching<T: Scalar>(switching: Switching<f64>) -> Switching<T> {
    match switching {
        Switching::Explicit { delta } => Switching::Explicit { delta: real(delta) },
        Switching::Implicit { delta } => Switching::Implicit { delta: real(delta) },
        Switching::SetValued => Switching::SetValued,
    }
}

fn monitor<T: Scalar>(sign: Switching<f64>, bound: f64, slack: T) -> Monitor<T> {
    let certificate =
        Certificate::new(real(ALPHA), switching(sign), real(PERIOD), real(bound)).unwrap();
    Monitor::new(certificate, slack).unwrap()
}

/// Some ulps of the largest number around, for the rounding of s and of the bound.
fn rounding<T: Scalar>(s0: f64) -> T {
    ulps(4.0 * (s0.abs() + REACH))
}

fn implicit_switchings() -> impl Iterator<Item = Switching<f64>> {
    SWITCHINGS.into_iter().filter(|switching| !matches!(switching, Switching::Explicit { .. }))
}

fn the_first_sample_sets_the_bound<T: Scalar>() {
    for s0 in [0.0, 90.0, -1e30] {
        let verdict = monitor::<T>(Switching::SetValued, 5.0, T::zero()).update(real(s0)).unwrap();
        assert_eq!(verdict, Verdict { allowed: real::<T>(s0).abs(), holds: true });
    }
}

/// Also where α < B, so that s grows, to 50 + 12 at the most. The allowance rounds once a sample, a thousand times.
fn no_lawful_uncertainty_is_reported<T: Scalar>() {
    for sign in SWITCHINGS {
        for bound in [0.0, 5.0, 24.0, 30.0] {
            for (kind, s0) in
                (0..DISTURBANCES).flat_map(|kind| [(kind, 12.0), (kind, -0.3), (kind, 0.0)])
            {
                let mut monitor = monitor::<T>(sign, bound, rounding::<T>(62.0) * real(1000.0));
                for s in trajectory(sign, s0, bound * PERIOD, kind, 1000, |_| 0.0) {
                    assert!(
                        monitor.update(real(s)).unwrap().holds,
                        "{sign:?}, B = {bound}, {kind}, {s0}"
                    );
                }
            }
        }
    }
}

/// From s₀ > 0, the constant Δ̇ = −B gives the largest s at every sample. The allowance rounds once a sample; that much slack is
/// added twice, and its own rounding once more.
fn the_worst_case_of_an_implicit_sign_is_allowed_and_no_more<T: Scalar>() {
    for sign in implicit_switchings() {
        let slack = rounding::<T>(12.0) * real(200.0);
        let mut monitor = monitor::<T>(sign, 5.0, slack);
        for s in trajectory(sign, 12.0, 5.0 * PERIOD, 1, 200, |_| 0.0) {
            let spare = monitor.update(real(s)).unwrap().allowed - real(s);
            assert!(spare >= T::zero() && spare <= slack * real(3.0));
        }
    }
}

/// 5 % more than allowed, on the way to zero, on which allowance and s part by 0.05·B·h = 0.0025 a sample.
fn an_uncertainty_that_is_slightly_too_fast_is_reported<T: Scalar>() {
    for sign in implicit_switchings() {
        let mut monitor = monitor::<T>(sign, 5.0, rounding(12.0));
        let verdicts: Vec<bool> = trajectory(sign, 12.0, 5.25 * PERIOD, 1, 20, |_| 0.0)
            .map(|s| monitor.update(real(s)).unwrap().holds)
            .collect();
        assert!(verdicts[0] && verdicts[1..].iter().all(|holds| !holds));
    }
}

/// From rest, allowance settles at the residual: a jump of Δ to 0.95 of it could be lawful, one to 1.05 could not. The violation
/// is reported when it happens, and what lawfully follows from it is not.
fn a_jump_beyond_the_residual_is_reported_once<T: Scalar>() {
    for sign in SWITCHINGS {
        let certificate = Certificate::new(ALPHA, sign, PERIOD, 5.0).unwrap();
        let residual = certificate.residual().unwrap();
        for (jump, lawful) in [(0.95, true), (-0.95, true), (1.05, false), (-1.05, false)] {
            let mut monitor = monitor::<T>(sign, 5.0, rounding(1.0));
            for _ in 0..2000 {
                assert!(monitor.update(T::zero()).unwrap().holds);
            }
            let mut after = trajectory(sign, jump * residual, 5.0 * PERIOD, 2, 500, |_| 0.0);
            let size = real::<T>(after.next().unwrap());
            let verdict = monitor.update(size).unwrap();
            assert_eq!(verdict.holds, lawful);
            assert_eq!(verdict.holds, size.abs() <= verdict.allowed);
            assert!(after.all(|s| monitor.update(real(s)).unwrap().holds));
        }
    }
}

/// The rule acts on the noisy s, and the monitor sees the same.
fn noise_within_the_slack_is_not_reported<T: Scalar>() {
    let to_and_fro: fn(u32) -> f64 = |k| f64::from(k % 2) * 2.0 - 1.0;
    let slow: fn(u32) -> f64 = |k| (0.01 * f64::from(k)).sin().signum();
    let erratic: fn(u32) -> f64 = |k| (f64::from(k) * f64::from(k)).sin();
    for (sign, kind) in
        SWITCHINGS.into_iter().flat_map(|sign| (0..DISTURBANCES).map(move |kind| (sign, kind)))
    {
        for (noise, level) in
            [to_and_fro, slow, erratic].into_iter().flat_map(|noise| [(noise, 0.02), (noise, 0.5)])
        {
            let mut monitor = monitor::<T>(sign, 5.0, real::<T>(level) + rounding(12.0));
            let true_s = trajectory(sign, 12.0, 5.0 * PERIOD, kind, 500, |k| level * noise(k));
            for (k, s) in true_s.enumerate() {
                assert!(monitor.update(real(s + level * noise(k as u32))).unwrap().holds);
            }
        }
    }
}

fn a_reset_monitor_is_a_new_one<T: Scalar>() {
    let fresh = monitor::<T>(Switching::SetValued, 5.0, real(0.1));
    let mut used = fresh;
    used.update(T::one()).unwrap();
    assert_ne!(used, fresh);
    used.reset();
    assert_eq!(used, fresh);
    assert!(used.update(real(1e9)).unwrap().holds);
}

fn an_s_that_is_not_finite_is_refused<T: Scalar>() {
    let fresh = monitor::<T>(Switching::SetValued, 5.0, real(0.1));
    let mut used = fresh;
    used.update(T::one()).unwrap();
    for mut monitor in [fresh, used] {
        let before = monitor;
        for bad in NOT_FINITE {
            assert!(matches!(monitor.update(real(bad)), Err(Error::NonFinite { name: "s", .. })));
            assert_eq!(monitor, before);
        }
    }
}

fn a_slack_that_is_negative_or_not_finite_is_refused<T: Scalar>() {
    let certificate =
        Certificate::new(T::one(), Switching::SetValued, T::one(), T::zero()).unwrap();
    let attempt = |bad: f64| Monitor::new(certificate, real(bad)).unwrap_err();
    assert_eq!(attempt(-0.5), Error::Negative { name: "slack", value: -0.5 });
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad), Error::NonFinite { name: "slack", .. }));
    }
}

/// |s| and the slack are finite, and their sum is not; nor would be the time above the bound.
fn a_bound_beyond_the_range_is_refused<T: Scalar>() {
    let most = T::max_value().unwrap();
    let certificate = |dt| Certificate::new(T::one(), Switching::SetValued, dt, T::zero()).unwrap();
    let monitor = Monitor::new(certificate(T::one()), most * real(0.4)).unwrap();
    let watchdog = Watchdog::new(certificate(T::one()), most * real(0.4), T::zero()).unwrap();
    let (mut monitored, mut watched) = (monitor, watchdog);
    let error = |found| matches!(found, Err(Error::NonFinite { name: "allowed s", .. }));
    assert!(error(monitored.update(most).map(|verdict| verdict.allowed)));
    assert!(error(watched.update(most).map(|watch| watch.allowed)));
    assert_eq!((monitored, watched), (monitor, watchdog));
    assert!(monitored.update(T::one()).unwrap().holds);
    assert!(watched.update(T::one()).unwrap().allowed.is_finite());

    let mut late = Watchdog::new(certificate(most * real(0.75)), T::zero(), most).unwrap();
    late.update(T::zero()).unwrap();
    late.update(T::one()).unwrap();
    let before = late;
    let error = late.update(T::one());
    assert!(matches!(error, Err(Error::NonFinite { name: "time above the bound", .. })));
    assert_eq!(late, before);
}

/// Noise does not add up in s. With |noise| ≤ slack and the set-valued sign, |s(k+1)| ≤ slack + B·h once |s(k)| ≤ slack +
/// B·h < αh, so the s that the monitor sees from rest is never above 2·slack + B·h.
#[test]
fn a_jump_is_reported_however_large_the_slack() {
    let slack = 0.15;
    let mut monitor = monitor::<f64>(Switching::SetValued, 5.0, slack);
    for _ in 0..1000 {
        monitor.update(0.0).unwrap();
    }
    let verdict = monitor.update(100.0).unwrap();
    assert!(!verdict.holds, "{} allowed, {} possible", verdict.allowed, 2.0 * slack + 5.0 * PERIOD);
}
