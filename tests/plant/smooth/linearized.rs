//! The chain form from equations beside the one that was written by hand.

use core::marker::PhantomData;

use brunovsky::{
    Scalar,
    differentiation::Smooth,
    plant::{
        ControlAffine, Decouplable, FeedbackLinearizable, Linearized, Link, Plant, SmoothPlant,
        ThirdOrder, TwoLinkArm, Unicycle,
    },
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    smooth_plants::{Arm, Cart},
    support::{assert_equal_to_rounding, num},
};

/// The same rates, chains, drift, matrix and chain rates, to `tolerance` relative to the largest entry, or 1.
fn assert_same<P, Q, const NX: usize, const N: usize, const M: usize>(
    found: &P,
    expected: &Q,
    x: [f64; NX],
    tolerance: f64,
) where
    P: Decouplable<NX, N, M, Scalar = f64> + ControlAffine<NX, M, Scalar = f64>,
    Q: Decouplable<NX, N, M, Scalar = f64> + ControlAffine<NX, M, Scalar = f64>,
{
    let x = SVector::from(x);
    let close = |found: &[f64], expected: &[f64]| {
        let scale = expected.iter().fold(1.0, |scale: f64, entry| scale.max(entry.abs()));
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= tolerance * scale, "{found} is not {expected}");
        }
    };
    close(found.drift_field(&x).as_slice(), expected.drift_field(&x).as_slice());
    close(found.input_fields(&x).as_slice(), expected.input_fields(&x).as_slice());
    for (found, expected) in found.chains(&x).iter().zip(expected.chains(&x)) {
        close(found.as_slice(), expected.as_slice());
    }
    close(found.chain_drift(&x).as_slice(), expected.chain_drift(&x).as_slice());
    close(found.decoupling_matrix(&x).as_slice(), expected.decoupling_matrix(&x).as_slice());
    let rate = SVector::from_fn(|i, _| (1.0 + i as f64).sin());
    close(found.chain_rates(&x, &rate).as_slice(), expected.chain_rates(&x, &rate).as_slice());
    // At once as one by one.
    let at = found.linearization(&x).unwrap();
    assert_eq!((at.chains, at.drift), (found.chains(&x), found.chain_drift(&x)));
    assert_eq!((at.matrix, at.inverted), (found.decoupling_matrix(&x), found.inverted_matrix(&x)));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_unicycle_from_its_equations_is_the_one_written_by_hand(
        [x, y, theta] in prop::array::uniform3(-7.0..7.0_f64), v in 0.1..4.0_f64, reverse in prop::bool::ANY,
    ) {
        let v = if reverse { -v } else { v };
        let found = Cart(PhantomData).linearized::<2>([x, y, theta, v]).unwrap();
        assert_same(&found, &Unicycle::new(), [x, y, theta, v], 1e-12);
    }

    #[test]
    fn the_arm_from_its_equations_is_the_one_written_by_hand(
        x in prop::array::uniform4(-4.0..4.0_f64), payload in 0.0..2.0_f64,
        first in (0.5..3.0_f64, 0.3..1.0_f64, 0.1..0.5_f64, 0.02..0.2_f64), second in (0.5..3.0_f64, 0.3..1.0_f64, 0.1..0.5_f64, 0.02..0.2_f64),
    ) {
        let links = [<[f64; 4]>::from(first), second.into()];
        let by_equations = Arm { links, friction: [0.1, 0.3], gravity: 9.81, payload };
        let [first, second] = links.map(|[mass, length, centre, inertia]| Link { mass, length, centre, inertia });
        let by_hand = TwoLinkArm::new([first, second], [0.1, 0.3], 9.81).unwrap().with_payload(payload).unwrap();
        // det M as a difference of products loses up to two digits.
        assert_same(&by_equations.linearized::<2>(x).unwrap(), &by_hand, x, 1e-12);
    }
}

/// A plant in chain form, by its equations.
struct Chain<T>(PhantomData<T>);

impl<T: Scalar> SmoothPlant<3, 1> for Chain<T> {
    type Scalar = T;

    fn drift_field<S: Smooth<T>>(&self, [a, b, c]: [S; 3]) -> [S; 3] {
        [b, c, a * num::<T>(-2.0) - b - c.sin() + a.exp()]
    }

    fn input_fields<S: Smooth<T>>(&self, _: [S; 3]) -> [[S; 3]; 1] {
        [[S::zero(), S::zero(), S::one()]]
    }

    fn outputs<S: Smooth<T>>(&self, [a, ..]: [S; 3]) -> [S; 1] {
        [a]
    }
}

/// Its chain is its state, bit for bit, and it moves as the plant that was given as a chain.
fn a_chain_is_its_own<T: Scalar>() {
    let plant: Linearized<_, 3, 3, 1> =
        Linearized::new(Chain(PhantomData), [T::zero(); 3]).unwrap();
    let given = ThirdOrder::<T>::new();
    for x in [[0.5, -1.0, 0.25], [1.0, 2.0, -3.0]] {
        let x = SVector::from(x.map(num::<T>));
        assert_eq!(plant.chains(&x), [x]);
        assert_eq!(plant.decoupling_matrix(&x)[(0, 0)], T::one());
        let drift = SVector::from([given.drift(&x)]);
        assert_equal_to_rounding(&plant.chain_drift(&x), &drift, 2.0);
        let u = SVector::from([num::<T>(0.5)]);
        let (found, expected) =
            (plant.derivative(T::zero(), &x, &u), given.derivative(T::zero(), &x, &u));
        assert_equal_to_rounding(&found, &expected, 2.0);
    }
}

at_f32_and_f64! {
    a_chain_has_its_own_state_as_chain => a_chain_is_its_own,
}
