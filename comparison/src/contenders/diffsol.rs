use anyhow::Result;
use diffsol::{
    NalgebraContext, NalgebraLU, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquations,
    OdeEquationsImplicit, OdeSolverMethod, OdeSolverProblem, OdeSolverStopReason, Vector as _,
};

use crate::{
    measure::{jacobian, rate},
    problems::Problem,
};

type Matrix = NalgebraMat<f64>;
type Vector = NalgebraVec<f64>;
type Lu = NalgebraLU<f64>;

fn state<const N: usize>(x: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| x[i])
}

fn problem<P: Problem<N>, const N: usize, const COUNT: bool>(
    rtol: f64,
) -> Result<
    OdeSolverProblem<
        impl OdeEquationsImplicit<M = Matrix, V = Vector, T = f64, C = NalgebraContext>,
    >,
> {
    let builder = OdeBuilder::<Matrix>::new()
        .rtol(rtol)
        .atol(P::ABSOLUTE.map(|unit| unit * rtol))
        .rhs_implicit(
            |x, _, _, y| y.copy_from_slice(&rate::<P, N, COUNT>(&state(x))),
            // ∂f/∂x·v: a column at a time.
            |x, _, _, v, y| {
                let rows = jacobian::<P, N, COUNT>(&state(x), 1);
                for (y, row) in y.iter_mut().zip(rows) {
                    *y = row.iter().zip(v).map(|(a, v)| a * v).sum();
                }
            },
        )
        .init(|_, _, y| y.copy_from_slice(&P::START), N);
    Ok(builder.build()?)
}

fn run<
    'a,
    P: Problem<N>,
    const N: usize,
    E: OdeEquations<M = Matrix, V = Vector, T = f64, C = NalgebraContext> + 'a,
>(
    mut solver: impl OdeSolverMethod<'a, E>,
) -> Result<[f64; N]> {
    solver.set_stop_time(P::END)?;
    while solver.step()? != OdeSolverStopReason::TstopReached {}
    let y = solver.state().y;
    Ok(std::array::from_fn(|i| y.get_index(i)))
}

/// Each method is named by the function that starts it.
macro_rules! methods {
    ($($name:ident: $start:expr),+ $(,)?) => {
        $(pub fn $name<P: Problem<N>, const N: usize>(rtol: f64, count: bool) -> Result<[f64; N]> {
            if count {
                let problem = problem::<P, N, true>(rtol)?;
                run::<P, N, _>($start(&problem)?)
            } else {
                let problem = problem::<P, N, false>(rtol)?;
                run::<P, N, _>($start(&problem)?)
            }
        })+
    };
}

methods! {
    tsit45: OdeSolverProblem::tsit45,
    bdf: OdeSolverProblem::bdf::<Lu>,
    esdirk34: OdeSolverProblem::esdirk34::<Lu>,
    tr_bdf2: OdeSolverProblem::tr_bdf2::<Lu>,
}
