//! Work and precision of the adaptive integrators, beside those of `ode_solvers` and `diffsol`: `cargo run --release`.
//!
//! Every contender solves the same problem at the same tolerances, the same source of f inlined into each. The error is that at the end of
//! the run against a reference from the literature, a closed form, or Dop853 of `ode_solvers` at a tolerance of 10⁻¹⁴, which none of the
//! contenders is. Evaluations of f are counted in f itself. Times are the least of several batches in turn, without counting, and are
//! given as multiples of ours in the same run.
//!
//! The second table interpolates between the tolerances: what each needs for the same error.

mod contenders;
mod measure;
mod problems;
mod tables;

use anyhow::Result;
use contenders::{diffsol as theirs, ode_solvers as ported, ours};
use measure::Contender;
use problems::{
    Arenstorf, Brusselator, DampedOscillator, Problem, Robertson, StiffVanDerPol, VanDerPol,
};

fn explicit<P: Problem<N>, const N: usize>() -> Result<()> {
    tables::compare::<P, N>(&[
        Contender { name: "ours, Dormand–Prince", run: ours::dormand_prince::<P, N> },
        Contender { name: "ode_solvers, Dopri5", run: ported::dopri5::<P, N> },
        Contender { name: "diffsol, Tsit45", run: theirs::tsit45::<P, N> },
    ])
}

fn stiff<P: Problem<N>, const N: usize>() -> Result<()> {
    tables::compare::<P, N>(&[
        Contender { name: "ours, RODAS, exact ∂f/∂x", run: ours::rodas::<P, N> },
        Contender { name: "ours, RODAS, differences", run: ours::rodas_by_differences::<P, N> },
        Contender { name: "diffsol, BDF", run: theirs::bdf::<P, N> },
        Contender { name: "diffsol, ESDIRK34", run: theirs::esdirk34::<P, N> },
        Contender { name: "diffsol, TR-BDF2", run: theirs::tr_bdf2::<P, N> },
    ])
}

fn main() -> Result<()> {
    explicit::<DampedOscillator, 2>()?;
    explicit::<VanDerPol, 2>()?;
    explicit::<Brusselator, 2>()?;
    explicit::<Arenstorf, 4>()?;
    stiff::<StiffVanDerPol, 2>()?;
    stiff::<Robertson, 3>()
}
