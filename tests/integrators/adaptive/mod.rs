//! Steps that follow from a tolerance: accuracy, cost, discontinuities, invariances, failures.

mod accuracy;
mod cost;
mod discontinuities;
mod failures;
mod invariances;
mod outputs;

use brunovsky::{
    Scalar,
    integrators::{Adaptive, Embedded, Solver, Tolerance},
};
use nalgebra::SVector;

fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// A pendulum with friction, driven by a torque that depends on time.
fn pendulum<T: Scalar>(t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
    SVector::from([x[1], -x[0].sin() - x[1] * num(0.1) + t.cos()])
}

fn start<M, T: Scalar, F, const N: usize>(
    method: M,
    tolerance: f64,
    f: F,
    x0: [f64; N],
) -> Solver<'static, M, F, T, N>
where
    M: Embedded<T, N>,
    F: FnMut(T, &SVector<T, N>) -> SVector<T, N>,
{
    let tolerance = Tolerance::new(num(tolerance), num(tolerance)).unwrap();
    Adaptive::new(method, tolerance).solve(f, T::zero(), x0.map(num)).unwrap()
}
