use anyhow::Result;
use brunovsky::{
    integrators::{Adaptive, DormandPrince, Embedded, Linearization, Rodas, Tolerance},
    nalgebra::{SMatrix, SVector},
};

use crate::{
    measure::{jacobian, rate},
    problems::Problem,
};

fn solve<P: Problem<N>, const N: usize, const COUNT: bool>(
    method: impl Embedded<f64, N>,
    rtol: f64,
) -> Result<[f64; N]> {
    let tolerance = Tolerance::per_component(rtol, P::ABSOLUTE.map(|unit| unit * rtol))?;
    let f = |_: f64, x: &SVector<f64, N>| SVector::from(rate::<P, N, COUNT>(&(*x).into()));
    let settings = Adaptive::new(method, tolerance).with_step_limit(10_000_000)?;
    let mut solver = settings.solve(f, 0.0, P::START)?;
    Ok((*solver.advance(P::END)?).into())
}

fn exact<P: Problem<N>, const N: usize, const COUNT: bool>(
    _: f64,
    x: &SVector<f64, N>,
) -> Linearization<f64, N> {
    let rows = jacobian::<P, N, COUNT>(&(*x).into(), N);
    Linearization { x: SMatrix::from_fn(|i, j| rows[i][j]), t: SVector::zeros() }
}

pub fn dormand_prince<P: Problem<N>, const N: usize>(rtol: f64, count: bool) -> Result<[f64; N]> {
    if count {
        solve::<P, N, true>(DormandPrince, rtol)
    } else {
        solve::<P, N, false>(DormandPrince, rtol)
    }
}

pub fn rodas<P: Problem<N>, const N: usize>(rtol: f64, count: bool) -> Result<[f64; N]> {
    if count {
        solve::<P, N, true>(Rodas::with_jacobian(exact::<P, N, true>), rtol)
    } else {
        solve::<P, N, false>(Rodas::with_jacobian(exact::<P, N, false>), rtol)
    }
}

pub fn rodas_by_differences<P: Problem<N>, const N: usize>(
    rtol: f64,
    count: bool,
) -> Result<[f64; N]> {
    if count {
        solve::<P, N, true>(Rodas::autonomous(), rtol)
    } else {
        solve::<P, N, false>(Rodas::autonomous(), rtol)
    }
}
