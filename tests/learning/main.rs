//! Learning on the closed-loop error against closed forms, convergence orders and worst cases.

/// Runs each law, a function generic over the scalar, as one test in `f32` and one in `f64`.
macro_rules! in_both_precisions {
    ($($law:ident),+ $(,)?) => {
        mod in_f32 {
            $(#[test] fn $law() { super::$law::<f32>(); })+
        }
        mod in_f64 {
            $(#[test] fn $law() { super::$law::<f64>(); })+
        }
    };
}

mod antecedents;
mod bounded;
mod certificate;
mod compensator;
mod error_rate;
mod gradient_descent;
mod monitor;
mod neuro_fuzzy;
mod rule;
mod sliding_mode;
mod support;
mod switching;
