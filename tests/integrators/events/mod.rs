//! Events: when and in which order they are found, and when not.

mod bouncing_ball;
mod failures;
mod grazing;
mod order;

use brunovsky::{
    Scalar,
    integrators::{Adaptive, DormandPrince, Events, Occurrence, Solver, Tolerance},
};
use nalgebra::SVector;

fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

type Field<T> = fn(T, &SVector<T, 1>) -> SVector<T, 1>;

/// ẋ = 1 from x(0) = 0: x is the time, and steps grow tenfold.
fn clock<T: Scalar>() -> Solver<'static, DormandPrince, Field<T>, T, 1> {
    let tolerance = Tolerance::new(num(1e-3), num(1e-3)).unwrap();
    let f: Field<T> = |_, _| SVector::from([T::one()]);
    Adaptive::new(DormandPrince, tolerance).solve(f, T::zero(), [T::zero()]).unwrap()
}

/// All events up to `end`.
fn all<F, G, const N: usize, const M: usize>(
    solver: &mut Solver<DormandPrince, F, f64, N>,
    events: &mut Events<G, f64, M>,
    end: f64,
) -> Vec<Occurrence<f64, N>>
where
    F: FnMut(f64, &SVector<f64, N>) -> SVector<f64, N>,
    G: FnMut(f64, &SVector<f64, N>) -> [f64; M],
{
    core::iter::from_fn(|| solver.next_event(end, events).unwrap()).collect()
}
