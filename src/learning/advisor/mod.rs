mod quantile;
mod recommendation;
mod scales;

pub use recommendation::Recommendation;

use scales::Scales;

use super::{Certificate, Switching};
use crate::{
    Error, Scalar,
    error::{finite, positive, remembered, value},
    scalar::constant,
};

/// α is this many times B, so that a B that was taken too small by half still leaves learning faster than the uncertainty.
const MARGIN: f64 = 3.0;
/// How many standard deviations of noise the boundary layer holds.
const SPREAD: f64 = 3.0;
/// The 95 % quantile of |n| for a standard normal n.
const NORMAL: f64 = 1.96;

/// Chooses the learning rate α and the boundary layer δ from a record of the loop.
///
/// s = −(u_n + Δ), so a record of s and u_n, with learning off or on, is one of Δ, with the noise of the source of ė_n on top. From it come
///
/// * B, the bound on |Δ̇|: the 95 % quantile of how much the mean of Δ over a window differs from that of the window before. Among windows of 1, 2,
///   4, … 2048 periods the one is taken where the second difference is the smallest part of the first: short windows show noise, long ones the
///   bends of Δ, and both show in the second difference;
/// * σ, the standard deviation of the noise: the 95 % quantile of |second difference| from sample to sample over 1.96·√6, as if the noise was white.
///   Noise of a bare difference quotient is not, and counts for up to 1.3 times as much.
///
/// Quantiles make it indifferent to a rare bad sample, such as the first of a source that knows nothing yet. B is not an upper bound: of sines in white
/// noise of up to 10·B·h it finds 0.8 to 1.3 times the true one, which is what the factor 3 is for. What [`Recommendation`] makes of them:
///
/// | noise | α | sign | because |
/// |---|---|---|---|
/// | σ < √8·B·h | max(3B, 3σ/h) | set-valued | no filter pays: it would be late by more than it takes off |
/// | otherwise | max(3B, 3σ/T) | implicit, δ = 3σ | noise stays in the layer, where learning is a filter with the time constant T = δ/α, and T³ = σ²h/(8B²) makes lag B·T and noise σ·√(h/2T) the least together |
///
/// Record with the source of ė_n and the period that learning will have, and for as long as it takes Δ to show all of its ways. A Δ that jumps is not
/// bounded in rate; jumps are left out if they are rare. A Δ that depends on what learning changes has to be recorded again with learning on.
///
/// ```
/// use brunovsky::learning::{Advisor, Switching};
///
/// // Δ = 5·sin t without noise, seen for 20 s with learning off.
/// let mut advisor = Advisor::new(0.01_f64)?;
/// for k in 0..2000 {
///     advisor.push(0.0, -5.0 * (0.01 * f64::from(k)).sin())?;
/// }
/// let advice = advisor.recommend()?;
/// assert!((4.5..5.5).contains(&advice.bound()));
/// assert_eq!(advice.switching(), Switching::SetValued);
/// assert!(advice.certificate()?.holds());
/// println!("{advice}");
/// let rule = advice.rule()?;
/// # let _ = rule;
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Advisor<T> {
    dt: T,
    scales: Scales<T>,
}

impl<T: Scalar> Advisor<T> {
    /// An advisor that has seen nothing, for samples `dt` > 0 seconds apart.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(dt: T) -> Result<Self, Error> {
        Ok(Self { dt: positive("dt", dt)?, scales: Scales::new() })
    }

    /// Takes the next sample: the learned term `u_n` that was in the loop (0 with learning off), and `s`.
    ///
    /// # Errors
    /// [`Error::NonFinite`], also for an uncertainty with which differences would leave the range of `T`; the sample is then not taken.
    pub fn push(&mut self, u_n: T, s: T) -> Result<(), Error> {
        finite("u_n", u_n)?;
        finite("s", s)?;
        self.scales.push(remembered("uncertainty", -(u_n + s), T::one())?);
        Ok(())
    }

    /// What the samples so far recommend.
    ///
    /// # Errors
    /// [`Error::Length`] for fewer than 22 samples, [`Error::Singular`] if Δ never moved: any α is then as good as any other.
    pub fn recommend(&self) -> Result<Recommendation<T>, Error> {
        let chosen = self.scales.clearest()?;
        let noise = self.scales.bend() / (constant::<T>(NORMAL) * constant::<T>(6.0).sqrt());
        let window = constant::<T>(chosen.periods) * self.dt;
        let bound = chosen.step / window;
        if bound.is_zero() {
            return Err(Error::Singular { name: "rate of the uncertainty", value: value(bound) });
        }
        let ratio = noise / bound;
        let filter = (ratio * ratio * self.dt * constant(0.125)).cbrt();
        let layer = constant::<T>(SPREAD) * noise;
        let alpha = (constant::<T>(MARGIN) * bound).max(layer / filter.max(self.dt));
        let switching = if filter > self.dt {
            Switching::Implicit { delta: layer }
        } else {
            Switching::SetValued
        };
        // Found out of range here, nothing fails later.
        Certificate::new(alpha, switching, self.dt, bound)?;
        Ok(Recommendation {
            dt: self.dt,
            window,
            clarity: chosen.clarity,
            bound,
            noise,
            alpha,
            switching,
        })
    }

    /// Forgets the samples so far.
    pub fn reset(&mut self) {
        self.scales = Scales::new();
    }
}

checked! {
    [T: Scalar] Advisor<T>, [T] { dt: T, scales: Scales<T> } =>
    Self::new(dt).map(|new| Self { scales, ..new })
}
