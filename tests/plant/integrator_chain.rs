//! The chain of integrators under a constant input moves along a polynomial of degree N.

use brunovsky::{
    Scalar,
    plant::{FeedbackLinearizable, IntegratorChain},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, flow, num},
};

/// xᵢ(t) = Σⱼ xᵢ₊ⱼ·tʲ/j! + u·t^(N−i)/(N−i)!, by Horner's rule from the input inwards.
fn polynomial<T: Scalar, const N: usize>(x: &SVector<T, N>, u: T, t: T) -> SVector<T, N> {
    SVector::from_fn(|i, _| {
        (i..N).rev().fold(u, |above, j| x[j] + above * t / num((j + 1 - i) as f64))
    })
}

fn follows_the_polynomial<T: Scalar, const N: usize>(x: [f64; 4], u: f64, t: f64) {
    let x = SVector::<T, N>::from_fn(|i, _| num(x[i]));
    let (u, t) = (num::<T>(u), num::<T>(t));
    // Rk4 is the Taylor series up to h⁴ on a linear system, and the polynomial has degree N ≤ 4: one step is exact. Its stages sum
    // some 30 products whose factors are at most 5, t⁴ and the binomial weights.
    let found = flow(&IntegratorChain::<T, N>::new(), x, [u], t, 1);
    assert_equal_to_rounding(&found, &polynomial(&x, u, t), 1e3);
}

proptest! {
    #[test]
    fn one_step_of_order_four_is_exact_up_to_four_integrators(
        x in prop::array::uniform4(-5.0..5.0_f64), u in -5.0..5.0_f64, t in 0.01..2.0_f64,
    ) {
        follows_the_polynomial::<f32, 1>(x, u, t);
        follows_the_polynomial::<f32, 2>(x, u, t);
        follows_the_polynomial::<f32, 3>(x, u, t);
        follows_the_polynomial::<f32, 4>(x, u, t);
        follows_the_polynomial::<f64, 1>(x, u, t);
        follows_the_polynomial::<f64, 2>(x, u, t);
        follows_the_polynomial::<f64, 3>(x, u, t);
        follows_the_polynomial::<f64, 4>(x, u, t);
    }
}

/// With five integrators the method of order four misses the last term of the series, u·h⁵/5!, in x₁ and nothing else.
fn misses_only_the_fifth_term<T: Scalar>() {
    let x = SVector::<T, 5>::from([0.5, -1.0, 2.0, -0.25, 1.5].map(num));
    let (u, h) = (num::<T>(3.0), num::<T>(0.5));
    let found = flow(&IntegratorChain::<T, 5>::new(), x, [u], h, 1);
    let mut expected = polynomial(&x, u, h);
    expected[0] -= u * h.powi(5) / num(120.0);
    assert_equal_to_rounding(&found, &expected, 16.0);
}

fn is_the_brunovsky_form<T: Scalar>() {
    let plant = IntegratorChain::<T, 3>::new();
    let x = SVector::from([7.0, -8.0, 9.0].map(num));
    assert_eq!(plant.drift(&x), T::zero());
    assert_eq!(plant.input_gain(&x), T::one());
}

at_f32_and_f64! {
    a_fifth_integrator_costs_exactly_the_fifth_term => misses_only_the_fifth_term,
    drift_is_zero_and_input_gain_is_one => is_the_brunovsky_form,
}
