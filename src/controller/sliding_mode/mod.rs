//! Sliding-mode controllers: σ = 0 is reached in finite time and kept, whatever a bounded uncertainty does.
//!
//! | law | what it assumes of Δ | what it adds to the feedback | sampled, it leaves of σ |
//! |---|---|---|---|
//! | [`SlidingModeControl`] | \|Δ\| ≤ B < k | k·sgn(σ) | h·Δ, with the set-valued sign |
//! | [`SuperTwisting`] | \|Δ̇\| ≤ L | k₁·\|σ\|^½·sgn(σ) + w, ẇ = k₂·sgn(σ) | h²·Δ̇ |
//! | [`IntegralSlidingMode`] | \|Δ\| ≤ B < k | k·sgn(∫s dt), to any feedback, from the first instant on | h·Δ |
//!
//! σ is a [`SlidingSurface`] of the first two; the third has none to choose. Signs as everywhere: e = r − x, so σ̇ = −k·sgn(σ) − Δ, and
//! the added term becomes −Δ, as u_n does in [`Clelc`](super::Clelc).

mod integral;
mod sign;
mod sliding_mode_control;
mod super_twisting;
mod super_twisting_gains;
mod surface;

pub use integral::IntegralSlidingMode;
pub use sliding_mode_control::{SlidingModeCommand, SlidingModeControl};
pub use super_twisting::{Stepping, SuperTwisting, SuperTwistingCommand};
pub use super_twisting_gains::SuperTwistingGains;
pub use surface::SlidingSurface;
