//! Taylor arithmetic against the derivatives of elementary functions in closed form, against identities, and against num_dual's third derivatives.

use brunovsky::{
    Scalar,
    differentiation::{Arithmetic, Jet, Smooth},
};
use nalgebra::ComplexField;
use num_dual::Dual3_64;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_jets_equal, functions, num},
};

/// t itself: ẋ = 1.
fn time<T: Scalar, const K: usize>(t: f64) -> Jet<T, K> {
    let mut derivatives = [T::zero(); K];
    derivatives[0] = num(t);
    derivatives[1] = T::one();
    Jet::new(derivatives)
}

fn expected<T: Scalar, const K: usize>(derivative: impl Fn(i32) -> f64) -> Jet<T, K> {
    Jet::new(core::array::from_fn(|k| num(derivative(k as i32))))
}

/// p·(p − 1)·…·(p − k + 1).
fn falling(p: f64, k: i32) -> f64 {
    (0..k).map(|j| p - f64::from(j)).product()
}

fn derivatives_are_the_closed_forms<T: Scalar>() {
    // t is a float of few digits, so that f32 starts from the same.
    let t = 0.625_f64;
    let (x, rate) = (time::<T, 7>(t), 1.5);
    let quarter = core::f64::consts::FRAC_PI_2;
    let turning = x * num::<T>(rate);
    let phase = |k: i32| rate * t + f64::from(k) * quarter;
    assert_jets_equal(turning.sin(), expected(|k| rate.powi(k) * phase(k).sin()), 16.0);
    assert_jets_equal(turning.cos(), expected(|k| rate.powi(k) * phase(k).cos()), 16.0);
    assert_jets_equal(turning.exp(), expected(|k| rate.powi(k) * (rate * t).exp()), 16.0);
    let (even, odd) = ((rate * t).cosh(), (rate * t).sinh());
    let hyperbolic =
        |k: i32, first: f64, second: f64| rate.powi(k) * if k % 2 == 0 { first } else { second };
    assert_jets_equal(turning.sinh(), expected(|k| hyperbolic(k, odd, even)), 16.0);
    assert_jets_equal(turning.cosh(), expected(|k| hyperbolic(k, even, odd)), 16.0);
    let power = |p: f64| move |k: i32| falling(p, k) * t.powf(p - f64::from(k));
    assert_jets_equal(x.sqrt(), expected(power(0.5)), 64.0);
    assert_jets_equal(x.recip(), expected(power(-1.0)), 64.0);
    // The sums behind a non-integer power alternate; their terms are some ten times the result.
    assert_jets_equal(x.powf(num(2.25)), expected(power(2.25)), 640.0);
    assert_jets_equal(x.powi(4), expected(power(4.0)), 64.0);
    assert_jets_equal(x.powi(-2), expected(power(-2.0)), 64.0);
    let logarithm = |k: i32| if k == 0 { t.ln() } else { falling(-1.0, k - 1) / t.powi(k) };
    assert_jets_equal(x.ln(), expected(logarithm), 64.0);
    // tan′ = 1 + tan², and the same once more: the polynomials in tan of the literature.
    let tan = t.tan();
    let square = 1.0 + tan * tan;
    let polynomials = [tan, square, 2.0 * tan * square, 2.0 * square * (1.0 + 3.0 * tan * tan)];
    let found = time::<T, 4>(t).tan();
    assert_jets_equal(found, expected(|k| polynomials[k as usize]), 64.0);
    let tanh = t.tanh();
    let square = 1.0 - tanh * tanh;
    let polynomials =
        [tanh, square, -2.0 * tanh * square, -2.0 * square * (1.0 - 3.0 * tanh * tanh)];
    assert_jets_equal(time::<T, 4>(t).tanh(), expected(|k| polynomials[k as usize]), 64.0);
    // atan″ = −2t·atan′², and asin″ = t·asin′³.
    let slope = 1.0 / (1.0 + t * t);
    let derivatives = [t.atan(), slope, -2.0 * t * slope * slope];
    assert_jets_equal(time::<T, 3>(t).atan(), expected(|k| derivatives[k as usize]), 64.0);
    let slope = 1.0 / (1.0 - t * t).sqrt();
    let derivatives = [t.asin(), slope, t * slope.powi(3)];
    assert_jets_equal(time::<T, 3>(t).asin(), expected(|k| derivatives[k as usize]), 64.0);
}

fn jet() -> impl Strategy<Value = Jet<f64, 6>> {
    (0.2..0.8_f64, prop::array::uniform5(-1.0..1.0_f64))
        .prop_map(|(value, [a, b, c, d, e])| Jet::new([value, a, b, c, d, e]))
}

