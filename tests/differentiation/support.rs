//! What the modules of this room share.

use brunovsky::{
    Scalar,
    differentiation::{Jet, Smooth},
};

/// `value` in the scalar type of the check.
pub fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// Every derivative is within `roundings` units of rounding, relative to the largest expected so far, or 1.
pub fn assert_jets_equal<T: Scalar, const K: usize>(
    found: Jet<T, K>,
    expected: Jet<T, K>,
    roundings: f64,
) {
    let mut scale = T::one();
    for (found, expected) in found.derivatives().iter().zip(expected.derivatives()) {
        scale = scale.max(expected.abs());
        let limit = scale * T::default_epsilon() * num(roundings);
        assert!((*found - *expected).abs() <= limit, "{found} is not {expected}");
    }
}

/// The elementary functions that are smooth around 0.3, each with its name.
pub fn functions<T: Scalar, S: Smooth<T>>(x: S) -> [(&'static str, S); 20] {
    [
        ("sin", x.sin()),
        ("cos", x.cos()),
        ("tan", x.tan()),
        ("asin", x.asin()),
        ("acos", x.acos()),
        ("atan", x.atan()),
        ("atan2 above", x.atan2(x * x + num::<T>(1.0))),
        ("atan2 left", x.atan2(-x - num::<T>(1.0))),
        ("sinh", x.sinh()),
        ("cosh", x.cosh()),
        ("tanh", x.tanh()),
        ("exp", x.exp()),
        ("ln", x.ln()),
        ("sqrt", x.sqrt()),
        ("powf", x.powf(num(-1.7))),
        ("powi", x.powi(5)),
        ("negative powi", x.powi(-3)),
        ("recip", x.recip()),
        ("hypot", x.hypot(x * x)),
        ("abs", (-x).abs() * x),
    ]
}
