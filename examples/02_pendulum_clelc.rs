//! The same pendulum carries twice the mass that the controller believes: feedback linearization alone, and with learning.
//!
//! The wrong mass is an uncertainty Δ = (b − b̂)·u (the drift does not depend on the mass but for the friction). Feedback alone
//! has to hold it with an error of −Δ/k₁; the learned term takes it over, and the error goes to zero.

use core::f64::consts::FRAC_PI_2;

use brunovsky::{plant::Pendulum, prelude::*};

fn main() -> Result<(), Error> {
    let believed = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
    let true_one = Pendulum::new(2.0, 0.5, 0.1, 9.81)?;
    let horizontal = |_t| Reference::setpoint(FRAC_PI_2);

    let mut flc = FeedbackLinearization::new(believed, Gains::from_lambda(4.0)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([2.0, 4.0])?;
    let rule = SlidingMode::new(200.0)?;
    let mut clelc = Clelc::new(flc, NeuroFuzzy::new(network, BackwardDifference::new(), rule));

    let without =
        Simulation::new(&true_one, &mut flc, horizontal, [0.0, 0.0], 0.005)?.until(3.0)?;
    let with = Simulation::new(&true_one, &mut clelc, horizontal, [0.0, 0.0], 0.005)?.until(3.0)?;

    println!("            FLC                  CLELC");
    println!("  t in s    e in rad      u_b    e in rad      u_b      u_n   (u_b, u_n in rad/s²)");
    for (flc, clelc) in without.zip(with).step_by(100) {
        let (flc, clelc) = (flc?, clelc?);
        let e = |x: SVector<f64, 2>| FRAC_PI_2 - x[0];
        let (a, b) = (flc.command, clelc.command);
        println!(
            "{:8.1} {:11.5} {:8.3} {:11.5} {:8.3} {:8.3}",
            flc.t,
            e(flc.x),
            a.u_b,
            e(clelc.x),
            b.u_b,
            b.u_n
        );
    }
    Ok(())
}
