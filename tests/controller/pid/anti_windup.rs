use brunovsky::{
    channel::Saturation,
    controller::{AntiWindup, Limited, Pid, Reference},
    plant::IntegratorChain,
};
use proptest::prelude::*;

use super::{gains, told};
use crate::support::run;

const EVERY: [AntiWindup<f64>; 3] = [
    AntiWindup::None,
    AntiWindup::BackCalculation { tracking_time: 0.4 },
    AntiWindup::Conditional { tolerance: 0.0 },
];

fn pid(k_i: f64, anti_windup: AntiWindup<f64>) -> Pid<f64, 1> {
    Pid::new(gains(2.0, k_i, 0.0, 1.0), anti_windup).unwrap()
}

proptest! {
    /// At a constant error and a constant limit the excess v = u − u_applied obeys v⁺ = v·T_t/(T_t + h) + h·k_i·e, whose fixed point is
    /// k_i·e·(T_t + h), at any period.
    #[test]
    fn back_calculation_rests_beyond_the_limit_by_the_rate_of_the_integral(
        tracking_time in 0.0..3.0_f64, h in 1e-3..10.0_f64, e in -4.0..4.0_f64, limit in -2.0..2.0_f64,
    ) {
        let mut pid = pid(1.5, AntiWindup::BackCalculation { tracking_time });
        let beyond = 1.5 * e * (tracking_time + h);
        let mut excess = told(&mut pid, 0.0, 0.0, e, h).u - limit;
        for _ in 0..200 {
            let expected = beyond + (excess - beyond) * (tracking_time / (tracking_time + h));
            excess = told(&mut pid, limit, 0.0, e, h).u - limit;
            let size = 2.0 + beyond.abs() + 8.0 * e.abs() + expected.abs();
            prop_assert!((excess - expected).abs() <= 32.0 * f64::EPSILON * size, "{} {}", excess, expected);
        }
    }

    /// Conditional integration: what the integral would move into the limit is left out, what it moves out of it is not.
    #[test]
    fn a_conditional_integral_moves_out_of_the_limit_alone(
        e in prop_oneof![-4.0..-0.1_f64, 0.1..4.0_f64], missing in prop_oneof![-2.0..-0.2_f64, 0.2..2.0_f64],
    ) {
        let mut pid = pid(1.5, AntiWindup::Conditional { tolerance: 0.1 });
        let first = told(&mut pid, 0.0, 0.0, e, 0.5);
        let second = told(&mut pid, first.u - missing, 0.0, e, 0.5);
        let expected = if missing.signum() == e.signum() { 0.0 } else { 0.5 * 1.5 * e };
        prop_assert_eq!(second.u_i, expected);
        // Within the tolerance nothing is a limit.
        let third = told(&mut pid, second.u - 0.05 * missing.signum(), 0.0, e, 0.5);
        prop_assert_eq!(third.u_i, expected + 0.5 * 1.5 * e);
    }

    /// Where the command arrives, or nobody reports, all three are one.
    #[test]
    fn without_a_limit_there_is_no_difference(
        samples in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64), 1..40),
    ) {
        let [mut none, mut back, mut conditional] = EVERY.map(|anti_windup| pid(1.5, anti_windup));
        let mut last = 0.0;
        for (y, r) in samples {
            let command = super::sampled(&mut none, y, r, 0.1);
            prop_assert_eq!(told(&mut back, last, y, r, 0.1), command);
            prop_assert_eq!(told(&mut conditional, last, y, r, 0.1), command);
            last = command.u;
        }
    }
}

/// A step of 10 on an integrator with |u| ≤ 1: x reaches it after about 10 s at the limit. An integral that wound up meanwhile, to the order
/// of k_i·∫e ≈ 50, has to be integrated down again above the reference, so the overshoot is that of the area under the approach.
#[test]
fn only_without_anti_windup_does_the_step_overshoot_for_as_long_as_it_took() {
    let plant = IntegratorChain::<f64, 1>::new();
    let overshoot = EVERY.map(|anti_windup| {
        let limited = Limited::new(pid(1.0, anti_windup), Saturation::symmetric([1.0]).unwrap());
        let samples = run(&plant, limited, |_| Reference::setpoint(10.0), [0.0], 0.01, 60.0);
        samples.iter().map(|sample| sample.x[0] - 10.0).fold(0.0, f64::max)
    });
    // ∫e of the approach is 50 and u stays at the limit until the area above is about as large: overshoot²/2 ≈ 50 less what P gives.
    assert!(overshoot[0] > 5.0, "{overshoot:?}");
    // A double pole at −1 overshoots a step by no more than e⁻² of it; here the step left at the end of the limit is of size 1.
    assert!(overshoot[1] < 1.0 && overshoot[2] < 1.0, "{overshoot:?}");
}
