//! A pendulum swings up and stays upright under feedback linearization control, with a model that is right.
//!
//! The law cancels gravity, so the error obeys (p + λ)²e = 0 wherever the pendulum is: a double pole, no overshoot.

use core::f64::consts::PI;

use brunovsky::{plant::Pendulum, prelude::*};

fn main() -> Result<(), Error> {
    // 1 kg at 0.5 m, 0.1 N·m·s/rad of friction.
    let pendulum = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
    let mut flc = FeedbackLinearization::new(pendulum, Gains::from_lambda(4.0)?);

    let hanging = [0.0, 0.0];
    let upright = |_t| Reference::setpoint(PI);
    let run = Simulation::new(&pendulum, &mut flc, upright, hanging, 0.005)?;
    let samples = run.until(3.0)?.collect::<Result<Vec<_>, _>>()?;

    println!("  t in s   θ in rad   τ in N·m");
    for sample in samples.iter().step_by(100) {
        println!("{:8.1} {:10.4} {:10.4}", sample.t, sample.x[0], sample.u[0]);
    }

    let response = StepInfo::of(samples.iter().map(|sample| (sample.t, sample.x[0])), 0.0, PI)?;
    println!(
        "settled to 2 % after {:.2} s, overshoot {:.2} %",
        response.settling_time().unwrap_or(f64::NAN),
        response.overshoot()
    );
    Ok(())
}
