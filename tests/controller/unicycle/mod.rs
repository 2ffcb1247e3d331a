//! The unicycle robot: planar references, the dynamic extension, and the loops that they close.

mod dynamic_extension;
mod guarded;
mod planar;
mod standstill;
mod symmetry;
mod tracking;
mod traction;

use brunovsky::{
    controller::{
        ChainControllers, Controller, FeedbackLinearization, Measurement, Reference,
        unicycle::{
            Direction, Standstill, UnicycleCommand, UnicycleController, feedforward_speed, heading,
        },
    },
    integrators::{Integrator, Rk4},
    plant::{IntegratorChain, Plant, Unicycle},
};
use nalgebra::SVector;

use crate::support;

/// (p_x, p_y, θ, v).
type State = SVector<f64, 4>;
/// One reference an axis.
type Planar = [Reference<f64, 2>; 2];
/// Feedback linearization of one axis.
type Axis = FeedbackLinearization<IntegratorChain<f64, 2>, 2>;

/// Both axes with their poles at −λ.
fn flc(lambda: f64) -> [Axis; 2] {
    [support::flc(IntegratorChain::new(), lambda); 2]
}

/// A controller that refuses a speed below 1 mm/s.
fn refusing<C: ChainControllers<f64, 2, 2>>(
    axes: C,
    direction: Direction,
) -> UnicycleController<f64, C> {
    UnicycleController::new(axes, direction, 1e-3, Standstill::Refuse).unwrap()
}

/// How the drives get from one speed command to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Drives {
    /// At once, and then they hold it: what most motor controllers do with a set point.
    Held,
    /// Evenly over the period, as v̇ = ξ has it.
    Ramped,
}

/// A robot whose tracks slip: over ground it drives μ·v and turns κ·ω. Its state holds the speed over ground.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Robot {
    drives: Drives,
    mu: f64,
    kappa: f64,
}

impl Robot {
    /// One that does as it is told.
    fn exact(drives: Drives) -> Self {
        Self { drives, mu: 1.0, kappa: 1.0 }
    }

    /// The state after a period `h` under the command (v, ω).
    fn after(&self, mut x: State, [v, omega]: [f64; 2], h: f64) -> State {
        let over_ground = self.mu * v;
        let xi = match self.drives {
            Drives::Held => {
                x[3] = over_ground;
                0.0
            }
            Drives::Ramped => (over_ground - x[3]) / h,
        };
        let input = SVector::from([xi, self.kappa * omega]);
        // Four steps a period leave an error of order h⁴, far below what the hold of the input leaves.
        Rk4.integrate(|t, x| Unicycle::new().derivative(t, x, &input), 0.0, &x, h, 4).unwrap()
    }
}

/// The robot on the reference at its speed and heading.
fn on(reference: &Planar, direction: Direction) -> State {
    let theta = heading(reference, direction).unwrap();
    let v = feedforward_speed(reference, direction);
    [reference[0].r[0], reference[1].r[0], theta, v].into()
}

/// One sample of the loop.
struct Step<D> {
    t: f64,
    x: State,
    /// The position error e = r − p and its rate.
    e: [SVector<f64, 2>; 2],
    command: UnicycleCommand<f64, D>,
}

impl<D> Step<D> {
    /// The distance from the reference.
    fn distance(&self) -> f64 {
        self.e[0][0].hypot(self.e[1][0])
    }
}

/// All samples of the loop from `x` until `t_end`; only the state is measured.
fn run<C: ChainControllers<f64, 2, 2>>(
    robot: Robot,
    mut controller: UnicycleController<f64, C>,
    reference: impl Fn(f64) -> Planar,
    mut x: State,
    h: f64,
    t_end: f64,
) -> Vec<Step<C::Commands>> {
    let periods = (t_end / h).round() as u32;
    (0..=periods)
        .map(|k| {
            let t = f64::from(k) * h;
            let r = reference(t);
            let command = controller.update(&Measurement::new(x), &r, h).unwrap();
            let speed = [x[3] * x[2].cos(), x[3] * x[2].sin()];
            let e = core::array::from_fn(|i| r[i].r - SVector::from([x[i], speed[i]]));
            let asked = [command.v, command.omega];
            let step = Step { t, x, e, command };
            x = robot.after(x, asked, h);
            step
        })
        .collect()
}

/// The exponent p for which `error` falls like hᵖ.
fn order(error: impl Fn(f64) -> f64, h: f64) -> f64 {
    (error(h) / error(h / 2.0)).log2()
}
