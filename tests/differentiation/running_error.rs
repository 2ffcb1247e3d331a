//! The bound on rounding errors against the same computation in a higher precision, and what counts as zero.

use brunovsky::{
    Scalar,
    differentiation::{Jet, RunningError, Smooth},
};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{functions, num},
};

/// Formulas with cancellation in them.
fn formulas<T: Scalar, S: Smooth<T>>(x: S, y: S) -> [S; 6] {
    let (sin, cos) = x.sin_cos();
    [
        (x + y) * (x - y) - (x * x - y * y),
        sin * sin + cos * cos - T::one(),
        (x * y).exp() - x.exp().powf(num(0.5)),
        ((x + num::<T>(100.0)).sqrt() - num::<T>(10.0)) / y,
        x.atan2(y) - (x / y).atan(),
        x.tanh() - x.sinh() / x.cosh(),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// f64 knows the exact result to 10⁻⁹ of the rounding of f32. Its arguments are those of f32, rounded already.
    #[test]
    fn single_precision_is_within_the_bound_of_double(x in 0.2..0.8_f32, y in 0.2..0.8_f32) {
        let exact = formulas::<f64, f64>(x.into(), y.into());
        let found = formulas::<f32, _>(RunningError::from(x), RunningError::from(y));
        for (i, (found, exact)) in found.iter().zip(exact).enumerate() {
            let error = (f64::from(found.value()) - exact).abs();
            prop_assert!(error <= f64::from(found.rounding()) + 1e-14, "{i}: {error} {found:?}");
        }
        let exact = functions::<f64, f64>(x.into());
        for ((name, found), (_, exact)) in functions::<f32, _>(RunningError::from(x)).iter().zip(&exact) {
            let error = (f64::from(found.value()) - exact).abs();
            prop_assert!(error <= f64::from(found.rounding()) + 1e-14, "{name}: {error} {found:?}");
            // A bound that is sound by being useless would help nobody.
            prop_assert!(f64::from(found.rounding()) <= 1e-4 * (1.0 + exact.abs()), "{name}: {found:?}");
        }
    }

    /// The same inside derivatives.
    #[test]
    fn derivatives_in_single_precision_are_within_the_bound_of_double(
        x in prop::array::uniform4(0.2..0.8_f32), y in prop::array::uniform4(0.2..0.8_f32),
    ) {
        let exact = formulas::<f64, _>(Jet::new(x.map(f64::from)), Jet::new(y.map(f64::from)));
        let found = formulas::<f32, _>(Jet::new(x.map(RunningError::from)), Jet::new(y.map(RunningError::from)));
        for (i, (found, exact)) in found.iter().zip(exact).enumerate() {
            for (found, exact) in found.derivatives().iter().zip(exact.derivatives()) {
                let error = (f64::from(found.value()) - exact).abs();
                prop_assert!(error <= f64::from(found.rounding()) + 1e-12, "{i}: {error} {found:?}");
            }
        }
    }
}

fn zero_up_to_rounding_counts_as_zero<T: Scalar>() {
    let number = |value: f64| RunningError::from(num::<T>(value));
    for value in [0.1, 0.7, 2.0, 30.0] {
        let (sin, cos) = number(value).sin_cos();
        assert!((sin * sin + cos * cos - T::one()).vanishes());
        assert!((number(value) / num::<T>(3.0) * num::<T>(3.0) - num::<T>(value)).vanishes());
        // A small number is not zero: its error is as small.
        assert!(!(number(value) * num::<T>(1e-30)).vanishes());
        // Nor is a difference that is a thousand roundings away.
        let away = num::<T>(1000.0) * T::default_epsilon();
        assert!(!(number(value) * (T::one() + away) - num::<T>(value)).vanishes());
    }
    assert!((number(0.1) + num::<T>(0.2) - num::<T>(0.3)).vanishes());
    assert!(RunningError::<T>::zero().vanishes() && !RunningError::<T>::one().vanishes());
}

at_f32_and_f64! {
    what_is_zero_up_to_rounding_vanishes => zero_up_to_rounding_counts_as_zero,
}
