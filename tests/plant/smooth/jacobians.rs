//! Jacobians against finite differences, and against the plants that are linear already.

use brunovsky::plant::{Plant, SmoothPlant};
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;

use super::strange::Tangle;
use crate::smooth_plants::FlexibleJoint;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// The central difference with step d is d²/6 of a third derivative off, and ε/d of the value.
    #[test]
    fn jacobians_are_the_limits_of_differences(x in prop::array::uniform4(-1.5..1.5_f64), u in prop::array::uniform2(-2.0..2.0_f64)) {
        let plant = Tangle::<f64>::new();
        let found = plant.jacobians(x, u).unwrap();
        let rate = |x: SVector<f64, 4>| {
            let f = SVector::from(plant.drift_field::<f64>(x.into()));
            f + SMatrix::<f64, 4, 2>::from(plant.input_fields::<f64>(x.into())) * SVector::from(u)
        };
        let output = |x: SVector<f64, 4>| SVector::from(plant.outputs::<f64>(x.into()));
        let d = 1e-5;
        for j in 0..4 {
            let (mut up, mut down) = (SVector::from(x), SVector::from(x));
            up[j] += d;
            down[j] -= d;
            prop_assert!(((rate(up) - rate(down)) / (2.0 * d) - found.a.column(j)).amax() < 1e-7);
            prop_assert!(((output(up) - output(down)) / (2.0 * d) - found.c.column(j)).amax() < 1e-7);
        }
        prop_assert_eq!(found.b, SMatrix::from(plant.input_fields::<f64>(x)));
    }
}

#[test]
fn the_joint_hanging_down_is_a_chain_of_two_oscillators() {
    let joint = FlexibleJoint { link: 2.0, motor: 0.5, weight: 8.0, stiffness: 32.0 };
    let found = joint.jacobians([0.0; 4], [0.0]).unwrap();
    // All quotients of powers of two.
    let a = SMatrix::<f64, 4, 4>::new(
        0.0, 1.0, 0.0, 0.0, //
        -20.0, 0.0, 16.0, 0.0, //
        0.0, 0.0, 0.0, 1.0, //
        64.0, 0.0, -64.0, 0.0,
    );
    assert_eq!((found.a, found.b), (a, SVector::from([0.0, 0.0, 0.0, 2.0])));
    assert_eq!(found.c, SVector::from([1.0, 0.0, 0.0, 0.0]).transpose());
    // To first order the plant moves as they say.
    let (x, u) = (SVector::from([1e-6, 2e-6, -1e-6, 3e-6]), SVector::from([1e-6]));
    let rate = joint.linearized::<4>([0.0; 4]).unwrap().derivative(0.0, &x, &u);
    assert!((rate - (a * x + found.b * u)).amax() < 1e-16);
}
