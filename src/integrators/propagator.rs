use nalgebra::SVector;

use super::Integrator;
use crate::{Error, Scalar};

/// What a [`Simulation`](crate::simulation::Simulation) asks of an integration method: x over a piece of time in which f is smooth.
///
/// Every [`Integrator`] is one, with equal steps; [`Adaptive`](super::Adaptive) is one that chooses them.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not integrate states of size {N}",
    note = "a fixed-step method is an `Integrator`: `Rk4`",
    note = "an embedded method comes with its tolerance: `Adaptive::new(Rodas::new(), Tolerance::new(1e-6, 1e-9)?)`"
)]
pub trait Propagator<T: Scalar, const N: usize> {
    /// x(t + `duration`), in `steps` steps if the method does not choose them itself.
    ///
    /// # Errors
    /// Those of [`Integrator::integrate`] or of [`Solver::advance`](super::Solver::advance).
    fn propagate(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        duration: T,
        steps: u32,
    ) -> Result<SVector<T, N>, Error>;
}

impl<I: Integrator, T: Scalar, const N: usize> Propagator<T, N> for I {
    fn propagate(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        duration: T,
        steps: u32,
    ) -> Result<SVector<T, N>, Error> {
        self.integrate(f, t, x, duration, steps)
    }
}
