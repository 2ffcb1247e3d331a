//! Gains from a gradient: the whole loop of plant, controller and learning runs on dual numbers, so a cost of it can be differentiated.
//!
//! A pendulum with twice the mass that its controller believes follows a sine. The cost ∫(e² + ρ·τ̇²) dt weighs the error against the wear of the
//! drive; one run gives its exact gradient by λ and α, and an optimizer does the rest. The gains are ln λ and ln α, which keeps them positive.
//!
//! It asks for a loop without kinks. The implicit sign with δ > 0 has a continuous derivative; the set-valued one has a kink where s comes within
//! reach of zero, an actuator where it saturates: there the gradient is that of one side, and beyond, it does not know what was cut off.

use argmin::{
    core::{CostFunction, Executor, Gradient, State},
    solver::{linesearch::MoreThuenteLineSearch, quasinewton::LBFGS},
};
use brunovsky::{plant::Pendulum, prelude::*};

/// The cost of a run of 8 s with the gains (ln λ, ln α).
fn cost<T: Scalar>(gains: SVector<T, 2>) -> Result<T, Error> {
    let c = nalgebra::convert::<f64, T>;
    let [lambda, alpha] = gains.map(|gain| gain.exp()).into();
    let pendulum = |mass| Pendulum::new(c(mass), c(0.5), c(0.1), c(9.81));
    let (believed, truth) = (pendulum(1.0)?, pendulum(2.0)?);

    let flc = FeedbackLinearization::new(believed, Gains::from_lambda(lambda)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([c(0.5), c(1.0)])?;
    let rule = SlidingMode::new(alpha)?.with_switching(Switching::Implicit { delta: c(1.0) })?;
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));

    let dt = c(0.01);
    let sine = |t: T| Reference::new([t.sin(), t.cos()], -t.sin());
    let run = Simulation::new(&truth, clelc, sine, [T::zero(); 2], dt)?.substeps(2)?;
    let (mut cost, mut last) = (T::zero(), None);
    for sample in run.until(c(8.0))? {
        let sample = sample?;
        let (e, torque) = (sample.reference.r[0] - sample.x[0], sample.u[0]);
        let rate = (torque - last.unwrap_or(torque)) / dt;
        cost += (e * e + rate * rate * c(1e-6)) * dt;
        last = Some(torque);
    }
    Ok(cost)
}

struct Swing;

impl CostFunction for Swing {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, gains: &Vec<f64>) -> Result<f64, argmin::core::Error> {
        Ok(cost(SVector::<_, 2>::from_column_slice(gains))?)
    }
}

impl Gradient for Swing {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, gains: &Vec<f64>) -> Result<Vec<f64>, argmin::core::Error> {
        let (_, gradient) = num_dual::gradient(cost, &SVector::<_, 2>::from_column_slice(gains))?;
        Ok(gradient.as_slice().to_vec())
    }
}

fn main() -> Result<(), argmin::core::Error> {
    let start = SVector::from([2.0_f64, 20.0]).map(f64::ln);
    let (value, gradient) = num_dual::gradient(cost, &start)?;
    let differences = SVector::<f64, 2>::from_fn(|i, _| {
        let step = SVector::<f64, 2>::from_fn(|j, _| if i == j { 1e-5 } else { 0.0 });
        let at = |gains| cost::<f64>(gains).unwrap_or(f64::NAN);
        (at(start + step) - at(start - step)) / 2e-5
    });
    println!("∂cost/∂(ln λ, ln α) at λ = 2/s, α = 20 rad/s³");
    println!("  by dual numbers        {:12.8} {:12.8}", gradient[0], gradient[1]);
    println!("  by central differences {:12.8} {:12.8}", differences[0], differences[1]);

    let solver = LBFGS::new(MoreThuenteLineSearch::new(), 5).with_tolerance_grad(1e-6)?;
    let tuned = Executor::new(Swing, solver)
        .configure(|state| state.param(start.as_slice().to_vec()).max_iters(40))
        .run()?;
    let state = tuned.state();
    let best = state.get_best_param().ok_or(argmin::core::Error::msg("no gains"))?;
    println!("             λ in 1/s   α in rad/s³       cost");
    println!("  at first {:10.3} {:13.3} {:10.6}", start[0].exp(), start[1].exp(), value);
    println!(
        "  tuned    {:10.3} {:13.3} {:10.6}",
        best[0].exp(),
        best[1].exp(),
        state.get_best_cost()
    );
    println!("  in {} steps: {}", state.get_iter(), state.get_termination_status());
    Ok(())
}
