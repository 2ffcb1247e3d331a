//! Wilson's interval against the test that it inverts.

use crate::support::given;

/// Runs of which the first `failed` fail.
fn failing(failed: usize, n: usize) -> brunovsky::ensemble::Runs<1> {
    let values: Vec<f64> = (0..n).map(|k| if k < failed { f64::NAN } else { 1.0 }).collect();
    given(&values)
}

/// The ends are where |k − n·p| = z·√(n·p·(1 − p)); z = 1.959963984540054 is the 0.975-quantile of the normal distribution, by tables.
#[test]
fn the_ends_of_the_interval_are_those_of_the_score_test() {
    let z = 1.959_963_984_540_054;
    for n in [1_usize, 10, 400] {
        for k in [0, 1, n / 3, n - 1, n] {
            let rate = failing(k, n).failure_rate(0.95).unwrap();
            let (n, k) = (n as f64, k as f64);
            assert_eq!(rate.value, k / n);
            assert!(0.0 <= rate.low && rate.covers(rate.value) && rate.high <= 1.0);
            for p in [rate.low, rate.high] {
                let (distance, reach) = ((k - n * p).abs(), z * (n * p * (1.0 - p)).sqrt());
                // At p = 0 and p = 1 both are 0.
                approx::assert_relative_eq!(distance, reach, max_relative = 1e-9, epsilon = 1e-12);
            }
        }
    }
}

#[test]
fn without_a_failure_the_interval_is_the_closed_form() {
    // k = 0: n·p = z²·(1 − p), p = z²/(n + z²).
    let z2 = 1.959_963_984_540_054_f64.powi(2);
    let rate = failing(0, 100).failure_rate(0.95).unwrap();
    assert_eq!((rate.value, rate.low), (0.0, 0.0));
    approx::assert_relative_eq!(rate.high, z2 / (100.0 + z2), max_relative = 1e-12);
}
