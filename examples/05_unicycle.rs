//! A unicycle robot on slippery ground follows a figure eight: feedback linearization alone, and with learning.
//!
//! Its tracks drive 0.8 and turn 0.7 of what they are told, which the controller does not know. Each axis sees that as an
//! uncertainty of its acceleration; feedback alone has to hold it with an error, the learned terms take it over.

use brunovsky::{
    controller::{
        ChainControllers,
        unicycle::{Direction, Standstill, UnicycleController, feedforward_speed, heading},
    },
    plant::{IntegratorChain, Unicycle},
    prelude::*,
    trajectory::{FigureEight, Trajectory},
};

const DT: f64 = 0.02;

/// The state (p_x, p_y, θ, v) after a period in which the tracks go over to the speed `v` and turn at `omega`; v over ground.
fn slipping(x: SVector<f64, 4>, v: f64, omega: f64) -> Result<SVector<f64, 4>, Error> {
    let input = SVector::from([(0.8 * v - x[3]) / DT, 0.7 * omega]);
    Rk4.integrate(|t, x| Unicycle::new().derivative(t, x, &input), 0.0, &x, DT, 4)
}

/// One sample of the loop: the distance from the reference, the accelerations decided on each axis, and the state after the period.
fn sample<C: ChainControllers<f64, 2, 2>>(
    controller: &mut UnicycleController<f64, C>,
    reference: &[Reference<f64, 2>; 2],
    x: &mut SVector<f64, 4>,
) -> Result<(f64, C::Commands), Error> {
    let command = controller.update(&Measurement::new(*x), reference, DT)?;
    let distance = (reference[0].r[0] - x[0]).hypot(reference[1].r[0] - x[1]);
    *x = slipping(*x, command.v, command.omega)?;
    Ok((distance, command.decoupled.chains))
}

fn main() -> Result<(), Error> {
    let eight = FigureEight::new(4.0, 2.0, 0.2)?;
    let axis = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(1.0)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([1.0, 1.0])?;
    let rule = SlidingMode::new(2.0)?.with_switching(Switching::Implicit { delta: 0.02 })?;
    let learning = Clelc::new(axis, NeuroFuzzy::new(network, ModelAided::new(), rule));
    let (direction, standstill) = (Direction::Forward, Standstill::Refuse);
    let mut flc = UnicycleController::new([axis; 2], direction, 0.05, standstill)?;
    let mut clelc = UnicycleController::new([learning; 2], direction, 0.05, standstill)?;

    let start = eight.references(0.0);
    let (theta, v) = (heading(&start, direction)?, feedforward_speed(&start, direction));
    let mut without = SVector::from([0.0, 0.0, theta, v]);
    let mut with = without;
    println!("          distance in m            learned in m/s²");
    println!("  t in s      FLC    CLELC       along x   along y");
    for k in 0..=1600 {
        let t = f64::from(k) * DT;
        let reference = eight.references(t);
        let (off, _) = sample(&mut flc, &reference, &mut without)?;
        let (learned_off, [x, y]) = sample(&mut clelc, &reference, &mut with)?;
        if k % 200 == 0 {
            println!("{t:8.1} {off:8.4} {learned_off:8.4}      {:8.4}  {:8.4}", x.u_n, y.u_n);
        }
    }
    Ok(())
}
