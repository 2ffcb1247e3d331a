//! Differentiators: ẏ of a signal that is sampled, and noisy.
//!
//! | law | parameters | delay of a slow signal | white noise of variance V | first sample |
//! |---|---|---|---|---|
//! | [`BackwardDifference`] | none | h/2 | 2V/h² | 0 |
//! | [`FilteredDifference`] | time constant τ | τ + h/2 | 2V/((τ + h)·(2τ + h)) | 0 |
//! | [`HighGain`] of first order | bandwidth ω | h·coth(ωh/2) − h/2 ≈ 2/ω | 2V/h²·tanh³(ωh/2) ≈ V·h·ω³/4 | 0 |
//! | [`HighGain`] of second order | bandwidth ω | 0 | ≈ 7/4·V·h·ω³ | 0 |
//! | [`Tracking`] | horizon T, acceleration r | 2T − 3h/2 | 2V/h²·(h/(2T − h))³ | 0 |
//! | [`RobustExact`] of order 1 to 3 | bound L on the next derivative | h/2, then 0 | not linear | 0 |
//!
//! h is the period, which may be a different one at every sample; each law says for which it is stable. None kicks at the first sample.
//!
//! Each is a source of ė_n as it stands, which differentiates e_n; in [`OfState`](crate::learning::OfState) it differentiates x_n, and in
//! [`ModelAided`](crate::learning::ModelAided) what the model does not explain of x_n: with [`HighGain`] that is the linear extended state
//! observer, with [`RobustExact`] the sliding-mode one.
//!
//! # Which one?
//! The example `differentiators` prints the RMS error, the delay and the total variation of each on signals with |ÿ| ≤ L = 1 at h = 0.01 s, under white
//! noise of standard deviation σ, all parameters by the rules `for_noise`. What it shows:
//!
//! * While σ ≪ L·h² no law of first order does better than the [`BackwardDifference`], which has nothing to choose: RMS 0.004 at σ = 10⁻⁵. At σ = 10⁻³ it
//!   is off by 0.14, the others by 0.03 to 0.04.
//! * Of those that know a bound on ÿ, [`HighGain`] of first order has the least error from σ = 10⁻⁴ on (0.082 at σ = 10⁻², [`FilteredDifference`]
//!   0.119). Where y⃛ is bounded too, second order halves that, with next to no delay (0.043).
//! * [`RobustExact`] does not need to know σ, and its total variation stays near that of ẏ itself at every σ (1.7 times at 10⁻¹, where high gain has 12
//!   times). White noise costs it more error than the linear laws (0.120 at σ = 10⁻²), for which it is the best case. A bound that does not hold
//!   costs it everything.
//! * [`Tracking`] is for signals with steps and outliers. It keeps able to stop, so it is late by |ẏ|/(2r) where |ẏ| > r·T.
//!
//! # In the loop
//! The same example closes the loop of the third-order system (α = 25, set-valued sign, Δ = 5·sin t, λ = 3) with noise on x₃. RMS of x₁:
//!
//! | ė_n from | σ = 10⁻⁴ | 10⁻³ | 10⁻² | 10⁻¹ |
//! |---|---|---|---|---|
//! | e_n: backward difference | 0.00113 | 0.00171 | 0.01070 | 0.07253 |
//! | e_n: filtered difference | 0.00113 | 0.00114 | 0.00225 | 0.01036 |
//! | e_n: high-gain, order 1 | 0.00113 | 0.00115 | 0.00239 | 0.00905 |
//! | model: backward difference | 0.00113 | 0.00158 | 0.00983 | 0.06963 |
//! | model: high-gain, order 1 | 0.00125 | 0.00210 | 0.00507 | 0.01332 |
//! | model: high-gain, order 2 | 0.00057 | 0.00068 | 0.00150 | 0.00527 |
//!
//! * At σ = 10⁻⁴, a fifth of B·h² with B = 5 the bound on |Δ̇|, no law of first order gains anything: take `ModelAided::new()`, which no saturated actuator
//!   winds up.
//! * `ModelAided::through(HighGain::<_, 3>::for_noise(σ, bound on |Δ̈|, h)?)` is the best at every σ, if such a bound is known.
//! * If Δ is only known to be bounded in rate, first order: of e_n where the actuator does not saturate, else through the model. A late ė_n is that of an error
//!   that vanishes, so Δ is learned without lag; a late Δ̂ stays late, but its delay is not in the loop that learns.
//!
//! This module depends on no other.

mod backward_difference;
mod chain;
mod filtered_difference;
mod high_gain;
mod robust_exact;
mod tracking;

pub use backward_difference::BackwardDifference;
pub use filtered_difference::FilteredDifference;
pub use high_gain::HighGain;
pub use robust_exact::RobustExact;
pub use tracking::Tracking;

use crate::{
    Error, Scalar,
    error::{finite, positive, remembered},
};

/// Finds the rate of a signal from its samples.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not differentiate a signal",
    label = "not a differentiator"
)]
pub trait Differentiator {
    /// The number type of the signal.
    type Scalar: Scalar;

    /// Takes the sample `y` and finds the rate of what is not known of the signal: ẏ − ẏ_known, where `known` = ∫ẏ_known dt over the `dt` > 0
    /// seconds since the sample before. It is as if every sample so far had been greater by `known`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `dt`, [`Error::NonFinite`] for a sample or a known change that is not finite, for a sample so
    /// large that the differences with it would leave the range of the scalar, and [`Error::NonFiniteEntry`] for estimates that do. The differentiator is
    /// then as before.
    fn update_beyond(
        &mut self,
        y: Self::Scalar,
        known: Self::Scalar,
        dt: Self::Scalar,
    ) -> Result<Self::Scalar, Error>;

    /// Takes the sample `y` and finds ẏ; `dt` > 0 is the time since the sample before, in seconds.
    ///
    /// # Errors
    /// As [`update_beyond`](Self::update_beyond).
    fn update(&mut self, y: Self::Scalar, dt: Self::Scalar) -> Result<Self::Scalar, Error> {
        self.update_beyond(y, nalgebra::zero(), dt)
    }

    /// Forgets the samples so far.
    fn reset(&mut self);
}

/// What every differentiator refuses: also a sample that is so large that its differences over `span`, which `name` names, leave the range of `T`.
fn validated<T: Scalar>(name: &'static str, y: T, known: T, dt: T, span: T) -> Result<(), Error> {
    finite("y", y)?;
    finite("known change of y", known)?;
    positive("dt", dt)?;
    remembered(name, y, span)?;
    Ok(())
}
