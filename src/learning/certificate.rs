use super::Switching;
use crate::{
    Error, Scalar,
    error::{finite, not_negative, positive},
    scalar::constant,
};

/// What theory promises of sliding-mode learning: from α, δ, the period h and a bound B on |Δ̇|.
///
/// The promises are about s = −(u_n + Δ), that is, they hold with the exact ė_n (as from [`Measured`](super::Measured)). The
/// sampled ones follow from s(k+1) = s(k) − αh·ς(k) − ∫Δ̇ dt over the period, worst case |∫Δ̇ dt| = B·h.
///
/// ```
/// use brunovsky::learning::{Certificate, Switching};
///
/// // The simulation study: α = 25, δ = 0.05, h = 0.01 s, Δ = 5·sin t, s(0) = −90.
/// let certificate = Certificate::new(25.0, Switching::Explicit { delta: 0.05 }, 0.01, 5.0)?;
/// assert!(certificate.holds());
/// assert_eq!(certificate.reaching_time(-90.0)?, Some(4.5));
/// assert_eq!(certificate.step_ratio(), 5.0);
/// assert!(certificate.explicit_chatters());
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate<T> {
    alpha: T,
    switching: Switching<T>,
    dt: T,
    bound: T,
}

impl<T: Scalar> Certificate<T> {
    /// For learning rate α > 0, a discretized sign with its δ, period h = `dt` > 0 in seconds and |Δ̇| ≤ `bound` = B ≥ 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`] for a parameter out of range, or for αh, B·h or a residual out of
    /// that of `T`.
    pub fn new(alpha: T, switching: Switching<T>, dt: T, bound: T) -> Result<Self, Error> {
        let certificate = Self {
            alpha: positive("alpha", alpha)?,
            switching: switching.validated()?,
            dt: positive("dt", dt)?,
            bound: not_negative("bound on the rate of the uncertainty", bound)?,
        };
        positive("alpha*dt", alpha * dt)?;
        finite("bound*dt", bound * dt)?;
        if let Some(residual) = certificate.residual() {
            finite("residual", residual)?;
        }
        Ok(certificate)
    }

    /// α > B: learning is faster than what it has to learn. Without this nothing below is promised.
    pub fn holds(&self) -> bool {
        self.alpha > self.bound
    }

    /// t_h = |s(0)|/(α − B) in seconds, within which s reaches zero under the ideal sign (eq_th2); `None` unless α > B.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for an s(0) that is not finite, or a time beyond the range of `T`.
    pub fn reaching_time(&self, s0: T) -> Result<Option<T>, Error> {
        let size = finite("s(0)", s0)?.abs();
        let time = self.holds().then(|| size / (self.alpha - self.bound));
        time.map(|time| finite("reaching time", time)).transpose()
    }

    /// δB/(α − B): what remains of |s| under the smoothed sign in continuous time, where α|s|/(|s| + δ) = B; `None` unless
    /// α > B.
    pub fn boundary_layer_residual(&self) -> Option<T> {
        self.holds().then(|| self.switching.delta() * self.bound / (self.alpha - self.bound))
    }

    /// What remains of |s| at the samples, before learning from it; `None` unless α > B.
    ///
    /// The implicit signs add to the [boundary layer's residual](Self::boundary_layer_residual) the B·h by which Δ moves in a
    /// period; the explicit one adds it to its chattering where that is larger.
    pub fn residual(&self) -> Option<T> {
        let layer = self.boundary_layer_residual()?;
        let drift = self.bound * self.dt;
        Some(match self.switching {
            Switching::Explicit { .. } => layer.max(self.overshoot() + drift),
            Switching::Implicit { .. } | Switching::SetValued => layer + drift,
        })
    }

