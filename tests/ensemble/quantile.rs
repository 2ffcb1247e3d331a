//! Quantiles and their intervals against the definition, binomial sums and their coverage.

use brunovsky::ensemble::{Run, Summary, rand::RngExt};

use crate::support::{assert_plausible, binomial, given};

/// The values 1…n in an order that is not theirs.
fn ranks(n: u32, level: f64) -> Summary {
    let values: Vec<f64> = (0..n).map(|k| f64::from((k * 7919) % n + 1)).collect();
    let [summary] = given(&values).summaries(level).unwrap();
    summary
}

/// Of 1…n the p-quantile is the least k with k ≥ n·p, in whole numbers for p = i/100: k = ⌈n·i/100⌉.
#[test]
fn a_quantile_is_the_least_value_that_enough_do_not_exceed() {
    for n in [1, 2, 5, 10, 20, 99, 100, 300] {
        let summary = ranks(n, 0.95);
        for i in 1..100 {
            let k = (n * i).div_ceil(100);
            let p = f64::from(i) / 100.0;
            assert_eq!(summary.quantile(p).unwrap().value, f64::from(k), "p = {p}, n = {n}");
        }
    }
}

/// n = 6: P(B < 1) = 2⁻⁶ < 0.025 < P(B < 2), so the median lies in [x₁, x₆]; n = 5: 2⁻⁵ > 0.025, five values say nothing at 0.95.
#[test]
fn the_interval_of_the_median_needs_six_values() {
    let six = ranks(6, 0.95).quantile(0.5).unwrap();
    assert_eq!((six.value, six.low, six.high), (3.0, 1.0, 6.0));
    let five = ranks(5, 0.95).quantile(0.5).unwrap();
    assert_eq!((five.value, five.low, five.high), (3.0, f64::NEG_INFINITY, f64::INFINITY));
}

/// The largest of n values is above the p-quantile with probability 1 − pⁿ (S. S. Wilks): for p = 0.95 and 0.975, 71 are not enough, 72 are.
#[test]
fn seventy_two_runs_bound_the_95_percent_quantile() {
    assert!(0.95_f64.powi(71) > 0.025 && 0.95_f64.powi(72) < 0.025);
    assert_eq!(ranks(71, 0.95).quantile(0.95).unwrap().high, f64::INFINITY);
    assert_eq!(ranks(72, 0.95).quantile(0.95).unwrap().high, 72.0);
}

/// Both ends by binomial sums from the definition: the missing confidence is at most half on either side, and more with the next rank inside.
#[test]
fn the_ranks_are_the_tightest_that_keep_the_level() {
    for n in [20, 72, 300] {
        for p in [0.01, 0.1, 0.5, 0.95] {
            for level in [0.5, 0.95, 0.999] {
                let interval = ranks(n, level).quantile(p).unwrap();
                let tail = 0.5 * (1.0 - level);
                let sum = |from: u32, to: u32| (from..to).map(|k| binomial(n, k, p)).sum::<f64>();
                let low = if interval.low == f64::NEG_INFINITY { 0 } else { interval.low as u32 };
                let high =
                    if interval.high == f64::INFINITY { n + 1 } else { interval.high as u32 };
                assert!(sum(0, low) <= tail && sum(0, low + 1) > tail);
                assert!(sum(high, n + 1) <= tail && sum(high - 1, n + 1) > tail);
            }
        }
    }
}

/// At n = 10⁵ the binomial is normal to 1/√n: the ranks are np ± z·√(np(1−p)) to a few places. z is the 0.975-quantile, by tables.
#[test]
fn the_ranks_of_large_samples_are_those_of_the_normal_distribution() {
    let n = 100_000;
    let values: Vec<f64> = (1..=n).map(f64::from).collect();
    let [summary] = given(&values).summaries(0.95).unwrap();
    for p in [0.01, 0.5, 0.95, 0.999] {
        let (centre, interval) = (f64::from(n) * p, summary.quantile(p).unwrap());
        let half = 1.959_963_984_540_054 * (centre * (1.0 - p)).sqrt();
        assert!((interval.low - (centre - half)).abs() <= 3.0, "{interval} at {p}");
        assert!((interval.high - (centre + half)).abs() <= 3.0, "{interval} at {p}");
    }
}

/// The exponential's quantile is −ln(1 − p). Its interval covers it with P(l ≤ B < u), a sum that the level bounds from below.
#[test]
fn the_interval_covers_the_quantile_as_often_as_the_binomial_says() {
    let (n, trials) = (50, 5000);
    for (p, level) in [(0.5, 0.9), (0.9, 0.95)] {
        let ranks = ranks(n, level).quantile(p).unwrap();
        let high = if ranks.high == f64::INFINITY { n + 1 } else { ranks.high as u32 };
        let due: f64 = (ranks.low as u32..high).map(|k| binomial(n, k, p)).sum();
        assert!(due >= level);
        let covered = |trial| {
            let mut run = Run::new(31, trial);
            let values: Vec<f64> = (0..n).map(|_| -(1.0 - run.random::<f64>()).ln()).collect();
            let [summary] = given(&values).summaries(level).unwrap();
            summary.quantile(p).unwrap().covers(-f64::ln(1.0 - p))
        };
        let hits = (0..trials).filter(|&trial| covered(trial)).count();
        assert_plausible(hits as u32, trials as u32, due);
    }
}

#[test]
fn runs_are_ranked_from_best_to_worst_by_their_index() {
    let [summary] = given(&[3.0, 1.0, f64::NAN, 3.0, -2.0]).summaries(0.95).unwrap();
    let ranked: Vec<_> = summary.ranked().iter().map(|case| (case.index, case.value)).collect();
    assert_eq!(ranked, [(4, -2.0), (1, 1.0), (0, 3.0), (3, 3.0)]);
    assert_eq!(summary.best().unwrap().index, 4);
    assert_eq!(summary.worst().unwrap().index, 3);
}
