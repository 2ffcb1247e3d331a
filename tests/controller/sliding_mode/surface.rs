//! The surface against its polynomial.

use brunovsky::{
    Error, Scalar,
    controller::{Gains, sliding_mode::SlidingSurface},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{num, real},
};

/// (p + λ)^(N−1) by the general construction from poles, of which each is a root of its own.
fn equal_poles_are_the_product_of_their_factors<T: Scalar>() {
    fn check<T: Scalar, const N: usize, const M: usize>() {
        let lambda = num::<T>(1.75);
        let poles = Gains::<T, M>::from_poles([-lambda; M]).unwrap();
        let (a, b) = (SlidingSurface::<T, N>::from_lambda(lambda), SlidingSurface::new(poles));
        let difference = real((a.unwrap().as_vector() - b.as_vector()).amax());
        let largest = real(b.as_vector().amax());
        assert!(difference <= 4.0 * N as f64 * real(T::default_epsilon()) * largest);
    }
    check::<T, 2, 1>();
    check::<T, 3, 2>();
    check::<T, 4, 3>();
    check::<T, 5, 4>();
    let alone = SlidingSurface::<T, 1>::from_lambda(num(7.0)).unwrap();
    assert_eq!(alone.as_vector(), &SVector::from([T::one()]));
}

at_f32_and_f64! {
    all_poles_at_minus_lambda => equal_poles_are_the_product_of_their_factors,
}

proptest! {
    /// On e₁ = e^(pt) with p a pole of the surface, σ = 0.
    #[test]
    fn a_mode_of_the_surface_lies_on_it(poles in prop::array::uniform3(-4.0..-0.1_f64)) {
        let surface = SlidingSurface::<f64, 4>::new(Gains::from_poles(poles).unwrap());
        for pole in poles {
            let e = SVector::<f64, 4>::from_fn(|i, _| pole.powi(i as i32));
            // Four terms of at most 3·4³, each off by a few roundings.
            prop_assert!(surface.value(&e).abs() <= 1e-12);
        }
    }

    /// σ̇ = ė_n + the feedback: σ is linear, so its difference along ė is its rate.
    #[test]
    fn the_feedback_is_the_known_rate_of_sigma(
        e in prop::array::uniform3(-3.0..3.0_f64), e_n_dot in -3.0..3.0_f64, lambda in 0.1..5.0_f64,
    ) {
        let surface = SlidingSurface::<f64, 3>::from_lambda(lambda).unwrap();
        let (e, rate) = (SVector::from(e), SVector::from([e[1], e[2], e_n_dot]));
        let expected = surface.value(&rate);
        prop_assert!((e_n_dot + surface.feedback(&e) - expected).abs() <= 1e-12);
    }
}

#[test]
fn a_lambda_without_a_surface_is_named() {
    for value in [0.0, -0.0, -1.0] {
        let refused = SlidingSurface::<f64, 2>::from_lambda(value).unwrap_err();
        assert_eq!(refused, Error::NotPositive { name: "lambda", value });
    }
    let refused = SlidingSurface::<f64, 2>::from_lambda(f64::NAN).unwrap_err();
    assert!(matches!(refused, Error::NonFinite { name: "lambda", .. }));
    let refused = SlidingSurface::<f64, 3>::from_lambda(1e200).unwrap_err();
    assert!(matches!(refused, Error::NonFiniteEntry { name: "surface", index: 0, .. }));
    let refused = SlidingSurface::<f64, 3>::from_lambda(1e-200).unwrap_err();
    assert!(matches!(refused, Error::NotPositive { name: "c1", .. }));
}
