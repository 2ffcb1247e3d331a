//! The sensors of the robot study against their statistics.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used)]

#[path = "../examples/paper/mobile_robot/sensors.rs"]
mod sensors;

use brunovsky::prelude::*;
use sensors::{Accuracy, Sensed};

/// A controller that answers with (θ, v) as it sees them.
#[derive(Clone)]
struct Echo;

impl Controller<4, 2> for Echo {
    type Scalar = f64;
    type Reference = ();
    type Command = SVector<f64, 2>;

    fn update_if(
        &mut self,
        seen: &Measurement<f64, 4, 2>,
        (): &(),
        _dt: f64,
        accept: Accept<SVector<f64, 2>>,
    ) -> Result<SVector<f64, 2>, Error> {
        let decided = SVector::from([seen.x[2], seen.x[3]]);
        accept(&decided)?;
        Ok(decided)
    }

    fn reset(&mut self) {}
}

/// (g_x, g_y, θ, v) as seen, `count` times `dt` apart, of a robot that stands at the origin.
fn seen(seed: u64, dt: f64, count: usize) -> Vec<[f64; 4]> {
    let mut sensed = Sensed::new(Echo, Accuracy::rtk(0.04), seed);
    let truth = Measurement::new([0.0; 5]).with_rate([0.0; 5]);
    let mut sample = |_| {
        let command = sensed.update(&truth, &(), dt).unwrap();
        [command.gnss[0], command.gnss[1], command.decided[0], command.decided[1]]
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
    let samples = seen(1, 600.0, 100_000);
    let within = mean(samples.iter().map(|s| f64::from(u8::from(s[0].hypot(s[1]) <= 0.04))));
    approx::assert_abs_diff_eq!(within, 0.95, epsilon = 0.0035);
    for (i, deviation) in [(2, 0.005_f64), (3, 0.01)] {
        let variance = mean(samples.iter().map(|s| s[i] * s[i]));
        approx::assert_relative_eq!(variance, deviation * deviation, max_relative = 0.025);
    }
}

/// Between neighbours the wander keeps e^(−dt/60) of itself and the white part nothing: with σ² = 0.04²/(2·ln 20) in all and 0.005² white,
/// the correlation at dt = 6 s is (1 − 0.005²/σ²)·e^(−0.1).
#[test]
fn the_position_wanders_with_its_time_constant() {
    let samples = seen(2, 6.0, 1_000_000);
    let variance = 0.04 * 0.04 / (2.0 * 20.0_f64.ln());
    let wanted = (1.0 - 0.005 * 0.005 / variance) * (-0.1_f64).exp();
    for axis in [0, 1] {
        let product = mean(samples.windows(2).map(|pair| pair[0][axis] * pair[1][axis]));
        // Some 10⁶·0.1/2 independent stretches: 0.5 % of deviation.
        approx::assert_relative_eq!(product / variance, wanted, max_relative = 0.025);
    }
}

#[test]
fn the_same_seed_gives_the_same_noise_and_another_one_another() {
    assert_eq!(seen(3, 0.2, 100), seen(3, 0.2, 100));
    assert_ne!(seen(3, 0.2, 100), seen(4, 0.2, 100));
}
