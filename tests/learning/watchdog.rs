//! When the watchdog trips and when it must not, on the scalar recursion of s.

use brunovsky::{
    Error, Scalar,
    learning::{Certificate, Switching, Watch, Watchdog},
};

use crate::support::{
    ALPHA, DISTURBANCES, NOT_FINITE, PERIOD, REACH, SWITCHINGS, real, trajectory, ulps,
};

in_both_precisions! {
    the_first_sample_sets_the_bound,
    its_clock_runs_while_s_is_above_the_bound_and_back_while_it_is_not,
    once_tripped_it_stays_so_until_it_is_reset,
    an_s_that_is_not_finite_is_refused,
    a_parameter_out_of_range_is_refused,
}

fn certificate(switching: Switching<f64>, bound: f64) -> Certificate<f64> {
    Certificate::new(ALPHA, switching, PERIOD, bound).unwrap()
}

/// Set-valued sign, α·h = 0.25, B·h = 0.05, and a period of 1/64 s, whose multiples are exact.
fn watchdog<T: Scalar>(slack: f64, patience: f64) -> Watchdog<T> {
    let certificate =
        Certificate::new(real(16.0), Switching::SetValued, real(0.015625), real(3.2)).unwrap();
    Watchdog::new(certificate, real(slack), real(patience)).unwrap()
}

fn the_first_sample_sets_the_bound<T: Scalar>() {
    for s0 in [0.0, 90.0, -1e30] {
        let watch = watchdog::<T>(0.0, 0.0).update(real(s0)).unwrap();
        let allowed = real::<T>(s0).abs();
        assert_eq!(watch, Watch { allowed, late: T::zero(), tripped: false });
    }
}

/// A patience of three periods bears just that.
fn its_clock_runs_while_s_is_above_the_bound_and_back_while_it_is_not<T: Scalar>() {
    let mut watchdog = watchdog::<T>(0.0, 3.0 * 0.015625);
    let s = [0.0, 9.0, 0.0, 0.0, 9.0, -9.0, 9.0, 0.0, 9.0, -9.0];
    let late = [0, 1, 0, 0, 1, 2, 3, 2, 3, 4];
    for (s, late) in s.into_iter().zip(late) {
        let watch = watchdog.update(real(s)).unwrap();
        assert_eq!(watch.late, real(0.015625 * f64::from(late)));
        assert_eq!((watch.tripped, watchdog.tripped()), (late > 3, late > 3));
    }
}

fn once_tripped_it_stays_so_until_it_is_reset<T: Scalar>() {
    let fresh = watchdog::<T>(0.1, 0.0);
    let mut used = fresh;
    for (s, tripped) in [(0.0, false), (9.0, true), (0.0, true), (0.0, true)] {
        assert_eq!(used.update(real(s)).unwrap().tripped, tripped);
    }
    used.reset();
    assert_eq!(used, fresh);
}

fn an_s_that_is_not_finite_is_refused<T: Scalar>() {
    let fresh = watchdog::<T>(0.1, 0.5);
    let mut used = fresh;
    used.update(T::one()).unwrap();
    for mut watchdog in [fresh, used] {
        let before = watchdog;
        for bad in NOT_FINITE {
            assert!(matches!(watchdog.update(real(bad)), Err(Error::NonFinite { name: "s", .. })));
            assert_eq!(watchdog, before);
        }
    }
}

fn a_parameter_out_of_range_is_refused<T: Scalar>() {
    let certificate =
        Certificate::new(T::one(), Switching::SetValued, T::one(), T::zero()).unwrap();
    let attempt = |slack, patience| Watchdog::new(certificate, real(slack), real(patience));
    assert_eq!(attempt(-0.5, 1.0), Err(Error::Negative { name: "slack", value: -0.5 }));
    assert_eq!(attempt(1.0, -0.5), Err(Error::Negative { name: "patience", value: -0.5 }));
    for bad in NOT_FINITE {
        assert!(matches!(attempt(bad, 1.0), Err(Error::NonFinite { name: "slack", .. })));
        assert!(matches!(attempt(1.0, bad), Err(Error::NonFinite { name: "patience", .. })));
    }
}

