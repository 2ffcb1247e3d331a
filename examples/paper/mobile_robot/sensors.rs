//! What the robot's sensors make of its motion.

use brunovsky::{
    channel::{Noise, Wander},
    prelude::*,
    simulation::{Sensor, Sensors, Truth},
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Standard deviations of the sensors.
#[derive(Clone, Copy)]
pub struct Accuracy {
    /// GNSS position, the part that wanders (first-order Gauss–Markov), in m an axis.
    pub wander: f64,
    /// The time constant of that part in s.
    pub wander_time: f64,
    /// GNSS position, white part, in m an axis.
    pub white: f64,
    /// Speed over ground, in m/s.
    pub speed: f64,
    /// Heading, in rad.
    pub heading: f64,
}

impl Accuracy {
    /// An RTK-GNSS with 95 % of its horizontal errors within `radius` in m, and the other sensors of the study.
    ///
    /// The horizontal error of two independent axes of deviation σ exceeds r with probability exp(−r²/2σ²), so σ = r/√(2·ln 20).
    pub fn rtk(radius: f64) -> Self {
        let (sigma, white) = (radius / (2.0 * 20.0_f64.ln()).sqrt(), 0.005);
        let wander = (sigma * sigma - white * white).sqrt();
        Self { wander, wander_time: 60.0, white, speed: 0.01, heading: 0.005 }
    }

    /// Sensors whose noise follows from `seed` alone: they show (g_x, g_y, θ, v) where the robot has (p_x, p_y, θ, v_t, ω_t).
    pub fn sensors(
        &self,
        seed: u64,
    ) -> Result<impl Sensor<f64, 5, 2, Seen = Measurement<f64, 4, 2>> + use<>, Error> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let slow =
            Wander::new([self.wander, self.wander, 0.0, 0.0], self.wander_time, random.clone())?;
        random.set_stream(1);
        let white = Noise::new([self.white, self.white, self.heading, self.speed], random)?;
        Ok(Sensors::new(shown, (slow, white)))
    }
}

/// Position, heading, and speed over ground along it.
fn shown(truth: &Truth<f64, 5, 2>) -> SVector<f64, 4> {
    let (sin, cos) = truth.x[2].sin_cos();
    let speed = truth.x_dot[0] * cos + truth.x_dot[1] * sin;
    SVector::from([truth.x[0], truth.x[1], truth.x[2], speed])
}
