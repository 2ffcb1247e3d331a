//! Elementary functions of any number.

use brunovsky::elementary::{cos, hypot, sin, sin_cos};

use super::{Bytes, Float, attack, numbers::Numbers};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    while !bytes.is_empty() {
        let (x, y) = (bytes.number::<T>(), bytes.number::<T>());
        let (s, c) = sin_cos(x);
        // Each is off by an ulp at the most.
        let rounding: T = T::default_epsilon() * nalgebra::convert(4.0);
        if x.are_finite() {
            assert!((s * s + c * c - T::one()).abs() <= rounding, "{s}² + {c}² of {x}");
            assert_eq!([sin(x), cos(x)].bits(), [s, c].bits());
        } else {
            assert!(!s.are_finite() && !c.are_finite(), "{s}, {c} of {x}");
        }
        let length = hypot(x, y);
        if x.are_finite() && y.are_finite() {
            // ∞ where the length is beyond the range, and no NaN.
            assert!(length >= x.abs().max(y.abs()), "{length} of {x}, {y}");
        } else {
            assert!(!length.are_finite(), "{length} of {x}, {y}");
        }
    }
}
