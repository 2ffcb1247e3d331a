use nalgebra::SMatrix;

use super::{Weights, symmetric};
use crate::{
    Error, Scalar,
    conditioning::norm,
    error::{finite_slice, positive},
    scalar::constant,
};

/// A plant and its cost over a period in which the input is held: x⁺ = A·x + B·u at the cost xᵀQx + 2·xᵀNu + uᵀRu.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held<T, const NX: usize, const NU: usize> {
    /// A = Φ(h) = exp(A_c·h).
    pub a: SMatrix<T, NX, NX>,
    /// B = Γ(h) = ∫₀ʰ Φ(t) dt·B_c.
    pub b: SMatrix<T, NX, NU>,
    /// Q = ∫₀ʰ ΦᵀQ_cΦ dt, N = ∫₀ʰ Φᵀ(Q_cΓ + N_c) dt, R = ∫₀ʰ ΓᵀQ_cΓ + ΓᵀN_c + N_cᵀΓ + R_c dt.
    pub weights: Weights<T, NX, NU>,
}

/// ẋ = A·x + B·u with its cost ∫ xᵀQx + 2·xᵀNu + uᵀRu dt, under an input that is held over periods of `dt` > 0 in seconds: exactly, without an
/// approximation of order in dt.
///
/// A sampled cost has a cross term even if the continuous one has none: what is decided now moves the state for a whole period.
///
/// # Errors
/// [`Error::NotPositive`] or [`Error::NonFinite`] for `dt`; [`Error::NonFiniteEntry`] for `a`, `b`, and for what leaves the range of `T`;
/// [`Error::NotPositive`] or [`Error::IllConditioned`] for an R that does.
pub fn held<T: Scalar, const NX: usize, const NU: usize>(
    a: &SMatrix<T, NX, NX>,
    b: &SMatrix<T, NX, NU>,
    weights: &Weights<T, NX, NU>,
    dt: T,
) -> Result<Held<T, NX, NU>, Error> {
    positive("dt", dt)?;
    finite_slice("A", a.as_slice())?;
    finite_slice("B", b.as_slice())?;
    let (mut h, mut doublings) = (dt, 0);
    while norm(a) * h > constant(0.5) {
        h *= constant(0.5);
        doublings += 1;
    }
    let mut period = Period::short(a, b, weights, h);
    for _ in 0..doublings {
        period = period.doubled();
    }
    let Period { phi, gamma, q, n, r } = period;
    finite_slice("exp(A*dt)", phi.as_slice())?;
    finite_slice("B of the held input", gamma.as_slice())?;
    let weights = Weights::unjudged(symmetric(q), symmetric(r), n)?;
    Ok(Held { a: phi, b: gamma, weights })
}

struct Period<T, const NX: usize, const NU: usize> {
    phi: SMatrix<T, NX, NX>,
    gamma: SMatrix<T, NX, NU>,
    q: SMatrix<T, NX, NX>,
    n: SMatrix<T, NX, NU>,
    r: SMatrix<T, NU, NU>,
}

impl<T: Scalar, const NX: usize, const NU: usize> Period<T, NX, NU> {
    /// The Taylor series of a period with ‖A‖·h ≤ ½. The terms of the cost come from M ↦ FᵀM + MF, F = [A B; 0 0], whose powers grow with
    /// (2·‖A‖)^k: the last one is below 1/20! = 4·10⁻¹⁹ of the first.
    fn short(
        a: &SMatrix<T, NX, NX>,
        b: &SMatrix<T, NX, NU>,
        weights: &Weights<T, NX, NU>,
        h: T,
    ) -> Self {
        let (mut phi, mut gamma) = (SMatrix::identity(), b * h);
        let (mut q, mut n, mut r) = (weights.q() * h, weights.n() * h, weights.r() * h);
        let mut sum = Self { phi, gamma, q, n, r };
        for k in 1..20 {
            let (of_phi, next) = (h / constant(f64::from(k)), h / constant(f64::from(k + 1)));
            phi = a * phi * of_phi;
            gamma = a * gamma * next;
            (q, n, r) = (
                (a.transpose() * q + q * a) * next,
                (a.transpose() * n + q * b) * next,
                (b.transpose() * n + n.transpose() * b) * next,
            );
            sum.phi += phi;
            sum.gamma += gamma;
            sum.q += q;
            sum.n += n;
            sum.r += r;
        }
        sum
    }

    /// Two such periods, one after the other, under the same input.
    fn doubled(&self) -> Self {
        let Self { phi, gamma, q, n, r } = self;
        let later = q * gamma + n;
        let cross = gamma.transpose() * n;
        Self {
            phi: phi * phi,
            gamma: phi * gamma + gamma,
            q: q + phi.transpose() * q * phi,
            n: n + phi.transpose() * later,
            r: r + r + gamma.transpose() * q * gamma + cross + cross.transpose(),
        }
    }
}
