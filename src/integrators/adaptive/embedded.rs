use core::fmt::Debug;

use nalgebra::SVector;

use crate::{Scalar, scalar::constant};

/// A one-step method that estimates its own error and has a solution between the ends of its step.
///
/// This is the formula of one attempt; [`Solver`](super::Solver) decides on its length, keeps or discards it, and counts.
pub trait Embedded<T: Scalar, const N: usize> {
    /// The order p of the solution that is carried on: the error over a fixed time falls like hᵖ.
    const ORDER: i32;

    /// The order of the solution it is compared with: the estimate of one step falls like h to this power plus one.
    const ESTIMATE: i32;

    /// Whether it needs a linearization of f, and with it the solution of linear equations.
    const LINEARIZES: bool;

    /// What it knows of f about the start of a step, whatever the step's length.
    type Linearization: Copy + Debug;

    /// What the dense output is made of.
    type Stages: Copy + Debug;

    /// The linearization about `at`, for steps of about `h` and a tolerance of `weights`.
    fn linearize(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        h: T,
        weights: &SVector<T, N>,
    ) -> Self::Linearization;

    /// One step of length `h`; `None` if its linear equations are singular.
    fn attempt(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        linearization: &Self::Linearization,
        h: T,
    ) -> Option<Attempt<T, N, Self::Stages>>;

    /// d₁ … d₄ of x(t + θ·h) = x + θ·(d₁ + (1 − θ)·(d₂ + θ·(d₃ + (1 − θ)·d₄))), 0 ≤ θ ≤ 1.
    fn dense(
        &self,
        at: &Point<T, N>,
        attempt: &Attempt<T, N, Self::Stages>,
        h: T,
    ) -> [SVector<T, N>; 4];
}

/// Where a step starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point<T, const N: usize> {
    /// The time t.
    pub t: T,
    /// The state x(t).
    pub x: SVector<T, N>,
    /// ẋ = f(t, x).
    pub rate: SVector<T, N>,
}

/// Where a step leads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attempt<T, const N: usize, S> {
    /// The state x⁺ at t + h.
    pub x: SVector<T, N>,
    /// The estimate of its error.
    pub error: SVector<T, N>,
    /// f(t + h, x⁺), if it comes for free.
    pub rate: Option<SVector<T, N>>,
    /// What the dense output is made of.
    pub stages: S,
}

/// Σᵢ cᵢ·vᵢ.
// Inlined, the coefficients are constants and the loop is gone.
#[inline(always)]
pub(crate) fn combination<T: Scalar, const N: usize, const S: usize>(
    coefficients: [f64; S],
    vectors: [&SVector<T, N>; S],
) -> SVector<T, N> {
    let mut sum = SVector::zeros();
    for (i, (c, v)) in coefficients.into_iter().zip(vectors).enumerate() {
        let term = v * constant::<T>(c);
        if i == 0 { sum = term } else { sum += term }
    }
    sum
}
