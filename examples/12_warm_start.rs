//! A controller goes on the next day with what it has learned: saved as text, and loaded again.

use core::f64::consts::FRAC_PI_2;

use brunovsky::{plant::Pendulum, prelude::*};

type Learner = NeuroFuzzy<f64, ModelAided<f64>, SlidingMode<f64>, 2, 3>;
type Loop = Clelc<Pendulum<f64>, Learner, 2>;

/// How far a pendulum sags, in rad, that is to be held horizontal and carries half as much again as the controller believes.
fn sag(controller: &mut Loop, seconds: f64) -> Result<f64, Error> {
    let loaded = Pendulum::new(1.5, 0.5, 0.1, 9.81)?;
    let horizontal = |_t| Reference::setpoint(FRAC_PI_2);
    let run = Simulation::new(&loaded, controller, horizontal, [FRAC_PI_2, 0.0], 0.005)?;
    run.until(seconds)?
        .try_fold(0.0, |lowest: f64, sample| Ok(lowest.max(FRAC_PI_2 - sample?.x[0])))
}

fn main() -> anyhow::Result<()> {
    let believed = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
    let flc = FeedbackLinearization::new(believed, Gains::from_lambda(4.0)?);
    let network = FuzzyNetwork::evenly_spaced([2.0, 4.0])?;
    let rule = SlidingMode::new(20.0)?;
    let mut clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));
    println!("sag on the first day  {:.6} rad", sag(&mut clelc, 5.0)?);

    let file = serde_json::to_string_pretty(&clelc)?;
    let mut warm: Loop = serde_json::from_str(&file)?;
    assert_eq!(warm, clelc, "what is loaded is what was saved, to the last bit");
    println!("sag on the next       {:.6} rad", sag(&mut warm, 5.0)?);

    let hostile = file.replacen("\"width\": ", "\"width\": -", 1);
    if let Err(error) = serde_json::from_str::<Loop>(&hostile) {
        println!("a file with a negative width is refused: {error}");
    }
    Ok(())
}
