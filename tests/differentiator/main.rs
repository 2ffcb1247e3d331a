//! The rate of a sampled signal against polynomials, impulse responses, scaling laws and worst cases.

#[macro_use]
#[path = "../common/laws.rs"]
mod laws;
#[path = "../common/numbers.rs"]
mod numbers;

mod backward_difference;
mod every;
mod filtered_difference;
mod high_gain;
mod robust_exact;
mod support;
mod tracking;
