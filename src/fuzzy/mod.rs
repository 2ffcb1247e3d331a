//! The neuro-fuzzy network: a zeroth-order Takagi–Sugeno–Kang model on a full grid of rules.
//!
//! With I inputs eᵢ and K Gaussian [memberships](Gaussian) an input, every combination of memberships is a rule, Kᴵ in all:
//!
//! | quantity | law | equation |
//! |---|---|---|
//! | membership grade | μᵢₖ = exp(−Mᵢₖ²/2), Mᵢₖ = (eᵢ − cᵢₖ)/σᵢₖ | eq_mu |
//! | firing strength | w_r = Πᵢ μᵢₖ (product t-norm) | eq_wr |
//! | normalized firing strength | w̃_r = w_r/Σw | eq_wrwidetilde |
//! | output | u_n = Σ w̃_r·f_r | eq_un |
//!
//! Over a full grid the sum of products is the product of sums, so w̃ is the outer product of grades normalized input by
//! input: I·K exponentials, no quotient of vanishing sums (see [`FuzzyNetwork::fire`]).
//!
//! Rules and consequents are numbered with the **last input fastest**: rule r = k₁·Kᴵ⁻¹ + … + k_I for the memberships
//! (k₁, …, k_I), all counted from 0.
//!
//! What others may ask of a network is said by traits:
//!
//! | trait | what it is | networks |
//! |---|---|---|
//! | [`Network`] | u_n = w̃ᵀf, w̃ ≥ 0 and Σ w̃ = 1: all that a rule of [`learning`](crate::learning) needs | [`FuzzyNetwork`] |
//! | [`Over`] | how many inputs it has | all |
//! | [`Travelling`] | its memberships can go along with the input, and flow | [`FuzzyNetwork`] |
//!
//! This module depends on nothing but [`Scalar`](crate::Scalar) and [`Error`](crate::Error); who trains the network is the business of
//! [`learning`](crate::learning).

mod gaussian;
mod grades;
mod grid;
mod network;
mod rules;
mod traits;
mod travel;

pub use gaussian::Gaussian;
pub use grid::{Grid, Inputs, PerRule};
pub use network::{Firing, FuzzyNetwork};
pub use rules::Rules;
pub use traits::{Network, Over, Strengths, Travelling};
