//! Nothing that a sensor or a caller sends breaks the crate: the attacks of the fuzz targets, as property tests.

// Helpers stand outside of the `#[test]` functions, where clippy's allowance for tests does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod driver;
mod operator;
mod outliers;

use proptest::prelude::*;

/// Bytes of an attack: single ones, and tags of a number with any bit pattern behind them.
fn bytes() -> impl Strategy<Value = Vec<u8>> {
    let number = (24..40_u8, any::<u64>())
        .prop_map(|(tag, bits)| [&[tag][..], &bits.to_le_bytes()].concat());
    let piece = prop_oneof![
        12 => (48..=255_u8).prop_map(|moderate| vec![moderate]),
        3 => any::<u8>().prop_map(|byte| vec![byte]),
        1 => number,
    ];
    prop::collection::vec(piece, 0..120).prop_map(|pieces| pieces.concat())
}

/// One test an attack and a precision, each with all that `Debug` prints compared.
macro_rules! withstand {
    ($($attack:ident),+ $(,)?) => {
        $(mod $attack {
            use super::*;

            proptest! {
                #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(3000) })]

                #[test]
                fn withstands_anything_in_f32(bytes in bytes()) {
                    driver::$attack::attack(&[&[3], &bytes[..]].concat());
                }

                #[test]
                fn withstands_anything_in_f64(bytes in bytes()) {
                    driver::$attack::attack(&[&[2], &bytes[..]].concat());
                }
            }
        })+
    };
}

withstand! {
    chain, channel, classical, decoupling, differentiator, elementary, gains, learner, network, simulation, sliding, solver, trajectory, unicycle, watch, wrapped,
}
