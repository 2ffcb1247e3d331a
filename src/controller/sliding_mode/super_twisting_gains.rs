use crate::{
    Error, Scalar,
    elementary::hypot,
    error::{finite, not_negative, positive},
    scalar::constant,
};

/// The gains k₁, k₂ of [`SuperTwisting`](super::SuperTwisting), and what they promise: of σ̇ = −k₁·|σ|^½·sgn(σ) + z, ż = −k₂·sgn(σ) − Δ̇.
///
/// | gains | σ and z are zero after a finite time for all \|Δ̇\| ≤ L |
/// |---|---|
/// | k₁ = 1.5·√L, k₂ = 1.1·L | Levant's, [`for_rate`](Self::for_rate) |
/// | k₂ > L, k₁² > k₂ + L | Seeber and Horn; [`tolerates`](Self::tolerates) says which L |
/// | k₂ > L + 2·L²/k₁² | by Moreno and Osorio's V, which also bounds the [time](Self::reaching_time) |
///
/// Levant's gains are of the second kind and not of the third.
///
/// # References
/// A. Levant, "Robust exact differentiation via sliding mode technique", Automatica 34(3), 1998. J. Moreno, M. Osorio, "Strict Lyapunov functions
/// for the super-twisting algorithm", IEEE Transactions on Automatic Control 57(4), 2012. R. Seeber, M. Horn, "Stability proof for a
/// well-established super-twisting parameter setting", Automatica 84, 2017.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SuperTwistingGains<T> {
    k1: T,
    k2: T,
}

impl<T: Scalar> SuperTwistingGains<T> {
    /// `k1` > 0 in the units of ẋ_n over the root of those of x_n, `k2` > 0 in those of ẋ_n per second.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(k1: T, k2: T) -> Result<Self, Error> {
        Ok(Self { k1: positive("k1", k1)?, k2: positive("k2", k2)? })
    }

    /// Levant's k₁ = 1.5·√L and k₂ = 1.1·L for |Δ̇| ≤ `bound` = L > 0, in the units of ẋ_n per second.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn for_rate(bound: T) -> Result<Self, Error> {
        let bound = positive("bound on the rate of the uncertainty", bound)?;
        Self::new(constant::<T>(1.5) * bound.sqrt(), constant::<T>(1.1) * bound)
    }

    /// The gain k₁ of the root.
    pub fn k1(&self) -> T {
        self.k1
    }

    /// The gain k₂ of the integrated sign.
    pub fn k2(&self) -> T {
        self.k2
    }

    /// min(k₂, k₁² − k₂): σ and z are zero after a finite time for every bound L on |Δ̇| below it. `None` if k₁² ≤ k₂.
    pub fn tolerates(&self) -> Option<T> {
        let limit = self.k2.min(self.k1 * self.k1 - self.k2);
        (limit > T::zero()).then_some(limit)
    }

    /// h²·L: what remains of |σ| at the samples under the implicit law, at period `dt` = h and for |Δ̇| ≤ `bound` = L; `None` unless L is
    /// [tolerated](Self::tolerates).
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotPositive`] or [`Error::NonFinite`] for a parameter out of range, or a product of them.
    pub fn residual(&self, bound: T, dt: T) -> Result<Option<T>, Error> {
        let bound = not_negative("bound on the rate of the uncertainty", bound)?;
        let left = finite("bound*dt^2", bound * positive("dt", dt)? * dt)?;
        Ok(self.tolerates().and_then(|limit| (bound < limit).then_some(left)))
    }

    /// A time in seconds within which σ and z are zero in continuous time, from `sigma0` = σ(0) and `z0` = −(w + Δ)(0), while |Δ̇| ≤ `bound` = L;
    /// `None` unless k₂ > L + 2·L²/k₁².
    ///
    /// V = ζᵀPζ of ζ = (|σ|^½·sgn(σ), z) with P = ½·\[4k₂ + k₁², −k₁; −k₁, 2\] obeys V̇ = −|σ|^−½·ζᵀQζ, where −Δ̇ = ρ·sgn(σ) makes
    /// Q = \[k₁·(k₂ + k₁²/2 + ρ), −k₁²/2 − ρ; −k₁²/2 − ρ, k₁/2\]. With p = (P⁻¹)₁₁ = 4/(8k₂ + k₁²), P⁻¹Q has the trace k₁ and the determinant
    /// p·(½·k₁²·(k₂ − ρ) − ρ²); its lesser eigenvalue is least, μ, for ρ = L. As |σ| ≤ p·V, that leaves V̇ ≤ −μ·(V/p)^½, so V is zero after
    /// 2·(p·V(0))^½/μ.
    ///
    /// # Errors
    /// [`Error::Negative`] for the bound; [`Error::NonFinite`] for a parameter, or a time beyond the range of `T`.
    pub fn reaching_time(&self, sigma0: T, z0: T, bound: T) -> Result<Option<T>, Error> {
        let (sigma, z) = (finite("sigma(0)", sigma0)?, finite("z(0)", z0)?);
        let bound = not_negative("bound on the rate of the uncertainty", bound)?;
        let (k1, k2) = (self.k1, self.k2);
        let (two, half) = (constant::<T>(2.0), constant::<T>(0.5));
        let p = constant::<T>(4.0) / (constant::<T>(8.0) * k2 + k1 * k1);
        let determinant = p * (half * k1 * k1 * (k2 - bound) - bound * bound);
        let half_trace = half * k1;
        let root = (half_trace * half_trace - determinant).max(T::zero()).sqrt();
        // The lesser eigenvalue, without cancellation.
        let rate = determinant / (half_trace + root);
        let cross = (k1 * sigma.abs().sqrt()).copysign(sigma) - z;
        let v = two * k2 * sigma.abs() + half * (z * z + cross * cross);
        let time = (rate > T::zero()).then(|| two * (p * v).sqrt() / rate);
        time.map(|time| finite("reaching time", time)).transpose()
    }

    /// Forward Euler over `dt`: u_s, and w at the end, from w at the `start`.
    pub(super) fn explicit(&self, sigma: T, start: T, dt: T) -> (T, T) {
        let share = (self.k1 * sigma.abs().sqrt()).copysign(sigma);
        (share, start + sgn(sigma) * self.k2 * dt)
    }

    /// Backward Euler over `dt`: u_s, and w at the end, from w at the `start`.
    pub(super) fn implicit(&self, sigma: T, start: T, dt: T) -> (T, T) {
        let (size, reach) = (sigma.abs(), self.k2 * dt);
        let rest = size - reach * dt;
        if rest > T::zero() {
            // The positive root of y² + h·k₁·y = |σ| − h²·k₂, without cancellation.
            let (linear, two) = (self.k1 * dt, constant::<T>(2.0));
            let root = two * rest / (linear + hypot(linear, two * rest.sqrt()));
            ((self.k1 * root + reach).copysign(sigma), start + reach.copysign(sigma))
        } else {
            (sigma / dt, start + sigma / dt)
        }
    }
}

/// sgn(x), 0 for 0.
pub(super) fn sgn<T: Scalar>(x: T) -> T {
    if x.is_zero() { x } else { T::one().copysign(x) }
}

checked! { [T: Scalar] SuperTwistingGains<T>, [T] { k1: T, k2: T } => Self::new(k1, k2) }
