//! Gains against binomials, against the polynomial of their poles, and Routh's criterion against eigenvalues.

use brunovsky::{Error, Scalar, controller::Gains};
use nalgebra::{Complex, DMatrix, SVector, Schur};
use proptest::prelude::*;

use crate::{at_f32_and_f64, support::num};

/// k_i = C(N, i−1)·λ^(N+1−i) (eq_ks), with the binomials from Pascal's rule in whole numbers.
fn has_binomial_gains<T: Scalar, const N: usize>(lambda: f64) {
    let mut row = vec![1_u64];
    for _ in 0..N {
        let inner = row.windows(2).map(|pair| pair[0] + pair[1]);
        row = core::iter::once(1).chain(inner).chain([1]).collect();
    }
    let expected = SVector::<T, N>::from_fn(|i, _| {
        num::<T>(row[i] as f64) * num::<T>(lambda).powi((N - i) as i32)
    });
    let lambda = num::<T>(lambda);
    let found = Gains::<T, N>::from_lambda(lambda).unwrap();
    // At most 2N roundings each of products; the coefficients of (p + λ)ᴺ are sums of positive terms, so nothing cancels there either.
    let tolerance = T::default_epsilon() * num(8.0 * N as f64);
    let placed = Gains::<T, N>::from_poles([-lambda; N]).unwrap();
    for gains in [found, placed] {
        approx::assert_relative_eq!(
            *gains.as_vector(),
            expected,
            epsilon = T::zero(),
            max_relative = tolerance
        );
        // Entry by entry too: the matrix norm would hide a small entry beside a large one.
        for (found, expected) in gains.as_vector().iter().zip(expected.iter()) {
            approx::assert_relative_eq!(*found, *expected, max_relative = tolerance);
        }
    }
}

/// |p(z)| for p(z) = zᴺ + k_N·zᴺ⁻¹ + … + k₁, relative to the sum of the sizes of its terms.
fn residual<T: Scalar, const N: usize>(gains: &Gains<T, N>, z: Complex<f64>) -> f64 {
    let coefficients = gains.as_vector().iter().rev();
    let (mut value, mut size) = (Complex::new(1.0, 0.0), 1.0);
    for k in coefficients {
        let k: f64 = nalgebra::try_convert(*k).unwrap();
        value = value * z + k;
        size = size * z.norm() + k.abs();
    }
    value.norm() / size
}

fn vanishes_at_its_poles<T: Scalar>(real: [f64; 2], pair: (f64, f64)) {
    let z = Complex::new(pair.0, pair.1);
    let poles = [real[0].into(), z, real[1].into(), z.conj()];
    let in_t = poles.map(|pole: Complex<f64>| Complex::new(num::<T>(pole.re), num(pole.im)));
    let gains = Gains::<T, 4>::from_poles(in_t).unwrap();
    // The poles are rounded to T and the coefficients see four products.
    let tolerance = 32.0 * nalgebra::try_convert::<T, f64>(T::default_epsilon()).unwrap();
    for pole in poles {
        assert!(residual(&gains, pole) <= tolerance, "{pole} {gains:?}");
    }
}

/// The largest real part of the roots of pᴺ + k_N·pᴺ⁻¹ + … + k₁, as the eigenvalues of its companion matrix; `None` for the rare
/// matrix on which the QR iteration does not converge.
fn rightmost_root<const N: usize>(k: &SVector<f64, N>) -> Option<f64> {
    let companion =
        DMatrix::from_fn(
            N,
            N,
            |i, j| {
                if i + 1 == N { -k[j] } else { f64::from(u8::from(i + 1 == j)) }
            },
        );
    let roots = Schur::try_new(companion, f64::EPSILON, 1000)?.complex_eigenvalues();
    roots.iter().map(|root| root.re).reduce(f64::max)
}

