//! Your own plant from outside the crate: give it a drift and an input gain, and everything else is there.

use brunovsky::prelude::*;

/// An underwater vehicle on a line: m·ẍ = F − d·|ẋ|·ẋ. State (x, ẋ) in m and m/s, input F in N.
struct Vehicle {
    mass: f64, // m in kg
    drag: f64, // d in kg/m
}

impl FeedbackLinearizable<2> for Vehicle {
    type Scalar = f64;
    fn drift(&self, x: &SVector<f64, 2>) -> f64 {
        -self.drag / self.mass * x[1].abs() * x[1]
    }
    fn input_gain(&self, _: &SVector<f64, 2>) -> f64 {
        1.0 / self.mass
    }
}

fn main() -> Result<(), Error> {
    let model = Vehicle { mass: 200.0, drag: 50.0 }; // what the controller believes
    let truth = Vehicle { mass: 260.0, drag: 110.0 }; // what it meets

    let flc = FeedbackLinearization::new(model, Gains::from_lambda(1.0)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([1.0, 1.0])?;
    let learner = NeuroFuzzy::new(network, BackwardDifference::new(), SlidingMode::new(2.0)?);
    let mut clelc = Clelc::new(flc, learner);

    let wave = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
    let run = Simulation::new(&truth, &mut clelc, wave, [0.5, 0.0], 0.01)?;
    for sample in run.until(20.0)?.step_by(400) {
        let sample = sample?;
        let e = sample.reference.r - sample.x;
        let (u_b, u_n) = (sample.command.u_b, sample.command.u_n);
        println!("t = {:4.1}  e = {:8.5}  u_b = {u_b:8.5}  u_n = {u_n:8.5}", sample.t, e[0]);
    }
    Ok(())
}
