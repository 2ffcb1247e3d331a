//! Learning on the closed-loop error against closed forms, convergence orders and worst cases.

#[macro_use]
#[path = "../common/laws.rs"]
mod laws;
#[path = "../common/numbers.rs"]
mod numbers;

mod adaptive_sliding_mode;
mod advisor;
mod antecedents;
mod bounded;
mod certificate;
mod compensator;
mod error_rate;
mod every;
mod gradient_descent;
mod guarded;
mod monitor;
mod neuro_fuzzy;
mod recursive_least_squares;
mod rule;
mod sliding_mode;
mod support;
mod switching;
mod watchdog;
