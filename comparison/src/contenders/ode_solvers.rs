use anyhow::{Context, Result, anyhow};
use ode_solvers::{Dop853, Dopri5, OutputType, SVector, System};

use crate::{measure::rate, problems::Problem};

struct Of<P, const COUNT: bool>(std::marker::PhantomData<P>);

impl<P: Problem<N>, const N: usize, const COUNT: bool> System<f64, SVector<f64, N>>
    for Of<P, COUNT>
{
    fn system(&self, _: f64, y: &SVector<f64, N>, dy: &mut SVector<f64, N>) {
        *dy = SVector::from(rate::<P, N, COUNT>(&(*y).into()));
    }
}

/// Scalar tolerances are all it takes: the first one.
fn solve<P: Problem<N>, const N: usize, const COUNT: bool>(rtol: f64) -> Result<[f64; N]> {
    let (system, start) = (Of::<P, COUNT>(std::marker::PhantomData), SVector::from(P::START));
    let atol = P::ABSOLUTE[0] * rtol;
    let mut solver = Dopri5::new(system, 0.0, P::END, P::END, start, rtol, atol);
    solver.set_output(OutputType::Sparse);
    solver.integrate().map_err(|error| anyhow!("{error}"))?;
    Ok((*solver.y_out().last().context("an output")?).into())
}

pub fn dopri5<P: Problem<N>, const N: usize>(rtol: f64, count: bool) -> Result<[f64; N]> {
    if count { solve::<P, N, true>(rtol) } else { solve::<P, N, false>(rtol) }
}

/// The reference for the problems without another.
pub fn reference<P: Problem<N>, const N: usize>() -> Result<[f64; N]> {
    let (system, start) = (Of::<P, false>(std::marker::PhantomData), SVector::from(P::START));
    let mut solver = Dop853::new(system, 0.0, P::END, P::END, start, 1e-14, 1e-14);
    solver.set_output(OutputType::Sparse);
    solver.integrate().map_err(|error| anyhow!("{error}"))?;
    Ok((*solver.y_out().last().context("an output")?).into())
}
