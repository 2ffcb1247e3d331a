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
    error::{finite, positive},
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
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `dt`, [`Error::NonFinite`] for a sample or a known change that is not finite or
    /// an estimate that leaves the range of the scalar. The differentiator is then as before.
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

/// What every differentiator refuses.
fn validated<T: Scalar>(y: T, known: T, dt: T) -> Result<(), Error> {
    finite("y", y)?;
    finite("known change of y", known)?;
    positive("dt", dt)?;
    Ok(())
}