/// Up to the fifth derivative at values above 0.2: sums of terms like 5!/0.2⁶, each with a few roundings.
const ROUNDINGS: f64 = 1e7;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_function_after_its_inverse_is_the_identity(a in jet()) {
        assert_jets_equal(a.asin().sin(), a, ROUNDINGS);
        assert_jets_equal(a.acos().cos(), a, ROUNDINGS);
        assert_jets_equal(a.atan().tan(), a, ROUNDINGS);
        assert_jets_equal(a.ln().exp(), a, ROUNDINGS);
        assert_jets_equal(a.sqrt().powi(2), a, ROUNDINGS);
        assert_jets_equal(a.powf(1.6).powf(1.0 / 1.6), a, ROUNDINGS);
        assert_jets_equal(a.recip().recip(), a, ROUNDINGS);
        assert_jets_equal(a.sin().asin(), a, ROUNDINGS);
        assert_jets_equal(a.exp().ln(), a, ROUNDINGS);
    }

    #[test]
    fn functions_keep_their_identities(a in jet(), b in jet()) {
        let one = Jet::one();
        assert_jets_equal(a.sin() * a.sin() + a.cos() * a.cos(), one, 1e4);
        assert_jets_equal(a.cosh() * a.cosh() - a.sinh() * a.sinh(), one, 1e4);
        assert_jets_equal(a.tanh() * a.cosh(), a.sinh(), 1e4);
        assert_jets_equal((a + b).exp(), a.exp() * b.exp(), 1e4);
        assert_jets_equal((a + b).sin(), a.sin() * b.cos() + a.cos() * b.sin(), 1e4);
        assert_jets_equal(b.atan2(a), (b / a).atan(), ROUNDINGS);
        assert_jets_equal(a.hypot(b) * a.hypot(b), a * a + b * b, ROUNDINGS);
        assert_jets_equal(a.powf(3.0), a.powi(3), ROUNDINGS);
        assert_jets_equal((a / b) * b, a, ROUNDINGS);
    }

    #[test]
    fn jets_are_a_commutative_ring(a in jet(), b in jet(), c in jet()) {
        assert_jets_equal(a * b, b * a, 1e3);
        assert_jets_equal((a * b) * c, a * (b * c), 1e4);
        assert_jets_equal(a * (b + c), a * b + a * c, 1e3);
        prop_assert_eq!(a - a, Jet::zero());
        prop_assert_eq!(a * Jet::one(), a);
        prop_assert_eq!(a.times(3.0) , a * 3.0);
    }

    /// num_dual propagates three derivatives by hand-written chain rules; ours come from the recursion of the differential equation of each function.
    #[test]
    fn three_derivatives_are_those_of_num_dual(value in 0.2..0.8_f64, rates in prop::array::uniform3(-1.0..1.0_f64)) {
        let ours = functions(Jet::new([value, rates[0], rates[1], rates[2]]));
        let theirs = functions::<Dual3_64, _>(Dual3_64::new(value, rates[0], rates[1], rates[2]));
        for ((name, ours), (_, theirs)) in ours.iter().zip(&theirs) {
            let theirs = [theirs.re, theirs.v1, theirs.v2, theirs.v3];
            let scale = theirs.iter().fold(1.0, |scale: f64, entry| scale.max(entry.abs()));
            for (ours, theirs) in ours.derivatives().iter().zip(theirs) {
                prop_assert!((ours - theirs).abs() <= 1e-12 * scale, "{name}: {ours} {theirs}");
            }
        }
    }
}

#[test]
fn the_motion_of_a_rate_has_that_rate() {
    let rate = Jet::new([2.0, 3.0, 4.0]);
    assert_eq!(Jet::starting(1.0, &rate), Jet::new([1.0, 2.0, 3.0, 4.0]));
    assert_eq!(Jet::starting(1.0, &rate), Jet::new([1.0, 2.0]));
    assert_eq!(Jet::starting(1.0, &rate), Jet::new([1.0, 2.0, 3.0, 4.0, 0.0, 0.0]));
    assert_eq!(Jet::<f64, 3>::constant(5.0), Jet::new([5.0, 0.0, 0.0]));
}

#[test]
fn a_jet_of_one_entry_is_its_value_bit_for_bit() {
    for (jet, (_, value)) in functions(Jet::new([0.3_f64])).iter().zip(functions(0.3_f64)) {
        let ((name, jet), value) = (jet, ComplexField::real(value));
        // hypot of a plain number scales against overflow.
        if *name != "hypot" {
            assert_eq!(jet.derivatives(), &[value], "{name}");
        }
    }
}

at_f32_and_f64! {
    derivatives_of_elementary_functions_are_the_closed_forms => derivatives_are_the_closed_forms,
}
