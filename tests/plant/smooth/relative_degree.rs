//! The relative degree of plants whose relative degree is known, with rounding in the way.

use core::marker::PhantomData;

use brunovsky::{
    Error, Scalar,
    differentiation::Smooth,
    plant::{BoxSamples, SmoothPlant},
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::strange::Transformed;
use crate::{
    at_f32_and_f64,
    smooth_plants::{Cart, FlexibleJoint},
    support::num,
};

/// ẋᵢ = xᵢ₊₁ + (sin² x₁ + cos² x₁ − 1) for i < 4, ẋ₄ = gain(x)·u: what is in brackets is zero but for rounding.
struct Disguised<T, G>(G, usize, PhantomData<T>);

impl<T: Scalar, G: Fn(T) -> T> SmoothPlant<4, 1> for Disguised<T, G> {
    type Scalar = T;

    fn drift_field<S: Smooth<T>>(&self, [a, b, c, d]: [S; 4]) -> [S; 4] {
        let (sin, cos) = (a + d).sin_cos();
        let nothing = sin * sin + cos * cos - T::one();
        [b + nothing, c + nothing, d + nothing, nothing]
    }

    fn input_fields<S: Smooth<T>>(&self, [a, _, c, d]: [S; 4]) -> [[S; 4]; 1] {
        // (c + 1)² − (c² + 2·c + 1) is zero but for rounding too.
        let root = c + T::one();
        let nothing = root * root - (c * c + c * num::<T>(2.0) + T::one());
        [[nothing, nothing, nothing, S::from((self.0)(a.value())) + d * T::zero()]]
    }

    fn outputs<S: Smooth<T>>(&self, x: [S; 4]) -> [S; 1] {
        [x[self.1]]
    }
}

fn rounding_does_not_pass_for_a_relative_degree<T: Scalar>() {
    let boxed = BoxSamples::new([num::<T>(-3.0); 4], [num(3.0); 4]).unwrap();
    for (output, degree) in [(0, 4), (1, 3), (2, 2), (3, 1)] {
        // A gain of 10⁵·ε is small, and not zero beside roundings of some ε.
        for gain in [T::one(), T::default_epsilon() * num(1e5)] {
            let plant = Disguised(|_| gain, output, PhantomData);
            let found = plant.relative_degree([0.3, 0.7, -0.2, 1.1].map(num::<T>)).unwrap();
            assert_eq!((found.degrees, found.zero_dynamics()), ([degree], 4 - degree));
            assert!((found.smallest_gain - gain).abs() <= gain * num(1e-3));
            let found = plant.relative_degree_over(boxed.take(200)).unwrap();
            assert_eq!((found.degrees, found.states), ([degree], 200));
            assert!(found.is_uniform());
            for k in 0..degree - 1 {
                assert!(found.lie_derivatives[0][0][k].vanishes());
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn other_coordinates_leave_the_relative_degree_as_it_is(x in prop::array::uniform4(-1.5..1.5_f64)) {
        let joint = FlexibleJoint { link: 1.5, motor: 0.3, weight: 8.0, stiffness: 50.0 };
        let xi = Transformed::<()>::forth::<f64, f64>(x);
        let found = Transformed(joint).relative_degree(xi).unwrap();
        prop_assert_eq!(found.degrees, [4]);
        let b = 50.0 / (1.5 * 0.3);
        prop_assert!((found.smallest_gain - b).abs() <= 1e-10 * b);
    }
}

#[test]
fn the_unicycle_has_relative_degree_two_and_two_and_its_gain_is_the_speed() {
    let cart = Cart(PhantomData);
    for v in [0.5, -0.25, 2.0] {
        let found = cart.relative_degree([1.0, 2.0, 0.0, v]).unwrap();
        assert_eq!((found.degrees, found.zero_dynamics(), found.states), ([2, 2], 0, 1));
        // B is diagonal at θ = 0: diag(1, v).
        assert_eq!(found.smallest_gain, f64::min(1.0, v.abs()));
        assert_eq!(found.condition, f64::max(v.abs(), 1.0 / v.abs()));
    }
    // Without speed, the yaw rate does not reach the acceleration.
    let error = cart.relative_degree([1.0, 2.0, 0.5, 0.0]).unwrap_err();
    assert!(matches!(error, Error::IllConditioned { name: "B(x)", .. }), "{error}");
}

#[test]
fn a_trajectory_through_a_singular_state_is_not_uniform() {
    let stops = (0..=10).map(|k| SVector::from([0.0, 0.0, 0.3, 1.0 - 0.1 * f64::from(k)]));
    let found = Cart(PhantomData).relative_degree_over(stops.clone()).unwrap();
    assert_eq!((found.degrees, found.states, found.singular), ([2, 2], 11, 1));
    assert!(!found.is_uniform() && found.smallest_gain < 1e-15 && found.condition > 1e15);
    assert_eq!(found.weakest[3], 0.0);
    let found = Cart(PhantomData).relative_degree_over(stops.take(10)).unwrap();
    assert!(found.is_uniform());
}

/// The heading of a car that does not steer: ẋ = u, y = x².
struct Square;

impl SmoothPlant<1, 1> for Square {
    type Scalar = f64;

    fn drift_field<S: Smooth>(&self, [x]: [S; 1]) -> [S; 1] {
        [-x]
    }

    fn input_fields<S: Smooth>(&self, _: [S; 1]) -> [[S; 1]; 1] {
        [[S::one()]]
    }

    fn outputs<S: Smooth>(&self, [x]: [S; 1]) -> [S; 1] {
        [x * x]
    }
}

#[test]
fn a_lie_derivative_that_vanishes_at_a_state_alone_leaves_no_relative_degree_there() {
    assert_eq!(Square.relative_degree([1e-3]).unwrap().smallest_gain, 2e-3);
    let error = Square.relative_degree([0.0]).unwrap_err();
    assert!(
        matches!(error, Error::UndefinedRelativeDegree { output: 0, order: 0, value: 0.0, .. }),
        "{error}"
    );
    assert!(Square.linearized::<1>([0.0]).is_err());
}

#[test]
fn an_output_out_of_reach_is_an_error() {
    let plant = Disguised(|_| 0.0, 0, PhantomData);
    let error = plant.relative_degree([0.3, 0.7, -0.2, 1.1]).unwrap_err();
    assert!(matches!(error, Error::Unreached { output: 0, derivatives: 4, .. }), "{error}");
    let none = core::iter::empty::<SVector<f64, 4>>();
    assert_eq!(plant.relative_degree_over(none).unwrap_err(), Error::Missing { name: "state" });
}

at_f32_and_f64! {
    what_is_zero_up_to_rounding_counts_as_zero => rounding_does_not_pass_for_a_relative_degree,
}
