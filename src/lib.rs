#![cfg_attr(not(any(feature = "csv", feature = "plot")), no_std)]
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! Control of uncertain nonlinear systems: feedback linearization that learns on its closed-loop error.
//!
//! A plant of order n with an uncertainty Δ, and the law that controls it (closed-loop error learning control, CLELC):
//!
//! ```text
//! ẋᵢ = xᵢ₊₁,  ẋ_n = a(x) + b(x)·u + Δ(t, x, u)
//!
//! u = b(x)⁻¹·(−a(x) + u_f + u_b + u_n)
//!       u_f = ṙ_n              feedforward from the reference
//!       u_b = k·e              feedback of the error e = r − x
//!       u_n                    a neuro-fuzzy network, trained by u̇_n = α·sgn(s) on s = ė_n + u_b = −(u_n + Δ)
//! ```
//!
//! The network takes over from the feedback what the model did not know. The crate is `no_std`, does not allocate, contains no
//! `unsafe`, and works for `f32` and `f64`.
//!
//! | room | what is in it | depends on |
//! |---|---|---|
//! | [`differentiation`] | numbers that carry derivatives, or their own rounding error | – |
//! | [`plant`] | what is controlled: three rungs of traits, plants by their equations, named plants, uncertainty | differentiation |
//! | [`integrators`] | ẋ = f(t, x) with fixed or adaptive steps, stiff or not; events | – |
//! | [`fuzzy`] | membership functions, rule grid, networks of type 1 and interval type 2 | – |
//! | [`differentiator`] | the rate of a sampled signal: differences, robust exact, high-gain, tracking | – |
//! | [`learning`] | sources of ė_n, adaptation rules, compensators, certificates | fuzzy, differentiator |
//! | [`channel`] | what becomes of signals on their way: limits, lag, delay, quantization, noise, losses | – |
//! | [`controller`] | feedback linearization, CLELC, and what they are compared with; decoupling, the unicycle | plant, learning, channel |
//! | [`elementary`] | sine, cosine, hypotenuse in the scalar's own precision | – |
//! | [`trajectory`] | references r(t) with their derivatives: analytic curves, minimum jerk, constant speed | controller |
//! | [`simulation`] | the sampled loop with sensors, actuators and clocks of their own; figures of merit | all |
//! | `ensemble` | many runs of an experiment in parallel, sweeps, statistics (feature) | – |
//!
//! The [`prelude`] names what a typical program needs. [`nalgebra`] is re-exported, so that its version fits.
//!
//! # Features
//! * `std` (default): elementary functions of the platform. Without it they come from `libm`, and the crate needs neither an
//!   operating system nor an allocator.
//! * `reproducible`: the functions of `libm` with `std` too, for the same bits on every platform.
//! * `random`: channels that draw random numbers: noise, losses. It needs no `std` and no allocator.
//! * `serde`: plants, controllers, learners, trajectories are saved with all that they have learned, and go on bit for bit when they are
//!   loaded. Loading checks what the constructors check. It needs neither `std` nor an allocator. See [Saving and loading](saving).
//! * `ensemble`: Monte Carlo ensembles and sweeps; `parallel` runs them on all cores, `progress` shows how far they are.
//!
//! [Which controller, when](comparison) puts all controllers beside each other on four plants. [From simulation to hardware](hardware) is a page for
//! those who put a controller on a machine.

#[cfg(any(doc, doctest))]
#[doc = include_str!("../docs/hardware.md")]
pub mod hardware {}

#[cfg(any(doc, doctest))]
#[doc = include_str!("../docs/comparison.md")]
pub mod comparison {}

#[cfg(any(doc, doctest))]
#[doc = include_str!("../docs/saving.md")]
pub mod saving {}

#[macro_use]
mod checked;

pub mod channel;
pub mod controller;
pub mod differentiation;
pub mod differentiator;
pub mod elementary;
#[cfg(feature = "ensemble")]
pub mod ensemble;
pub mod fuzzy;
pub mod integrators;
pub mod learning;
pub mod plant;
#[cfg(feature = "plot")]
pub mod plot;
pub mod prelude;
pub mod simulation;
pub mod trajectory;

#[cfg(feature = "serde")]
mod array;
mod conditioning;
mod error;
mod inverse;
mod scalar;

#[cfg(feature = "ensemble")]
extern crate std;

pub use error::Error;
pub use nalgebra;
pub use scalar::Scalar;

/// The program of the README compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