/// Gains from real poles and pairs that may lie on either side of the axis, so that both verdicts come up at every order.
fn product_of_factors<const N: usize>(factors: &[(f64, f64)]) -> SVector<f64, N> {
    let mut polynomial = vec![1.0];
    let mut multiply = |factor: &[f64]| {
        let mut product = vec![0.0; polynomial.len() + factor.len() - 1];
        for (i, a) in polynomial.iter().enumerate() {
            for (j, b) in factor.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        polynomial = product;
    };
    if N % 2 == 1 {
        multiply(&[1.0, -factors[0].0]);
    }
    for (re, im) in &factors[1..=N / 2] {
        multiply(&[1.0, -2.0 * re, re * re + im * im]);
    }
    SVector::from_fn(|i, _| polynomial[N - i])
}

fn agrees_with_the_eigenvalues<const N: usize>(k: SVector<f64, N>) {
    // Multiple roots are found to ε^(1/multiplicity) only: 0.01 is more than ε^(1/6)·|root| here.
    if let Some(rightmost) = rightmost_root(&k).filter(|root| root.abs() > 0.01) {
        assert_eq!(Gains::new(k).is_ok(), rightmost < 0.0, "{k:?} {rightmost}");
    }
}

fn has_binomial_gains_up_to_order_eight<T: Scalar>(lambda: f64) {
    has_binomial_gains::<T, 1>(lambda);
    has_binomial_gains::<T, 2>(lambda);
    has_binomial_gains::<T, 3>(lambda);
    has_binomial_gains::<T, 4>(lambda);
    has_binomial_gains::<T, 5>(lambda);
    has_binomial_gains::<T, 6>(lambda);
    has_binomial_gains::<T, 7>(lambda);
    has_binomial_gains::<T, 8>(lambda);
}

proptest! {
    #[test]
    fn all_poles_at_minus_lambda_are_binomials(lambda in 0.1..10.0_f64) {
        has_binomial_gains_up_to_order_eight::<f32>(lambda);
        has_binomial_gains_up_to_order_eight::<f64>(lambda);
    }

    #[test]
    fn the_characteristic_polynomial_vanishes_at_every_pole(
        real in prop::array::uniform2(-9.0..-0.1_f64), pair in (-9.0..-0.1_f64, 0.0..9.0_f64),
    ) {
        vanishes_at_its_poles::<f32>(real, pair);
        vanishes_at_its_poles::<f64>(real, pair);
    }

    #[test]
    fn gains_are_accepted_exactly_if_all_eigenvalues_are_in_the_left_half_plane(
        factors in prop::array::uniform4((-3.0..0.7_f64, 0.0..3.0_f64)),
        k in prop::array::uniform6(-1.0..9.0_f64),
    ) {
        macro_rules! orders {
            ($($n:literal)+) => {$(
                agrees_with_the_eigenvalues::<$n>(product_of_factors(&factors));
                agrees_with_the_eigenvalues::<$n>(SVector::from_column_slice(&k[..$n]));
            )+};
        }
        orders!(1 2 3 4 5 6);
    }
}

fn are_those_of_the_paper<T: Scalar>() {
    // Powers of 3 times binomials are whole numbers.
    let study = Gains::<T, 3>::from_lambda(num(3.0)).unwrap();
    assert_eq!(*study.as_vector(), SVector::from([27.0, 27.0, 9.0].map(num)));
    let robot = Gains::<T, 2>::from_lambda(num(0.3)).unwrap();
    let expected = SVector::from([num::<T>(0.3) * num(0.3), num(0.6)]);
    approx::assert_relative_eq!(*robot.as_vector(), expected, max_relative = T::default_epsilon());
    // u_b = k·e (eq_fb), in whole numbers.
    let e = SVector::from([1.0, -1.0, 10.0].map(num));
    assert_eq!(study.feedback(&e), num(90.0));
}

fn refuses_what_is_not_hurwitz<T: Scalar>() {
    let refused = |k: [f64; 3]| Gains::<T, 3>::new(k.map(num)).unwrap_err();
    let not_hurwitz = |row, value| Error::NotHurwitz { name: "gains", row, value };
    // p³ + p² + p + 10: the third entry of the first column is (1·1 − 10)/1.
    assert_eq!(refused([10.0, 1.0, 1.0]), not_hurwitz(2, -9.0));
    // (p² + 1)·(p + 1), a pair on the axis.
    assert_eq!(refused([1.0, 1.0, 1.0]), not_hurwitz(2, 0.0));
    // p·(p + 1)·(p + 2), a root at the origin.
    assert_eq!(refused([0.0, 2.0, 3.0]), not_hurwitz(3, 0.0));
    assert_eq!(refused([27.0, 27.0, -9.0]), not_hurwitz(1, -9.0));
    assert_eq!(Gains::<T, 1>::new([T::zero()]).unwrap_err(), not_hurwitz(1, 0.0));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let entry = refused([27.0, bad, 9.0]);
        assert!(matches!(entry, Error::NonFiniteEntry { name: "gains", index: 1, .. }));
    }
}

