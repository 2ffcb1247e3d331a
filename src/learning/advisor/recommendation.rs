use core::fmt;

use crate::{
    Error, Scalar,
    elementary::hypot,
    error::value,
    learning::{Certificate, SlidingMode, Switching},
    scalar::constant,
};

/// What an [`Advisor`](super::Advisor) recommends, and why: `{}` prints the reasons.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recommendation<T> {
    pub(super) dt: T,
    pub(super) window: T,
    pub(super) clarity: T,
    pub(super) bound: T,
    pub(super) noise: T,
    pub(super) alpha: T,
    pub(super) switching: Switching<T>,
}

impl<T: Scalar> Recommendation<T> {
    /// The bound B on |Δ̇| that was found.
    pub fn bound(&self) -> T {
        self.bound
    }

    /// The standard deviation σ of the noise on s that was found.
    pub fn noise(&self) -> T {
        self.noise
    }

    /// The length in seconds of the windows that B was found with.
    pub fn window(&self) -> T {
        self.window
    }

    /// Whether Δ stood out of the noise: at that window, the second difference was less than the first. Where it does not hold, B is mostly noise, and
    /// a longer record or a source with less noise is needed; or Δ moves too fast for the period.
    pub fn resolved(&self) -> bool {
        self.clarity < T::one()
    }

    /// The learning rate α.
    pub fn alpha(&self) -> T {
        self.alpha
    }

    /// The discretization of the sign, with its boundary layer δ.
    pub fn switching(&self) -> Switching<T> {
        self.switching
    }

    /// The rule with this α and this sign.
    ///
    /// # Errors
    /// As [`SlidingMode::new`].
    pub fn rule(&self) -> Result<SlidingMode<T>, Error> {
        SlidingMode::new(self.alpha)?.with_switching(self.switching)
    }

    /// What theory promises of it while |Δ̇| ≤ B.
    ///
    /// # Errors
    /// As [`Certificate::new`].
    pub fn certificate(&self) -> Result<Certificate<T>, Error> {
        Certificate::new(self.alpha, self.switching, self.dt, self.bound)
    }

    /// How far s may be off by noise, 3σ: the slack for a [`Monitor`](crate::learning::Monitor) or a [`Watchdog`](crate::learning::Watchdog).
    pub fn slack(&self) -> T {
        constant::<T>(super::SPREAD) * self.noise
    }

    /// The root mean square of u_n + Δ to expect after transients: the residual of the certificate, and white noise through the filter that learning
    /// is for small s, σ·√(g/(2 − g)) with g = αh/(δ + αh).
    ///
    /// # Errors
    /// As [`Certificate::new`].
    pub fn expected(&self) -> Result<T, Error> {
        let reach = self.alpha * self.dt;
        let gain = reach / (self.switching.delta() + reach);
        let noise = self.noise * (gain / (constant::<T>(2.0) - gain)).sqrt();
        Ok(hypot(self.certificate()?.residual().unwrap_or_else(T::zero), noise))
    }

    /// What remains of |u_n + Δ| at most, after transients, while |Δ̇| ≤ B and noise stays within 3σ: the residual of the certificate, and 3σ.
    ///
    /// # Errors
    /// As [`Certificate::new`].
    pub fn residual(&self) -> Result<T, Error> {
        // α ≥ 3B: the certificate always holds.
        let residual = self.certificate()?.residual().unwrap_or_else(T::zero);
        Ok(residual + self.slack())
    }
}

impl<T: Scalar> fmt::Display for Recommendation<T> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [dt, window, bound, noise, alpha] =
            [self.dt, self.window, self.bound, self.noise, self.alpha].map(value);
        let delta = value(self.switching.delta());
        writeln!(f, "|Δ̇| ≤ B = {bound:.3e}, from means over {window} s")?;
        if !self.resolved() {
            writeln!(
                f,
                "  but Δ does not stand out of the noise: record longer, or with less noise"
            )?;
        }
        writeln!(
            f,
            "noise on s: σ = {noise:.3e}; in a period of {dt} s Δ moves by B·h = {:.3e}",
            bound * dt
        )?;
        writeln!(f, "α = {alpha:.3e} = {:.1}·B: learning is faster than Δ", alpha / bound)?;
        match self.switching {
            Switching::Implicit { .. } | Switching::Explicit { .. } => writeln!(
                f,
                "implicit sign, δ = 3σ = {delta:.3e}: the layer holds the noise and filters it over T = δ/α = {:.3e} s",
                delta / alpha
            )?,
            Switching::SetValued => writeln!(
                f,
                "set-valued sign: a filter would cost more in lag than it takes off in noise"
            )?,
        }
        writeln!(f, "an explicit sign would chatter below δ = α·h/2 = {:.3e}", alpha * dt / 2.0)?;
        let [expected, residual] =
            [self.expected(), self.residual()].map(|size| size.map_or(f64::NAN, value));
        writeln!(
            f,
            "then u_n + Δ is {expected:.3e} RMS, and at most {residual:.3e} while noise stays within 3σ"
        )?;
        write!(f, "a jump J of Δ is learned within J/{:.3e} s", alpha - bound)
    }
}

checked! {
    [T: Scalar] Recommendation<T>, [T]
    { dt: T, window: T, clarity: T, bound: T, noise: T, alpha: T, switching: Switching<T> } =>
    Certificate::new(alpha, switching, dt, bound).and_then(|_| {
        positive("window", window)?;
        not_negative("clarity", clarity)?;
        positive("bound on the rate of the uncertainty", bound)?;
        not_negative("noise", noise)?;
        Ok(Self { dt, window, clarity, bound, noise, alpha, switching })
    })
}
