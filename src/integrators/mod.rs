//! Fixed-step integration of ẋ = f(t, x).
//!
//! | method | order | evaluations of f in a step |
//! |---|---|---|
//! | [`Euler`] | 1 | 1 |
//! | [`Heun`] | 2 | 2 |
//! | [`Rk4`] | 4 | 4 |
//!
//! A method implements [`Integrator::step`], the bare formula, and states its order; [`Integrator::integrate`] repeats it and
//! checks what goes in and comes out.
//!
//! This module depends on nothing but [`Scalar`] and [`Error`].

mod euler;
mod heun;
mod rk4;

pub use euler::Euler;
pub use heun::Heun;
pub use rk4::Rk4;

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
