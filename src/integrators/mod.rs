//! Integration of ẋ = f(t, x): with fixed steps, with steps that follow from a tolerance, and up to events.
//!
//! | method | order | evaluations of f in a step | steps |
//! |---|---|---|---|
//! | [`Euler`] | 1 | 1 | equal |
//! | [`Heun`] | 2 | 2 | equal |
//! | [`Rk4`] | 4 | 4 | equal |
//! | [`DormandPrince`] | 5(4) | 6 | equal or adaptive |
//! | [`Rodas`] | 4(3), L-stable | 6, and the linearization of f | adaptive, for stiff problems |
//!
//! A fixed-step method implements [`Integrator::step`], the bare formula, and states its order; [`Integrator::integrate`] repeats it and
//! checks what goes in and comes out.
//!
//! A method that estimates its error is [`Embedded`]. With a [`Tolerance`] it makes an [`Adaptive`] one, which starts a [`Solver`]: a run with
//! dense output, times at which f jumps, and [`Events`].
//!
//! Both kinds are [`Propagator`]s, which is what a [simulation](crate::simulation) asks for.
//!
//! This module depends on nothing but [`Scalar`] and [`Error`].

mod adaptive;
mod dormand_prince;
mod euler;
mod events;
mod heun;
mod propagator;
mod rk4;
mod stiff;

pub(crate) use adaptive::Discontinuities;
pub use adaptive::{Adaptive, Attempt, Embedded, Point, Solver, Statistics, Tolerance};
pub use dormand_prince::DormandPrince;
pub use euler::Euler;
pub use events::{Crossing, Direction, Events, Occurrence};
pub use heun::Heun;
pub use propagator::Propagator;
pub use rk4::Rk4;
pub use stiff::{FiniteDifferences, Jacobian, Linearization, Rodas};

use nalgebra::SVector;

use crate::{
    Error, Scalar,
    error::{finite, finite_vector, positive},
    scalar::constant,
};

/// A one-step method for ẋ = f(t, x).
pub trait Integrator {
    /// The order p: the error over a fixed time falls like hᵖ.
    const ORDER: i32;

    /// One step of length `h` from x(t): an approximation of x(t + h).
    ///
    /// This is the formula and nothing more: an f that returns NaN gives NaN.
    fn step<T: Scalar, const N: usize>(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        h: T,
    ) -> SVector<T, N>;

    /// `steps` equal steps from x(t) to t + `duration`; the j-th starts at t + j·duration/steps.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a `duration` or number of `steps` that is not positive, [`Error::NonFinite`] and
    /// [`Error::NonFiniteEntry`] for a time or state that is not finite, at the start or end of any step.
    fn integrate<T: Scalar, const N: usize>(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        duration: T,
        steps: u32,
    ) -> Result<SVector<T, N>, Error> {
        finite("t", t)?;
        finite_vector("x", x)?;
        positive("duration", duration)?;
        let h = duration / positive("steps", constant::<T>(steps.into()))?;
        let mut x = *x;
        for j in 0..steps {
            let start = t + h * constant(j.into());
            finite("t", start + h)?;
            x = self.step(&mut f, start, &x, h);
            finite_vector("x", &x)?;
        }
        Ok(x)
    }
}
