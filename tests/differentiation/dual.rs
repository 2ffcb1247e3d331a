//! Slopes against num_dual, and slopes of derivatives against derivatives of slopes.

use brunovsky::differentiation::{Dual, Jet, Smooth};
use num_dual::Dual64;
use proptest::prelude::*;

use crate::support::{assert_jets_equal, functions};

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn slopes_are_those_of_num_dual(value in 0.2..0.8_f64, slopes in prop::array::uniform2(-1.0..1.0_f64)) {
        let ours = functions(Dual { value, slopes });
        for (j, slope) in slopes.into_iter().enumerate() {
            let theirs = functions::<Dual64, _>(Dual64::new(value, slope));
            for ((name, ours), (_, theirs)) in ours.iter().zip(&theirs) {
                prop_assert!((ours.value - theirs.re).abs() <= 1e-15 * (1.0 + theirs.re.abs()), "{name}");
                let scale = 1.0 + theirs.eps.abs();
                prop_assert!((ours.slopes[j] - theirs.eps).abs() <= 1e-14 * scale, "{name}");
            }
        }
    }

    /// ∂/∂ε and d/dt commute: a dual of jets is a jet of duals, with the entries in another order.
    #[test]
    fn the_slope_of_a_derivative_is_the_derivative_of_the_slope(
        value in 0.2..0.8_f64, rates in prop::array::uniform3(-1.0..1.0_f64), slopes in prop::array::uniform4(-1.0..1.0_f64),
    ) {
        let entries = [value, rates[0], rates[1], rates[2]];
        let outside = functions(Dual { value: Jet::new(entries), slopes: [Jet::new(slopes)] });
        let inside = core::array::from_fn(|k| Dual { value: entries[k], slopes: [slopes[k]] });
        for ((_, outside), (_, inside)) in outside.iter().zip(&functions(Jet::new(inside))) {
            assert_jets_equal(outside.value, Jet::new(inside.derivatives().map(|entry| entry.value)), 1e4);
            let expected = inside.derivatives().map(|entry| entry.slopes[0]);
            assert_jets_equal(outside.slopes[0], Jet::new(expected), 1e6);
        }
    }

    #[test]
    fn a_gradient_is_made_of_the_slopes_of_the_variables(x in -2.0..2.0_f64, y in -2.0..2.0_f64) {
        let (a, b) = (Dual::<f64, 2>::variable(x, 0), Dual::variable(y, 1));
        let found = a * b.sin() + a * a / (b * b + 1.0);
        let square = y * y + 1.0;
        let expected = [y.sin() + 2.0 * x / square, x * y.cos() - 2.0 * x * x * y / (square * square)];
        for (found, expected) in found.slopes.iter().zip(expected) {
            prop_assert!((found - expected).abs() <= 1e-14 * 10.0);
        }
    }
}
