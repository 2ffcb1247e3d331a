//! Controllers: gains, the linearizing law, closed-loop error learning, and the simulation study of the paper.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod clelc;
mod decoupling;
mod feedback_linearization;
mod gains;
mod limited;
mod measurement;
mod paper;
mod reference;
mod support;
mod unicycle;

/// Tests of the given names, each a module that runs a check generic over the scalar at f32 and at f64.
macro_rules! at_f32_and_f64 {
    ($($name:ident => $check:ident),+ $(,)?) => {
        $(mod $name {
            #[test]
            fn f32() {
                super::$check::<f32>();
            }

            #[test]
            fn f64() {
                super::$check::<f64>();
            }
        })+
    };
}
pub(crate) use at_f32_and_f64;