    /// How long it takes at most, in seconds, until a jump of Δ by `jump` = J > 0 has left no more than `within` = ε > 0 of itself in |s|, beyond
    /// the [`residual`](Self::residual):
    ///
    /// (J + (r₀ + δ)·L)/(α − B) + (2 + L/2)·h, L = ln(J/ε) if δ > 0 and J > ε, else 0, and r₀ the
    /// [boundary layer's residual](Self::boundary_layer_residual); `None` unless α > B.
    ///
    /// What the jump has left is d = |s| − r₀. While Δ̇ = −B a step takes d to the d⁺ of d − d⁺ = (α − B)h·d⁺/(d⁺ + r₀ + δ), which sums up to
    /// this by x ≤ (1 + x/2)·ln(1 + x); the explicit sign is faster.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for either.
    pub fn recovery_time(&self, jump: T, within: T) -> Result<Option<T>, Error> {
        let ratio = positive("jump", jump)? / positive("within", within)?;
        let delta = self.switching.delta();
        let log = if delta > T::zero() { ratio.ln().max(T::zero()) } else { T::zero() };
        Ok(self.boundary_layer_residual().map(|layer| {
            let periods = constant::<T>(2.0) + log * constant(0.5);
            (jump + (layer + delta) * log) / (self.alpha - self.bound) + periods * self.dt
        }))
    }

    /// The bound on |e₁| that |s| ≤ [`residual`](Self::residual) implies once transients have died out: residual/λⁿ, for gains with
    /// all `order` = n poles at −λ; `None` unless α > B.
    ///
    /// As e₁ = s/(p + λ)ⁿ has a positive impulse response, its steady-state gain 1/λⁿ bounds it for every s, slow or fast.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `lambda`, [`Error::NonFinite`] for a bound beyond the range of `T`.
    pub fn tracking_bound(&self, lambda: T, order: i32) -> Result<Option<T>, Error> {
        positive("lambda", lambda)?;
        let bound = self.residual().map(|residual| residual / lambda.powi(order));
        bound.map(|bound| finite("tracking bound", bound)).transpose()
    }

    /// αh/δ; infinite for δ = 0.
    pub fn step_ratio(&self) -> T {
        self.alpha * self.dt / self.switching.delta()
    }

    /// αh/δ > 2: near s = 0 an explicit Euler step of the smoothed sign overshoots by more than it started from, and chatters for
    /// ever. (At αh/δ = 2 it dies out, slower than any exponential.)
    pub fn explicit_chatters(&self) -> bool {
        self.alpha * self.dt > constant::<T>(2.0) * self.switching.delta()
    }

    /// αh/2 − δ, the amplitude of s in the period-two cycle of explicit Euler for a constant Δ; 0 if it does not chatter.
    pub fn chattering_amplitude(&self) -> T {
        (self.alpha * self.dt * constant(0.5) - self.switching.delta()).max(T::zero())
    }

    /// A bound on |s(k+1)| after |s(k)| ≤ `size`; for the implicit signs it is attained.
    pub(super) fn worst_next(&self, size: T) -> T {
        let reach = self.alpha * self.dt;
        let after = size - reach * self.switching.sign(size, reach);
        let drift = self.bound * self.dt;
        match self.switching {
            Switching::Explicit { .. } => after.max(self.overshoot()) + drift,
            Switching::Implicit { .. } | Switching::SetValued => after.max(T::zero()) + drift,
        }
    }

    /// The same where the rule learns from an s that may be off by `slack`, and |s(k)| ≤ `size` is the true one.
    ///
    /// The signs do not decrease in s, so the worst noise is the one that hides `slack` of s: what is left is that of the rest, and the
    /// slack.
    pub(super) fn worst_noisy(&self, size: T, slack: T) -> T {
        self.worst_next((size - slack).max(T::zero())) + slack
    }

    /// The period h in seconds.
    pub(super) fn dt(&self) -> T {
        self.dt
    }

    /// How far one explicit step can pass beyond zero: the largest |s − αh·s/(|s| + δ)| of the wrong sign, (√(αh) − √δ)² if αh > δ.
    fn overshoot(&self) -> T {
        let reach = self.alpha * self.dt;
        let excess = (reach.sqrt() - self.switching.delta().sqrt()).max(T::zero());
        excess * excess
    }
}

checked! {
    [T: Scalar] Certificate<T>, [T] { alpha: T, switching: Switching<T>, dt: T, bound: T } =>
    Self::new(alpha, switching, dt, bound)
}
