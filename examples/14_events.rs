//! A bouncing ball with an adaptive method: events where it meets the floor or turns back, and a state that jumps.
//!
//! The ball falls from 1 m and keeps 80 % of its speed at each impact. In closed form impact n comes at √(2·h/g)·(1 + 2·(0.8 + … + 0.8ⁿ⁻¹)), and the
//! arc after it rises to h·0.8²ⁿ.

use brunovsky::{
    integrators::{Crossing, Events},
    prelude::*,
};

const GRAVITY: f64 = 9.81;
const KEPT: f64 = 0.8;

fn main() -> Result<(), Error> {
    let falling = |_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -GRAVITY]);
    // The floor stops the solver, so that the ball can be turned around; a top is only reported.
    let mut events = Events::new(
        |_t, x: &SVector<f64, 2>| [x[0], x[1]],
        [Crossing::falling().terminal(), Crossing::falling()],
    );
    let method = Adaptive::new(DormandPrince, Tolerance::new(1e-9, 1e-12)?);
    let mut ball = method.solve(falling, 0.0, [1.0, 0.0])?;

    let fall = (2.0 / GRAVITY).sqrt();
    let (mut impacts, mut expected) = (0, fall);
    while let Some(event) = ball.next_event(2.5, &mut events)? {
        if event.terminal {
            println!("impact at {:.9} s, off by {:8.1e} s", event.t, event.t - expected);
            ball.restart([0.0, -KEPT * event.x[1]])?;
            impacts += 1;
            expected += 2.0 * fall * KEPT.powi(impacts);
        } else {
            let height = KEPT.powi(2 * impacts);
            println!("   top at {:.9} s, off by {:8.1e} m", event.t, event.x[0] - height);
        }
    }
    let spent = ball.statistics();
    println!("{} steps, {} evaluations of f", spent.accepted, spent.evaluations);
    Ok(())
}