/// Whether a watchdog with that slack and patience trips on the samples of s.
fn trips(
    certificate: Certificate<f64>,
    slack: f64,
    patience: f64,
    mut s: impl Iterator<Item = f64>,
) -> bool {
    let mut watchdog = Watchdog::new(certificate, slack, patience).unwrap();
    s.any(|s| watchdog.update(s).unwrap().tripped)
}

/// Without any patience. The allowance rounds once a sample.
#[test]
fn a_lawful_uncertainty_never_trips_it() {
    for (switching, bound) in SWITCHINGS.into_iter().flat_map(|s| [(s, 0.0), (s, 5.0), (s, 24.0)]) {
        for (kind, s0) in (0..DISTURBANCES).flat_map(|kind| [(kind, 12.0), (kind, -0.3)]) {
            let s = trajectory(switching, s0, bound * PERIOD, kind, 1000, |_| 0.0);
            let slack = ulps::<f64>(4.0 * 12.0 * 1000.0);
            assert!(!trips(certificate(switching, bound), slack, 0.0, s), "{switching:?} {kind}");
        }
    }
}

/// From rest at the residual, Δ jumps by J, and then does what it likes. With noise on the s that is learned from and judged, the slack
/// being that and the ε of the recovery time, a patience of the recovery time bears it; the time J/(α − B) that even the ideal sign needs,
/// less two samples, is too short for Δ̇ = −B.
#[test]
fn a_jump_within_the_patience_never_trips_it_and_a_greater_one_does() {
    for (switching, bound) in SWITCHINGS.into_iter().flat_map(|s| [(s, 0.0), (s, 5.0), (s, 20.0)]) {
        let certificate = certificate(switching, bound);
        let s0 = certificate.residual().unwrap();
        for (jump, level, within) in [(0.5, 0.0, 1e-3), (8.0, 0.02, 1e-3), (8.0, 0.0, 1e-6)] {
            let run = |kind, patience| {
                let noise = |k: u32| level * (f64::from(k) * f64::from(k)).sin();
                let after = trajectory(switching, s0 + jump, bound * PERIOD, kind, 3000, noise);
                let seen = after.enumerate().map(|(k, s)| s + noise(k as u32));
                let s = core::iter::repeat_n(0.0, 2000).chain(seen);
                trips(certificate, level + within, patience, s)
            };
            let patience = certificate.recovery_time(jump, within).unwrap().unwrap();
            for kind in 0..DISTURBANCES {
                assert!(!run(kind, patience), "{switching:?}, B = {bound}, {kind}, {jump}");
            }
            if jump > 4.0 * REACH && level == 0.0 {
                let short = jump / (ALPHA - bound) - 2.0 * PERIOD;
                assert!(run(1, short), "{switching:?}, B = {bound}, {jump}");
            }
        }
    }
}

/// 5 % beyond B for ever: s stays above the residual by 0.05·B·h, or more.
#[test]
fn an_uncertainty_that_is_too_fast_trips_it() {
    for switching in SWITCHINGS.into_iter().filter(|s| !matches!(s, Switching::Explicit { .. })) {
        let s = trajectory(switching, 0.0, 5.25 * PERIOD, 1, 2000, |_| 0.0);
        assert!(trips(certificate(switching, 5.0), 0.001, 1.0, s), "{switching:?}");
    }
}

/// b = −b̂: s ↦ s + αh·ς, away from zero; b = 3·b̂: s ↦ s − 3αh·ς ends between αh and 2αh in size. Both with the set-valued sign and whatever
/// small s they start from.
#[test]
fn an_input_gain_that_is_far_off_trips_it() {
    for ratio in [-1.0, 3.0] {
        let learned = move |s: &f64| Some(s - ratio * (s / REACH).clamp(-1.0, 1.0) * REACH);
        let s = core::iter::successors(Some(1e-9), learned).take(300);
        assert!(trips(certificate(Switching::SetValued, 5.0), 0.1, 0.5, s));
    }
}