fn refuses_a_lambda_that_is_not_positive<T: Scalar>() {
    let refused = |lambda: T| Gains::<T, 2>::from_lambda(lambda).unwrap_err();
    for value in [0.0, -0.0, -3.0] {
        assert_eq!(refused(num(value)), Error::NotPositive { name: "lambda", value });
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(refused(num(bad)), Error::NonFinite { name: "lambda", .. }));
    }
    // λ² beyond either end of the range.
    let largest = T::max_value().unwrap();
    assert!(matches!(refused(largest), Error::NonFiniteEntry { name: "gains", index: 0, .. }));
    let smallest = largest.recip();
    assert!(matches!(refused(smallest), Error::NotHurwitz { name: "gains", row: 2, .. }));
}

fn refuses_bad_poles<T: Scalar>() {
    let refused = |poles: [(f64, f64); 2]| {
        Gains::<T, 2>::from_poles(poles.map(|(re, im)| Complex::new(num::<T>(re), num(im))))
            .unwrap_err()
    };
    for value in [0.0, 2.0] {
        let right = Error::NotBelow { name: "real part of pole", value, limit: 0.0 };
        assert_eq!(refused([(-1.0, 0.0), (value, 0.0)]), right);
        assert_eq!(refused([(value, 3.0), (value, -3.0)]), right);
    }
    let unpaired = |value| Error::Unpaired { name: "imaginary part of pole", value };
    assert_eq!(refused([(-1.0, 2.0), (-1.0, 0.0)]), unpaired(2.0));
    assert_eq!(refused([(-1.0, 0.0), (-1.0, -2.0)]), unpaired(-2.0));
    assert_eq!(refused([(-1.0, 2.0), (-1.0, 2.0)]), unpaired(2.0));
    assert_eq!(refused([(-1.0, 2.0), (-1.5, -2.0)]), unpaired(2.0));
    // Products of poles beyond either end of the range.
    let largest = T::max_value().unwrap();
    let beyond = |pole: T| Gains::<T, 2>::from_poles([-pole; 2]).unwrap_err();
    assert!(matches!(beyond(largest), Error::NonFiniteEntry { name: "gains", .. }));
    assert!(matches!(beyond(largest.recip()), Error::NotHurwitz { name: "gains", .. }));
    // One conjugate cannot stand for two.
    let lopsided = [2.0, 2.0, -2.0].map(|im| Complex::new(-T::one(), num(im)));
    assert_eq!(Gains::<T, 3>::from_poles(lopsided).unwrap_err(), unpaired(2.0));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for pole in [(bad, 0.0), (-1.0, bad)] {
            assert!(matches!(refused([(-1.0, 0.0), pole]), Error::NonFinite { name: "pole", .. }));
        }
    }
}

at_f32_and_f64! {
    the_papers_lambdas_give_the_papers_gains => are_those_of_the_paper,
    positive_gains_that_are_not_hurwitz_are_refused => refuses_what_is_not_hurwitz,
    a_lambda_that_is_not_positive_is_refused => refuses_a_lambda_that_is_not_positive,
    poles_out_of_range_or_unpaired_are_refused => refuses_bad_poles,
}
