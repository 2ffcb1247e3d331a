//! Lie derivatives against a hand-derived law, and against definitions that know no Taylor series: slopes along fields, nested, by our own duals and
//! by num_dual's.

use brunovsky::{
    Scalar,
    differentiation::{Dual, Smooth},
    plant::{Along, Flow, LieDerivatives, SmoothPlant},
};
use nalgebra::SVector;
use num_dual::Dual64;
use proptest::prelude::*;

use super::strange::Tangle;
use crate::{
    at_f32_and_f64,
    smooth_plants::FlexibleJoint,
    support::{assert_equal_to_rounding, num},
};

/// All at `x`, with the slopes along the input fields.
pub fn lie<P, const NX: usize, const N: usize, const M: usize>(
    plant: &P,
    x: [P::Scalar; NX],
) -> LieDerivatives<P::Scalar, N, M, M>
where
    P: SmoothPlant<NX, M>,
    Along: Flow<N>,
{
    let fields = plant.input_fields(x);
    let start = core::array::from_fn(|i| Dual {
        value: x[i],
        slopes: core::array::from_fn(|j| fields[j][i]),
    });
    Along::lie(plant, &start)
}

/// The law of Spong and Vidyasagar's flexible joint, by hand.
fn the_law_of_the_flexible_joint_is_the_textbooks<T: Scalar>() {
    let [link, motor, weight, stiffness] = [1.5, 0.25, 8.0, 50.0];
    let plant = FlexibleJoint {
        link: num::<T>(link),
        motor: num(motor),
        weight: num(weight),
        stiffness: num(stiffness),
    };
    for x in [[0.5, -1.0, 0.75, 2.0], [3.0, 0.25, 2.5, -1.5], [-1.25, 0.0, -1.0, 0.5]] {
        let [q, q_dot, theta, theta_dot] = x;
        let (sin, cos) = f64::sin_cos(q);
        let (g, k, j) = (weight / link, stiffness / link, stiffness / motor);
        let second = -g * sin - k * (q - theta);
        let third = -g * cos * q_dot - k * (q_dot - theta_dot);
        let fourth = g * sin * (q_dot * q_dot + g * cos + k) + k * (q - theta) * (k + j + g * cos);
        let found = lie::<_, 4, 4, 1>(&plant, x.map(num::<T>));
        let chain = SVector::from([q, q_dot, second, third].map(num::<T>));
        assert_equal_to_rounding(&found.chains[0].into(), &chain, 16.0);
        let law = SVector::from([fourth, k / motor].map(num::<T>));
        assert_equal_to_rounding(
            &SVector::from([found.drift[0], found.slopes[0][0][3]]),
            &law,
            16.0,
        );
        let [below @ .., _] = found.slopes[0][0];
        assert_eq!(below, [T::zero(); 3]);
    }
}

/// L_f^order h, by its definition: the slope of L_f^{order − 1} h along f, from numbers inside numbers.
macro_rules! nested {
    ($name:ident, $lower:ident) => {
        fn $name<P, S, const M: usize>(plant: &P, x: [S; 4]) -> [S; M]
        where
            P: SmoothPlant<4, M>,
            S: Smooth<P::Scalar>,
        {
            let f = plant.drift_field(x);
            let moving = core::array::from_fn(|i| Dual { value: x[i], slopes: [f[i]] });
            $lower::<P, Dual<S, 1>, M>(plant, moving).map(|h| h.slopes[0])
        }
    };
}

fn zeroth<P: SmoothPlant<4, M>, S: Smooth<P::Scalar>, const M: usize>(
    plant: &P,
    x: [S; 4],
) -> [S; M] {
    plant.outputs(x)
}
nested!(first, zeroth);
nested!(second, first);
nested!(third, second);
nested!(fourth, third);

fn state() -> impl Strategy<Value = [f64; 4]> {
    prop::array::uniform4(-1.5..1.5_f64)
}

fn close(found: f64, expected: f64) -> bool {
    // Fourth derivatives of some thousands, of hundreds of roundings.
    (found - expected).abs() <= 1e-12 * expected.abs().max(1e3)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn lie_derivatives_are_slopes_of_slopes(x in state()) {
        let plant = Tangle::<f64>::new();
        let found = lie::<_, 4, 4, 2>(&plant, x);
        let expected = [zeroth(&plant, x), first(&plant, x), second(&plant, x), third(&plant, x)];
        let drift = fourth(&plant, x);
        for i in 0..2 {
            for (k, (found, expected)) in found.chains[i].iter().zip(expected).enumerate() {
                prop_assert!(close(*found, expected[i]), "{k}");
            }
            prop_assert!(close(found.drift[i], drift[i]));
        }
    }

    /// With x moving along a field as num_dual's numbers, each entry has the slope that the law states.
    #[test]
    fn chains_move_along_the_fields_as_the_law_says(x in state(), u in prop::array::uniform2(-2.0..2.0_f64)) {
        let plant = Tangle::<f64>::new();
        let found = lie::<_, 4, 3, 2>(&plant, x);
        let (f, g) = (plant.drift_field(x), plant.input_fields(x));
        let moving = core::array::from_fn(|i| Dual64::new(x[i], f[i] + g[0][i] * u[0] + g[1][i] * u[1]));
        let along = lie::<_, 4, 3, 2>(&Tangle::<Dual64>::new(), moving);
        for i in 0..2 {
            for k in 0..3 {
                let next = found.chains[i].get(k + 1).copied().unwrap_or(found.drift[i]);
                let slopes = found.slopes[i];
                prop_assert!(close(along.chains[i][k].re, found.chains[i][k]));
                prop_assert!(close(along.chains[i][k].eps, next + slopes[0][k] * u[0] + slopes[1][k] * u[1]));
            }
        }
    }

    /// What is computed for one order is computed for all above it.
    #[test]
    fn higher_orders_contain_the_lower_ones(x in state()) {
        let plant = Tangle::<f64>::new();
        let (high, low) = (lie::<_, 4, 8, 2>(&plant, x), lie::<_, 4, 1, 2>(&plant, x));
        let (six, five) = (lie::<_, 4, 6, 2>(&plant, x), lie::<_, 4, 5, 2>(&plant, x));
        for i in 0..2 {
            prop_assert!(close(low.drift[i], high.chains[i][1]));
            prop_assert!(close(five.drift[i], six.chains[i][5]));
            // Sixth derivatives may be large; they are compared relative to their size alone.
            prop_assert!((six.drift[i] - high.chains[i][6]).abs() <= 1e-9 * six.drift[i].abs().max(1e6));
            for k in 0..5 {
                prop_assert!(close(five.chains[i][k], high.chains[i][k]));
                for j in 0..2 {
                    prop_assert!(close(five.slopes[i][j][k], six.slopes[i][j][k]));
                }
            }
        }
    }
}

at_f32_and_f64! {
    the_law_of_the_flexible_joint_is_the_one_derived_by_hand => the_law_of_the_flexible_joint_is_the_textbooks,
}
