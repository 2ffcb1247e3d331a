use brunovsky::{
    controller::{AntiWindup, Controller, Measurement, Mode, Pid, PidGains, Reference, Supervised},
    learning::LearningMode,
};
use proptest::prelude::*;

use super::{gains, pid, sampled, told};

fn any_gains() -> impl Strategy<Value = PidGains<f64>> {
    let numbers = (-5.0..5.0_f64, -3.0..3.0_f64, prop_oneof![Just(0.0), -2.0..2.0_f64]);
    (numbers, 0.01..1.0_f64, 0.0..1.0_f64, 0.0..1.0_f64)
        .prop_map(|((k, k_i, k_d), t_f, b, c)| gains(k, k_i, k_d, t_f).with_weights(b, c).unwrap())
}

proptest! {
    /// The first output is the one given, at once or in mid-run, to the last bit.
    #[test]
    fn a_start_is_where_it_was_said_to_be(tuned in any_gains(), u in -9.0..9.0_f64, y in -5.0..5.0_f64, r in -5.0..5.0_f64) {
        let mut pid = pid(tuned);
        pid.start_at(u).unwrap();
        prop_assert_eq!(sampled(&mut pid, y, r, 0.1).u, u);
        sampled(&mut pid, -y, r, 0.1);
        pid.start_at(-u).unwrap();
        prop_assert_eq!(sampled(&mut pid, y, r, 0.1).u, -u);
        // And goes on from there: I moves by h·k_i·e, D fades.
        let [a, b] = [(); 2].map(|()| sampled(&mut pid, y, r, 1e-9).u);
        prop_assert!((a + u).abs() < 1e-4 && (b + u).abs() < 1e-4, "{} {} {}", a, b, u);
    }

    /// With everything else as it was, u moves by no more than rates times h: 10⁻⁹ of a second, in which I moves at k_i·e and D at D/T_f.
    #[test]
    fn new_gains_do_not_move_the_output(
        before in any_gains(), after in any_gains(),
        samples in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64), 1..20),
    ) {
        let mut pid = pid(before);
        let mut u = 0.0;
        for (y, r) in &samples {
            u = sampled(&mut pid, *y, *r, 0.1).u;
        }
        let (y, r) = samples[samples.len() - 1];
        pid.set_gains(after).unwrap();
        prop_assert_eq!(*pid.gains(), after);
        let next = sampled(&mut pid, y, r, 1e-9).u;
        // |D| is at most 2·(15 + 1)·k_d/h-limited: 10³ a second at T_f = 0.01 gives 10⁵·h.
        prop_assert!((next - u).abs() < 1e-3, "{} {}", next, u);
    }

    /// T_t = 0 is the velocity form: u(k) = u_applied + h·k_i·e(k−1) + ΔP + ΔD, whoever applied it.
    #[test]
    fn with_no_tracking_time_every_output_starts_from_what_arrived(
        samples in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -9.0..9.0_f64), 2..30),
    ) {
        let tuned = gains(2.0, 1.5, 0.2, 0.1);
        let zero = AntiWindup::BackCalculation { tracking_time: 0.0 };
        let mut pid = Pid::<f64, 1>::new(tuned, zero).unwrap();
        let mut last: Option<(f64, brunovsky::controller::PidCommand<f64>)> = None;
        for (y, r, applied) in samples {
            let command = told(&mut pid, applied, y, r, 0.1);
            if let Some((e, last)) = last {
                let moved = command.u_p - last.u_p + command.u_d - last.u_d;
                let expected = applied + 0.1 * 1.5 * e + moved;
                prop_assert!((command.u - expected).abs() <= 1e-13 * 200.0, "{} {}", command.u, expected);
            }
            last = Some((r - y, command));
        }
    }

    /// Somebody else holds the input: the difference to it shrinks by T_t/(T_t + h) a sample, at e = 0.
    #[test]
    fn it_follows_whoever_drives(hold in -9.0..9.0_f64, tracking_time in 0.0..2.0_f64, h in 0.01..5.0_f64) {
        let tuned = gains(2.0, 1.5, 0.2, 0.1);
        let mut pid = Pid::<f64, 1>::new(tuned, AntiWindup::BackCalculation { tracking_time }).unwrap();
        let mut apart = told(&mut pid, hold, 1.0, 1.0, h).u - hold;
        for _ in 0..50 {
            apart *= tracking_time / (tracking_time + h);
            let found = told(&mut pid, hold, 1.0, 1.0, h).u - hold;
            prop_assert!((found - apart).abs() <= 64.0 * f64::EPSILON * hold.abs(), "{} {}", found, apart);
        }
    }
}

/// An operator pushes a mass and hands back: the offset that the supervisor has to add then is what the output did not follow. At the same
/// state that is h·k_i·e, and the part of D that fades in a sample, h/(T_f + h).
#[test]
fn what_an_operator_hands_back_is_taken_up_where_it_is() {
    let (h, hold) = (0.01, 0.3);
    let zero = AntiWindup::BackCalculation { tracking_time: 0.0 };
    let pid = Pid::<f64, 2>::new(gains(4.0, 2.0, 3.0, 0.1), zero).unwrap();
    let mut supervised = Supervised::new(pid, [0.1]).unwrap();
    supervised.set_manual([hold]).unwrap();
    let mut sample = |t: f64| {
        let x = Measurement::new([0.5 * hold * t * t, hold * t]);
        supervised.update(&x, &Reference::setpoint(1.0), h).unwrap()
    };
    let manual = (0..100).map(|k| sample(f64::from(k) * h)).last().unwrap();
    assert_eq!(manual.u[0], hold);
    supervised.select(Mode::Automatic(LearningMode::Active));
    let x = Measurement::new([0.5 * hold * 0.99 * 0.99, hold * 0.99]);
    let automatic = supervised.update(&x, &Reference::setpoint(1.0), h).unwrap();
    assert_eq!(automatic.u[0], hold);
    let faded = manual.asked.unwrap().u_d * h / (0.1 + h);
    let moved = h * 2.0 * (1.0 - x.x[0]) - faded;
    approx::assert_abs_diff_eq!(automatic.offset[0], -moved, epsilon = 1e-14);
}
