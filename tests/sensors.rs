//! The sensors of the robot study against their statistics.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used)]

#[path = "../examples/paper/mobile_robot/sensors.rs"]
mod sensors;

use brunovsky::{
    nalgebra::SVector,
    simulation::{Sensor, Truth},
};
use sensors::Accuracy;

/// (g_x, g_y, θ, v) as seen, `count` times `dt` apart, of a robot at the origin that heads for `heading` with 1 m/s.
fn seen(seed: u64, heading: f64, dt: f64, count: usize) -> Vec<SVector<f64, 4>> {
    let mut sensors = Accuracy::rtk(0.04).sensors(seed).unwrap();
    let (sin, cos) = heading.sin_cos();
    let truth = Truth {
        t: 0.0,
        x: SVector::from([0.0, 0.0, heading, 1.0, 0.0]),
        x_dot: SVector::from([cos, sin, 0.0, 0.0, 0.0]),
        u: SVector::zeros(),
    };
    let mut sample = |_| {
        let (next, seen) = sensors.sensed(&truth, dt).unwrap();
        sensors = next;
        seen.x
    };
    (0..count).map(&mut sample).collect()
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}

/// Ten time constants apart the wander is new each time; of 10⁵ shares of 0.95 the standard deviation is 0.0007, of variances 0.5 %.
#[test]
fn the_sensors_are_as_accurate_as_they_say() {
    let samples = seen(1, 2.5, 600.0, 100_000);
    let within = mean(samples.iter().map(|s| f64::from(u8::from(s[0].hypot(s[1]) <= 0.04))));
    approx::assert_abs_diff_eq!(within, 0.95, epsilon = 0.0035);
    for (i, truth, deviation) in [(2, 2.5, 0.005_f64), (3, 1.0, 0.01)] {
        let variance = mean(samples.iter().map(|s| (s[i] - truth).powi(2)));
        approx::assert_relative_eq!(variance, deviation * deviation, max_relative = 0.025);
    }
}

/// Between neighbours the wander keeps e^(−dt/60) of itself and the white part nothing: with σ² = 0.04²/(2·ln 20) in all and 0.005² white,
/// the correlation at dt = 6 s is (1 − 0.005²/σ²)·e^(−0.1).
#[test]
fn the_position_wanders_with_its_time_constant() {
    let samples = seen(2, 0.0, 6.0, 1_000_000);
    let variance = 0.04 * 0.04 / (2.0 * 20.0_f64.ln());
    let wanted = (1.0 - 0.005 * 0.005 / variance) * (-0.1_f64).exp();
    for axis in [0, 1] {
        let product = mean(samples.windows(2).map(|pair| pair[0][axis] * pair[1][axis]));
        // Some 10⁶·0.1/2 independent stretches: 0.5 % of deviation.
        approx::assert_relative_eq!(product / variance, wanted, max_relative = 0.025);
    }
}

/// Errors of different axes have nothing to do with each other, though they come from one seed.
#[test]
fn the_axes_are_independent() {
    let samples = seen(3, 0.0, 600.0, 100_000);
    for (i, j) in [(0, 1), (0, 2), (1, 3), (2, 3)] {
        let deviation = |i: usize| samples.iter().map(move |s| s[i] - f64::from(u8::from(i == 3)));
        let [of_i, of_j] = [i, j].map(|i| mean(deviation(i).map(|e| e * e)));
        let product = mean(deviation(i).zip(deviation(j)).map(|(a, b)| a * b));
        assert!((product / (of_i * of_j).sqrt()).abs() < 0.016, "{i} and {j}");
    }
}

#[test]
fn the_same_seed_gives_the_same_noise_and_another_one_another() {
    assert_eq!(seen(3, 0.0, 0.2, 100), seen(3, 0.0, 0.2, 100));
    assert_ne!(seen(3, 0.0, 0.2, 100), seen(4, 0.0, 0.2, 100));
}
