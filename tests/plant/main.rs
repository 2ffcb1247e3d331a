//! Plants: closed forms, conservation laws and symmetries of the benchmark plants, and the ladder of plant traits.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod integrator_chain;
mod ladder;
mod pendulum;
mod support;
mod third_order;
mod tracked_robot;
mod two_link_arm;
mod uncertain;
mod unicycle;
mod van_der_pol;

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
