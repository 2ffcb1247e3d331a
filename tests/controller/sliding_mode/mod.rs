//! Sliding-mode controllers: the surface, the laws in samples, what they leave of σ, and when they get there.

mod integral;
mod sliding_mode_control;
mod super_twisting;
mod surface;

use brunovsky::controller::{Command, Controller, Measurement, Reference};

/// A loop of order 1 whose samples are exact: x(k+1) = x(k) + h·(u(k) + Δ(k)) towards r = 0, so σ = −x.
///
/// Δ(k) comes from `delta`, which sees the command of its period. The commands and the Δ of all periods.
pub fn exact_loop<C>(
    controller: &mut C,
    sigma0: f64,
    dt: f64,
    periods: usize,
    mut delta: impl FnMut(usize, &C::Command) -> f64,
) -> Vec<(C::Command, f64)>
where
    C: Controller<1, 1, Scalar = f64, Reference = Reference<f64, 1>>,
{
    let mut x = -sigma0;
    let period = |k| {
        let command =
            controller.update(&Measurement::new([x]), &Reference::setpoint(0.0), dt).unwrap();
        let delta = delta(k, &command);
        x += dt * (command.input()[0] + delta);
        (command, delta)
    };
    (0..periods).map(period).collect()
}
