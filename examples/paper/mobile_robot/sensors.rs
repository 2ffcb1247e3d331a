//! What the robot's sensors make of its motion, and what a controller sees of them.

use brunovsky::prelude::*;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

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
}

/// A controller of the unicycle behind the sensors of a tracked robot: it sees (g_x, g_y, θ, v) where the robot has
/// (p_x, p_y, θ, v_t, ω_t).
#[derive(Clone)]
pub struct Sensed<C> {
    controller: C,
    accuracy: Accuracy,
    wander: [f64; 2],
    random: ChaCha8Rng,
}

/// A command and the GNSS position that it was decided on.
#[derive(Clone, Copy)]
pub struct SensedCommand<D> {
    /// The position as the GNSS had it.
    pub gnss: [f64; 2],
    /// What the controller decided.
    pub decided: D,
}

impl<D: Command<f64, 2>> Command<f64, 2> for SensedCommand<D> {
    fn input(&self) -> SVector<f64, 2> {
        self.decided.input()
    }
}

impl<C> Sensed<C> {
    /// `controller` behind sensors whose noise follows from `seed` alone.
    pub fn new(controller: C, accuracy: Accuracy, seed: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        // The wander starts in its stationary distribution.
        let wander = [0, 1].map(|_| accuracy.wander * normal(&mut random));
        Self { controller, accuracy, wander, random }
    }
}

fn normal(random: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(random)
}

impl<C> Controller<5, 2> for Sensed<C>
where
    C: Controller<4, 2, Scalar = f64>,
{
    type Scalar = f64;
    type Reference = C::Reference;
    type Command = SensedCommand<C::Command>;

    fn update_if(
        &mut self,
        truth: &Measurement<f64, 5, 2>,
        reference: &C::Reference,
        dt: f64,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let accuracy = self.accuracy;
        let (mut random, mut wander) = (self.random.clone(), self.wander);
        let kept = (-dt / accuracy.wander_time).exp();
        for wander in &mut wander {
            let fresh = accuracy.wander * (1.0 - kept * kept).sqrt();
            *wander = *wander * kept + fresh * normal(&mut random);
        }
        let x_dot = truth.x_dot.ok_or(Error::Missing { name: "velocity over ground" })?;
        let (sin, cos) = truth.x[2].sin_cos();
        let gnss = [0, 1].map(|i| truth.x[i] + wander[i] + accuracy.white * normal(&mut random));
        let heading = truth.x[2] + accuracy.heading * normal(&mut random);
        let speed = x_dot[0] * cos + x_dot[1] * sin + accuracy.speed * normal(&mut random);
        let seen = Measurement {
            x: SVector::from([gnss[0], gnss[1], heading, speed]),
            x_dot: None,
            applied: truth.applied,
        };
        let decided = self.controller.update_if(&seen, reference, dt, &mut |decided| {
            accept(&SensedCommand { gnss, decided: *decided })
        })?;
        (self.random, self.wander) = (random, wander);
        Ok(SensedCommand { gnss, decided })
    }

    fn reset(&mut self) {
        self.controller.reset();
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.controller.set_learning(mode);
    }
}
