use nalgebra::SMatrix;

use super::{
    REFINEMENTS, Regulator, Weights, balanced::Balanced, checked, doubling::stabilizing, sum,
    symmetric,
};
use crate::{Error, Scalar, error::finite_slice, inverse::inverse};

/// The regulator that minimizes ∫ xᵀQx + 2·xᵀNu + uᵀRu dt along ẋ = A·x + B·u: u = −K·x with K = R⁻¹·(BᵀP + Nᵀ).
///
/// Assumes (A, B) stabilizable, and that every mode of A − B·R⁻¹·Nᵀ that is not stable shows in the cost (detectability). A loop that is
/// sampled slowly should take [`sampled`](super::sampled) instead.
///
/// ```
/// use brunovsky::{controller::lqr::{self, Weights}, prelude::*};
///
/// // A mass of 1 kg, 1 per m² and 0.01 per N².
/// let (a, b) = (SMatrix::from([[0.0, 0.0], [1.0, 0.0]]), SMatrix::from([[0.0, 1.0]]));
/// let weights = Weights::diagonal([1.0, 0.0], [0.01])?;
/// let regulator = lqr::continuous(&a, &b, &weights)?;
/// // K = (√(q/r), √(2·√(q/r))).
/// assert!((regulator.gain - SMatrix::from([[10.0], [20.0_f64.sqrt()]])).norm() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// [`Error::NonFiniteEntry`] for `a`, `b` and K; [`Error::NotStabilizable`] if a mode is left, to the precision of `T`; [`Error::Unsolved`] if
/// the solution has lost half of its digits.
pub fn continuous<T: Scalar, const NX: usize, const NU: usize>(
    a: &SMatrix<T, NX, NX>,
    b: &SMatrix<T, NX, NU>,
    weights: &Weights<T, NX, NU>,
) -> Result<Regulator<T, NX, NU>, Error> {
    finite_slice("A", a.as_slice())?;
    finite_slice("B", b.as_slice())?;
    let (value, residual) =
        solved("Riccati equation", weights.reduced_a(a, b), weights.reach(b), weights.reduced_q())?;
    let gain = weights.inverse() * (b.transpose() * value + weights.n().transpose());
    finite_slice("K", gain.as_slice())?;
    Ok(Regulator { gain, value, residual })
}

/// The stabilizing solution of AᵀP + PA − PGP + Q = 0, and its residual.
///
/// What it leaves of the equation is solved for again (a step of Newton's method, here a Lyapunov equation): that brings back the digits that
/// the transform takes from poles far slower than the fastest.
pub(super) fn solved<T: Scalar, const N: usize>(
    name: &'static str,
    a: SMatrix<T, N, N>,
    g: SMatrix<T, N, N>,
    q: SMatrix<T, N, N>,
) -> Result<(SMatrix<T, N, N>, T), Error> {
    let balanced = Balanced::new(a, g, q);
    let Balanced { a, g, q, .. } = balanced;
    let gamma = balanced.rate();
    let terms = |p: &SMatrix<T, N, N>| {
        let linear = p * a;
        [linear.transpose(), linear, -(p * g * p), q]
    };
    let mut p = transformed(name, a, g, q, gamma)?;
    for _ in 0..REFINEMENTS {
        let left = symmetric(sum(&terms(&p)));
        match transformed(name, a - g * p, SMatrix::zeros(), left, gamma) {
            Ok(step) => p += step,
            Err(_) => break,
        }
    }
    let residual = checked(name, &terms(&p))?;
    let p = balanced.restored(&p);
    finite_slice("P", p.as_slice())?;
    Ok((p, residual))
}

/// The same by a Cayley transform, (p + γ)/(p − γ), which takes the left half plane into the unit circle; with γ larger than any eigenvalue,
/// nothing that is inverted is singular.
fn transformed<T: Scalar, const N: usize>(
    name: &'static str,
    a: SMatrix<T, N, N>,
    g: SMatrix<T, N, N>,
    q: SMatrix<T, N, N>,
    gamma: T,
) -> Result<SMatrix<T, N, N>, Error> {
    let identity = SMatrix::<T, N, N>::identity();
    let lost = Error::Unsolved { name, residual: f64::INFINITY, limit: f64::MAX };
    let shifted = inverse(&(a - identity * gamma)).ok_or(lost)?;
    let w = a.transpose() - identity * gamma + q * shifted * g;
    let w = inverse(&w).ok_or(lost)?;
    let twice = gamma + gamma;
    stabilizing(
        name,
        identity + w.transpose() * twice,
        symmetric(shifted * g * w * twice),
        symmetric(w * q * shifted * twice),
    )
}
