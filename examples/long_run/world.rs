//! The plant, what disturbs it, and its sensors.

use brunovsky::nalgebra::SVector;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

/// The period in seconds.
pub const DT: f64 = 0.01;
/// The mean of Δ in m/s², how far it goes from there, and how fast it may, in m/s³.
const MEAN: f64 = 5.0;
const SPAN: f64 = 0.25;
const BOUND: f64 = 1.0;
/// The standard deviations of the sensors: position in m, speed in m/s, acceleration in m/s².
const NOISE: [f64; 3] = [1e-4, 5e-4, 0.05];

/// ẍ = u + Δ with Δ constant over a period, moved without an error of integration. Δ walks at random within its span.
pub struct World {
    pub x: SVector<f64, 2>,
    pub delta: f64,
    acceleration: f64,
    random: ChaCha8Rng,
}

impl World {
    pub fn new() -> Self {
        let random = ChaCha8Rng::seed_from_u64(1);
        Self { x: [0.03, 0.0].into(), delta: MEAN, acceleration: MEAN, random }
    }

    /// The state with white noise.
    pub fn measured(&mut self) -> SVector<f64, 2> {
        self.x + SVector::from([self.noise(0), self.noise(1)])
    }

    /// ẋ with white noise, at the end of the last period.
    pub fn rate(&mut self) -> SVector<f64, 2> {
        SVector::from([self.x[1], self.acceleration + self.noise(2)])
    }

    /// A period under the input `u`.
    pub fn move_on(&mut self, u: f64) {
        self.acceleration = u + self.delta;
        self.x[0] += DT * (self.x[1] + 0.5 * DT * self.acceleration);
        self.x[1] += DT * self.acceleration;
        let walked = self.delta - MEAN + BOUND * DT * self.random.random_range(-1.0..1.0);
        // Reflected at the ends of its span.
        let beyond = (walked.abs() - SPAN).max(0.0).copysign(walked);
        self.delta = MEAN + walked - 2.0 * beyond;
    }

    fn noise(&mut self, sensor: usize) -> f64 {
        NOISE[sensor] * self.random.sample::<f64, _>(StandardNormal)
    }
}
