//! Model reference adaptive control against its Lyapunov function, a drift in closed form, and bounds that follow from the law.

mod failures;
mod law;
mod robustness;
mod sampling;

use brunovsky::{
    controller::{Controller, ModelReferenceAdaptive, Reference, Regressor},
    plant::{IntegratorChain, Plant},
    simulation::{Sample, Simulation},
};
use nalgebra::SVector;

use crate::support::flc;

type Adaptive<F, const N: usize, const L: usize> =
    ModelReferenceAdaptive<IntegratorChain<f64, N>, F, N, L>;

/// Around the chain, with all poles at −λ and Q = I.
fn adaptive<F: Regressor<f64, N, L>, const N: usize, const L: usize>(
    lambda: f64,
    regressor: F,
    rate: f64,
) -> Adaptive<F, N, L> {
    let base = flc(IntegratorChain::new(), lambda);
    ModelReferenceAdaptive::new(base, regressor, rate, [1.0; N]).unwrap()
}

/// φ = 1: a constant that nobody knows.
fn constant<const N: usize>(_: &SVector<f64, N>) -> SVector<f64, 1> {
    SVector::from([1.0])
}

/// The samples of a loop, each with the controller as it was then.
fn watched<C, const N: usize>(
    plant: &impl Plant<N, 1, Scalar = f64>,
    mut controller: C,
    reference: impl Fn(f64) -> Reference<f64, N>,
    x0: [f64; N],
    dt: f64,
    count: usize,
    mut watch: impl FnMut(&Sample<f64, Reference<f64, N>, C::Command, N, 1>, &C),
) where
    C: Controller<N, 1, Scalar = f64, Reference = Reference<f64, N>> + Clone,
{
    // A copy sees what the controller in the simulation sees, one sample after the other.
    let run = Simulation::new(plant, controller.clone(), reference, x0, dt).unwrap();
    let mut u = [0.0].into();
    for sample in run.take(count) {
        let sample = sample.unwrap();
        let measurement = brunovsky::controller::Measurement::new(sample.x).with_applied(u);
        controller.update(&measurement, &sample.reference, dt).unwrap();
        u = sample.u;
        watch(&sample, &controller);
    }
}
