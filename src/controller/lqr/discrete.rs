use nalgebra::SMatrix;

use super::{
    REFINEMENTS, Regulator, Weights, balanced::Balanced, checked, doubling::stabilizing, held, sum,
    symmetric,
};
use crate::{
    Error, Scalar,
    conditioning::max_condition,
    error::{finite_slice, value},
    inverse::inverse,
};

/// The regulator that minimizes Σ xᵀQx + 2·xᵀNu + uᵀRu along x⁺ = A·x + B·u: u = −K·x with K = (R + BᵀPB)⁻¹·(BᵀPA + Nᵀ).
///
/// Assumes what [`continuous`](super::continuous) assumes, with the unit circle for the left half plane.
///
/// # Errors
/// Those of [`continuous`](super::continuous), and [`Error::IllConditioned`] for an R + BᵀPB that has no inverse.
pub fn discrete<T: Scalar, const NX: usize, const NU: usize>(
    a: &SMatrix<T, NX, NX>,
    b: &SMatrix<T, NX, NU>,
    weights: &Weights<T, NX, NU>,
) -> Result<Regulator<T, NX, NU>, Error> {
    finite_slice("A", a.as_slice())?;
    finite_slice("B", b.as_slice())?;
    let name = "Riccati equation";
    let balanced = Balanced::new(weights.reduced_a(a, b), weights.reach(b), weights.reduced_q());
    let (a, b, q, r) = (balanced.a, balanced.input(b), balanced.q, weights.r());
    let gain = |p: &SMatrix<T, NX, NX>| {
        let driven = b.transpose() * p;
        let inverse = inverse(&(r + driven * b));
        let limit = value(max_condition::<T>());
        let singular =
            Error::IllConditioned { name: "R + B^T*P*B", condition: f64::INFINITY, limit };
        Ok(inverse.ok_or(singular)? * (driven * a))
    };
    // P = Q + KᵀRK + (A − BK)ᵀ·P·(A − BK) holds for the best K and is flat there.
    let terms = |p: &SMatrix<T, NX, NX>, k: &SMatrix<T, NU, NX>| {
        let closed = a - b * k;
        [q, k.transpose() * r * k, closed.transpose() * p * closed, -p]
    };
    let mut p = stabilizing(name, a, balanced.g, q)?;
    for _ in 0..REFINEMENTS {
        let k = gain(&p)?;
        let left = symmetric(sum(&terms(&p, &k)));
        match stabilizing(name, a - b * k, SMatrix::zeros(), left) {
            Ok(step) => p += step,
            Err(_) => break,
        }
    }
    let k = gain(&p)?;
    let residual = checked(name, &terms(&p, &k))?;
    let gain = balanced.gain(&k) + weights.inverse() * weights.n().transpose();
    let p = balanced.restored(&p);
    finite_slice("P", p.as_slice())?;
    finite_slice("K", gain.as_slice())?;
    Ok(Regulator { gain, value: p, residual })
}

/// The regulator of ẋ = A·x + B·u that minimizes the integral ∫ xᵀQx + 2·xᵀNu + uᵀRu dt among all inputs that are held over periods of `dt`.
///
/// It is the [`discrete`] one of what [`held`] makes of plant and cost, and approaches the [`continuous`](super::continuous) one as dt → 0.
///
/// # Errors
/// Those of [`held`] and of [`discrete`].
pub fn sampled<T: Scalar, const NX: usize, const NU: usize>(
    a: &SMatrix<T, NX, NX>,
    b: &SMatrix<T, NX, NU>,
    weights: &Weights<T, NX, NU>,
    dt: T,
) -> Result<Regulator<T, NX, NU>, Error> {
    let held = held(a, b, weights, dt)?;
    discrete(&held.a, &held.b, &held.weights)
}
