//! The sampled-data loop against independent integration and closed forms, and figures of merit against their definitions.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod closed_loop;
mod error_metrics;
mod step_info;
mod total_variation;

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

/// `value` in the scalar type of the check.
fn num<T: brunovsky::Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}
