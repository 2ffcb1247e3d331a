//! Numbers in the scalar of a check, and how many random cases it takes.

use brunovsky::{Scalar, nalgebra};
use proptest::prelude::ProptestConfig;

/// `count` random cases; failures are shown and not written to a file.
pub fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

pub fn real<T: Scalar>(x: f64) -> T {
    nalgebra::convert(x)
}

/// `ulps` times the spacing of numbers at 1.
pub fn ulps<T: Scalar>(ulps: f64) -> T {
    T::default_epsilon() * real(ulps)
}
