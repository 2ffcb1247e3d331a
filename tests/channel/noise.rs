//! Random channels against their statistics. Tolerances are five standard deviations of the estimate.

use brunovsky::channel::{Channel, Dropout, Noise, Wander};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::all_arrived;

fn random(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}

/// The autocovariance at a distance of `lag` periods.
fn covariance(values: &[f64], lag: usize) -> f64 {
    mean(values.iter().zip(&values[lag..]).map(|(a, b)| a * b))
}

#[test]
fn noise_is_white_with_its_deviation() {
    let noise = Noise::new([0.3], random(1)).unwrap();
    let values: Vec<f64> = all_arrived(noise, &[0.0; 100_000], 0.1);
    let variance = 0.3 * 0.3;
    // Of n samples the mean has deviation σ/√n, the variance σ²·√(2/n), a covariance σ²/√n.
    approx::assert_abs_diff_eq!(mean(values.iter().copied()), 0.0, epsilon = 0.0048);
    approx::assert_relative_eq!(covariance(&values, 0), variance, max_relative = 0.0224);
    for lag in [1, 2, 10] {
        approx::assert_abs_diff_eq!(covariance(&values, lag), 0.0, epsilon = 0.016 * variance);
    }
    // 4.55 % of a normal law lie beyond two deviations.
    let beyond = mean(values.iter().map(|value| f64::from(u8::from(value.abs() > 0.6))));
    approx::assert_abs_diff_eq!(beyond, 0.0455, epsilon = 0.0033);
}

/// e^(−|t|/τ) at one and at ten periods, and the full deviation from the first sample on.
#[test]
fn a_wander_forgets_with_its_time_constant() {
    let wander = Wander::new([2.0], 1.0, random(2)).unwrap();
    let values: Vec<f64> = all_arrived(wander, &[0.0; 1_000_000], 0.1);
    // Some n·h/2τ = 5·10⁴ independent stretches.
    for (lag, kept) in [(0, 1.0), (1, (-0.1_f64).exp()), (10, (-1.0_f64).exp())] {
        approx::assert_abs_diff_eq!(covariance(&values, lag), 4.0 * kept, epsilon = 4.0 * 0.032);
    }
    let first = |seed| all_arrived(Wander::new([2.0], 1.0, random(seed)).unwrap(), &[0.0], 1e-9)[0];
    let firsts: Vec<f64> = (0..20_000).map(first).collect();
    approx::assert_relative_eq!(covariance(&firsts, 0), 4.0, max_relative = 0.05);
}

/// A period in pieces is the period: the covariance over it does not depend on how it is cut.
#[test]
fn a_wander_is_exact_at_any_period() {
    let ends = |pieces: usize| -> Vec<f64> {
        let wander = Wander::new([1.0], 1.0, random(3)).unwrap();
        let values: Vec<f64> =
            all_arrived(wander, &vec![0.0; 400_000 * pieces], 0.5 / pieces as f64);
        values.into_iter().step_by(pieces).collect()
    };
    let [whole, cut] = [1, 4].map(|pieces| covariance(&ends(pieces), 1));
    let wanted = (-0.5_f64).exp();
    approx::assert_abs_diff_eq!(whole, wanted, epsilon = 0.012);
    approx::assert_abs_diff_eq!(cut, wanted, epsilon = 0.012);
}

/// What is lost is replaced by what arrived last; runs of losses are geometric: a loss follows a loss as often as anything else.
#[test]
fn losses_are_independent_and_hold_the_last_signal() {
    let sent: Vec<f64> = (0..100_000).map(f64::from).collect();
    let values: Vec<f64> = all_arrived(Dropout::new(0.2, random(4)).unwrap(), &sent, 0.1);
    let lost: Vec<bool> = values.iter().zip(&sent).map(|(value, sent)| value != sent).collect();
    assert!(!lost[0]);
    for k in 1..values.len() {
        assert_eq!(values[k], if lost[k] { values[k - 1] } else { sent[k] });
    }
    let share = |losses: &[bool]| mean(losses.iter().map(|lost| f64::from(u8::from(*lost))));
    approx::assert_abs_diff_eq!(share(&lost), 0.2, epsilon = 0.0064);
    let after_a_loss: Vec<bool> =
        lost.windows(2).filter(|pair| pair[0]).map(|pair| pair[1]).collect();
    approx::assert_abs_diff_eq!(share(&after_a_loss), 0.2, epsilon = 0.015);
}

#[test]
fn the_same_seed_gives_the_same_signals_and_another_one_others() {
    fn row(channel: impl Channel<f64, 1>) -> Vec<f64> {
        let ramp: Vec<f64> = (0..100).map(f64::from).collect();
        all_arrived(channel, &ramp, 0.1)
    }
    let instrument = |seed| {
        let noise = Noise::new([0.1], random(seed)).unwrap();
        let wander = Wander::new([1.0], 5.0, random(seed + 1)).unwrap();
        (wander, (noise, Dropout::new(0.3, random(seed + 2)).unwrap()))
    };
    assert_eq!(row(instrument(7)), row(instrument(7)));
    assert_ne!(row(instrument(7)), row(instrument(8)));
}
