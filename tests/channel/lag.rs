use brunovsky::{
    Scalar,
    channel::{Channel, Lag},
    nalgebra::SVector,
};
use proptest::prelude::*;

use super::{all_arrived, at_f32_and_f64, num};

/// y(t) = 1 − e^(−t/τ), so the mean over a period is 1 − (y(end) − y(start))·τ/h·…: ∫y dt = h − τ·(e^(−t₀/τ) − e^(−t₁/τ)).
fn a_step_is_answered_by_an_exponential<T: Scalar>() {
    let (tau, h) = (0.3_f64, 0.1_f64);
    let means: Vec<T> = all_arrived(Lag::new([num::<T>(tau)]).unwrap(), &[1.0; 30], h);
    for (k, mean) in (0..).map(f64::from).zip(means) {
        let [start, end] = [k * h, (k + 1.0) * h].map(|t| (-t / tau).exp());
        let wanted: T = num(1.0 - tau * (start - end) / h);
        approx::assert_relative_eq!(mean, wanted, max_relative = T::default_epsilon() * num(64.0));
    }
}

at_f32_and_f64! {
    a_step_becomes_an_exponential => a_step_is_answered_by_an_exponential,
}

/// A period cut into pieces under the same signal has the mean of the means.
#[test]
fn pieces_of_a_period_are_the_period() {
    let lag = Lag::new([0.2]).unwrap().starting_at([-1.0]).unwrap();
    let whole = all_arrived(lag, &[2.0, -3.0], 0.15);
    let pieces = all_arrived(lag, &[2.0, 2.0, 2.0, -3.0, -3.0, -3.0], 0.05);
    for (whole, pieces) in whole.iter().zip(pieces.chunks(3)) {
        approx::assert_relative_eq!(*whole, pieces.iter().sum::<f64>() / 3.0, max_relative = 1e-14);
    }
}

proptest! {
    /// Between where it was and where it goes, at any ratio of period and time constant.
    #[test]
    fn what_arrives_lies_between_start_and_signal(
        tau in -200.0..200.0_f64, h in -200.0..200.0_f64, start in -1e3..1e3_f64, signal in -1e3..1e3_f64,
    ) {
        let lag = Lag::new([tau.exp2()]).unwrap().starting_at([start]).unwrap();
        let (next, arrived) = lag.passed(&SVector::from([signal]), h.exp2()).unwrap();
        let (_, then) = next.passed(&SVector::from([signal]), h.exp2()).unwrap();
        let slack = 1e-12 * (start.abs() + signal.abs());
        for value in [arrived[0], then[0]] {
            prop_assert!(value >= start.min(signal) - slack && value <= start.max(signal) + slack);
        }
    }
}
