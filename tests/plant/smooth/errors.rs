//! What can be wrong with a plant or a state, each its own error with its numbers.

use core::marker::PhantomData;

use brunovsky::{
    Error,
    differentiation::Smooth,
    plant::{Decouplable, Linearized, SmoothPlant},
};
use nalgebra::SVector;

use crate::smooth_plants::{Cart, FlexibleJoint};

/// ẋ₁ = √x₂, ẋ₂ = u·ln x₁, y = 1/(x₁ − 2): each of f, g and h ends somewhere.
#[derive(Debug)]
struct Bounded;

impl SmoothPlant<2, 1> for Bounded {
    type Scalar = f64;

    fn drift_field<S: Smooth>(&self, [_, b]: [S; 2]) -> [S; 2] {
        [b.sqrt(), S::zero()]
    }

    fn input_fields<S: Smooth>(&self, [a, _]: [S; 2]) -> [[S; 2]; 1] {
        [[S::zero(), a.ln()]]
    }

    fn outputs<S: Smooth>(&self, [a, _]: [S; 2]) -> [S; 1] {
        [(a - 2.0).recip()]
    }
}

#[test]
fn functions_that_are_not_finite_are_named() {
    let plant = Bounded.linearized::<2>([1.5, 1.0]).unwrap();
    let named = |x: [f64; 2], expected: &str, place: usize| {
        let errors = [
            plant.linearization(&x.into()).unwrap_err(),
            Bounded.relative_degree(x).unwrap_err(),
            Bounded.jacobians(x, [0.0]).unwrap_err(),
            Bounded.relative_degree_over([SVector::from(x)]).unwrap_err(),
        ];
        for error in errors {
            assert!(
                matches!(error, Error::NonFiniteEntry { name, index, .. } if name == expected && index == place),
                "{error}"
            );
        }
    };
    named([1.5, -1.0], "f(x)", 0);
    named([-1.5, 1.0], "g(x)", 1);
    named([2.0, 1.0], "h(x)", 0);
    named([1.5, f64::NAN], "x", 1);
    // f is finite where x₂ = 0, its derivative is not.
    let error = plant.linearization(&[1.5, 0.0].into()).unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "a(x)", index: 0, .. }), "{error}");
    let error = Bounded.relative_degree([1.5, 0.0]).unwrap_err();
    assert!(matches!(error, Error::NonFinite { .. }), "{error}");
    let error = Bounded.jacobians([1.5, 1.0], [f64::INFINITY]).unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "u", index: 0, .. }), "{error}");
}

#[test]
fn an_input_gain_below_the_limit_is_refused_with_both() {
    // b = 1/(2·√x₂)·ln x₁·(−1/(x₁ − 2)²) is zero at x₁ = 1.
    let plant = Bounded.linearized::<2>([1.5, 1.0]).unwrap();
    let gain = plant.decoupling_matrix(&[1.5, 1.0].into())[(0, 0)].abs();
    let error = plant.linearization(&[1.0, 1.0].into()).unwrap_err();
    let expected = gain * f64::EPSILON.sqrt();
    assert_eq!(error, Error::TooSmall { name: "B(x)", index: 0, value: 0.0, limit: expected });
    let near = SVector::from([1.0 + 1e-4, 1.0]);
    assert!(plant.linearization(&near).is_ok());
    let strict = plant.with_min_gains([1e-3]).unwrap();
    let error = strict.linearization(&near).unwrap_err();
    assert!(matches!(error, Error::TooSmall { limit: 1e-3, .. }), "{error}");
    let loose = strict.with_min_gains([0.0]).unwrap();
    assert!(loose.linearization(&[1.0, 1.0].into()).is_ok());
    assert!(matches!(loose.with_min_gains([-1.0]).unwrap_err(), Error::Negative { .. }));
}

#[test]
fn a_wrong_relative_degree_is_refused_with_both() {
    let joint = FlexibleJoint { link: 1.0, motor: 0.2, weight: 9.0, stiffness: 80.0 };
    let refused = |error: Error, expected: usize| {
        assert_eq!(error, Error::RelativeDegree { output: 0, expected, found: 4 });
    };
    refused(joint.linearized::<3>([0.1; 4]).unwrap_err(), 3);
    refused(joint.linearized::<5>([0.1; 4]).unwrap_err(), 5);
    refused(Linearized::<_, 4, 2, 1>::with_degrees(joint, [4], [0.1; 4]).unwrap_err(), 2);
    let error = Cart(PhantomData).linearized::<2>([0.0, 0.0, 1.0, 1e-12]).unwrap_err();
    assert!(
        matches!(error, Error::IllConditioned { condition, .. } if condition > 1e11),
        "{error}"
    );
}
