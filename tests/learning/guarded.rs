//! The guard around a compensator whose u_n and s the test decides.

use brunovsky::{
    Error, Scalar,
    learning::{
        Certificate, ClosedLoop, Compensation, Compensator, Guarded, LearningMode, Switching,
        Watchdog,
    },
};

use crate::support::{NOT_FINITE, quiet, real};

in_both_precisions! {
    until_it_trips_it_is_the_compensator_inside,
    a_guard_without_a_fallback_only_flags,
    what_was_learned_fades_at_the_rate_and_then_nothing_is_added,
    a_loop_that_is_off_gets_nothing_at_once,
    learning_is_judged_while_it_is_active_and_anew_after_a_pause,
    a_rearmed_guard_goes_on_fading_under_a_compensator_of_its_own,
    a_bad_fade_rate_or_period_is_refused,
}

/// Says s = u_b, adds `u_n` unless it is off, and counts the samples that it has learned from.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scripted<T> {
    u_n: T,
    learned: u32,
}

impl<T: Scalar> Compensator<T, 2> for Scripted<T> {
    fn advanced(&self, at: &ClosedLoop<T, 2>, _dt: T) -> Result<(Self, Compensation<T>), Error> {
        let learned = self.learned + u32::from(at.learning == LearningMode::Active);
        let u_n = if at.learning == LearningMode::Off { -T::zero() } else { self.u_n };
        Ok((Self { learned, ..*self }, Compensation { u_n, s: at.u_b }))
    }
}

/// α·h = 0.25 and B·h = 0.0625 at h = 1/8 s; two samples late are one too many.
fn guard<T: Scalar>(u_n: f64) -> Guarded<Scripted<T>, T> {
    let certificate =
        Certificate::new(real(2.0), Switching::SetValued, real(0.125), real(0.5)).unwrap();
    let watchdog = Watchdog::new(certificate, T::zero(), real(0.125)).unwrap();
    Guarded::new(Scripted { u_n: real(u_n), learned: 0 }, watchdog)
}

/// u_n after each sample with that s and mode.
fn run<T: Scalar>(
    guarded: &mut Guarded<Scripted<T>, T>,
    samples: impl IntoIterator<Item = (f64, LearningMode)>,
) -> Vec<T> {
    let sample = |(s, learning)| {
        let at = ClosedLoop { u_b: real(s), learning, ..quiet() };
        let (next, compensation) = guarded.advanced(&at, real(0.125)).unwrap();
        assert_eq!(compensation.s, real(s));
        *guarded = next;
        compensation.u_n
    };
    samples.into_iter().map(sample).collect()
}

use LearningMode::{Active, Frozen, Off};

/// The samples that trip it: the bound starts at 0, and the third is the second in a row above it.
const TRIPPING: [(f64, LearningMode); 3] = [(0.0, Active), (5.0, Active), (-5.0, Active)];

fn until_it_trips_it_is_the_compensator_inside<T: Scalar>() {
    let mut guarded = guard::<T>(-0.0).with_fallback(T::one()).unwrap();
    let u_n = run(&mut guarded, [(0.0, Active), (5.0, Active), (0.0, Active), (5.0, Off)]);
    // Even a −0 passes.
    assert!(u_n.iter().all(|u_n| u_n.is_zero() && u_n.is_sign_negative()));
    assert_eq!((guarded.tripped(), guarded.compensator().learned), (false, 3));
}

fn a_guard_without_a_fallback_only_flags<T: Scalar>() {
    let mut guarded = guard::<T>(3.0);
    assert_eq!(run(&mut guarded, TRIPPING), [real::<T>(3.0); 3]);
    assert!(guarded.tripped());
    assert_eq!(run(&mut guarded, [(0.0, Active), (0.0, Off)]), [real(3.0), T::zero()]);
    assert_eq!((guarded.tripped(), guarded.compensator().learned), (true, 4));
}

/// 3, 2.5, 2, …: 4/s are 0.5 a sample. The sample that trips it still has the whole u_n.
fn what_was_learned_fades_at_the_rate_and_then_nothing_is_added<T: Scalar>() {
    for sign in [1.0, -1.0] {
        let mut guarded = guard::<T>(3.0 * sign).with_fallback(real(4.0)).unwrap();
        assert_eq!(run(&mut guarded, TRIPPING), [real::<T>(3.0 * sign); 3]);
        for k in 1..20 {
            let wanted = (3.0 - 0.5 * f64::from(k)).max(0.0) * sign;
            // A quiet s does not bring learning back, nor does freezing what is out of the loop.
            let mode = if k % 2 == 0 { Active } else { Frozen };
            let u_n = run(&mut guarded, [(0.0, mode)])[0];
            assert_eq!(u_n, real(wanted));
            assert!(!u_n.is_zero() || u_n.is_sign_negative());
        }
        assert_eq!((guarded.tripped(), guarded.compensator().learned), (true, 3));
    }
}

fn a_loop_that_is_off_gets_nothing_at_once<T: Scalar>() {
    let mut guarded = guard::<T>(3.0).with_fallback(real(4.0)).unwrap();
    run(&mut guarded, TRIPPING);
    let after = [(0.0, Active), (0.0, Off), (0.0, Active)];
    assert_eq!(run(&mut guarded, after), [real(2.5), T::zero(), T::zero()]);
}

fn learning_is_judged_while_it_is_active_and_anew_after_a_pause<T: Scalar>() {
    for mode in [Off, Frozen] {
        let mut guarded = guard::<T>(3.0).with_fallback(T::one()).unwrap();
        // While nothing is learned s may be anything, and it may still be there on the return: from it the bound starts.
        run(&mut guarded, [(0.0, Active), (5.0, Active), (5.0, mode), (9.0, mode), (8.0, Active)]);
        run(&mut guarded, [(7.9, Active)]);
        assert!(!guarded.tripped());
        run(&mut guarded, [(8.0, Active)]);
        assert!(guarded.tripped());
        run(&mut guarded, [(0.0, mode), (0.0, Active)]);
        assert!(guarded.tripped());
    }
}

fn a_rearmed_guard_goes_on_fading_under_a_compensator_of_its_own<T: Scalar>() {
    let mut guarded = guard::<T>(3.0).with_fallback(real(4.0)).unwrap();
    let fresh = guarded;
    run(&mut guarded, TRIPPING);
    assert_eq!(run(&mut guarded, [(0.0, Active)]), [real::<T>(2.5)]);
    guarded.rearm(Scripted { u_n: real(0.25), learned: 0 });
    assert!(!guarded.tripped());
    let u_n = run(&mut guarded, [(0.0, Active); 6]);
    assert_eq!(u_n, [2.25, 1.75, 1.25, 0.75, 0.25, 0.25].map(real::<T>));
    assert_eq!(guarded.compensator().learned, 6);
    // Once all has faded and nothing was seen, nothing is left of it.
    guarded.rearm(*fresh.compensator());
    assert_eq!(guarded, fresh);
}

fn a_bad_fade_rate_or_period_is_refused<T: Scalar>() {
    for bad in [0.0, -1.0] {
        let refused = Err(Error::NotPositive { name: "fade", value: bad });
        assert_eq!(guard::<T>(3.0).with_fallback(real(bad)), refused);
        let refused = guard::<T>(3.0).advanced(&quiet(), real(bad)).unwrap_err();
        assert_eq!(refused, Error::NotPositive { name: "dt", value: bad });
    }
    for bad in NOT_FINITE {
        let refused = guard::<T>(3.0).with_fallback(real(bad));
        assert!(matches!(refused, Err(Error::NonFinite { name: "fade", .. })));
    }
}
