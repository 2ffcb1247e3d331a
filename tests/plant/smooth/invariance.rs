//! What Lie derivatives must not depend on, and the rule for products.

use brunovsky::{differentiation::Dual, plant::SmoothPlant};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{
    lie_derivatives::lie,
    strange::{Product, Tangle, Transformed},
};

fn state() -> impl Strategy<Value = [f64; 4]> {
    prop::array::uniform4(-1.2..1.2_f64)
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-11 * expected.abs().max(1e3)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn other_coordinates_leave_lie_derivatives_as_they_are(x in state()) {
        let plant = Tangle::<f64>::new();
        let xi = Transformed::<Tangle<f64>>::forth::<f64, f64>(x);
        let (found, expected) = (lie::<_, 4, 4, 2>(&Transformed(plant), xi), lie::<_, 4, 4, 2>(&plant, x));
        for i in 0..2 {
            prop_assert!(close(found.drift[i], expected.drift[i]));
            for k in 0..4 {
                prop_assert!(close(found.chains[i][k], expected.chains[i][k]));
                for j in 0..2 {
                    prop_assert!(close(found.slopes[i][j][k], expected.slopes[i][j][k]));
                }
            }
        }
    }

    /// L_f^k (h₁·h₂) = Σ C(k, j)·L_f^j h₁·L_f^{k−j} h₂.
    #[test]
    fn products_of_outputs_follow_leibniz(x in state()) {
        let plant = Tangle::<f64>::new();
        let (of_product, of_each) = (lie::<_, 4, 4, 2>(&Product(plant), x), lie::<_, 4, 4, 2>(&plant, x));
        let [first, second] = of_each.chains;
        let binomials = [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0], [1.0, 2.0, 1.0, 0.0], [1.0, 3.0, 3.0, 1.0]];
        for (k, binomials) in binomials.iter().enumerate() {
            let expected: f64 = (0..=k).map(|j| binomials[j] * first[j] * second[k - j]).sum();
            prop_assert!(close(of_product.chains[0][k], expected));
        }
    }

    /// [f, g]h = L_f L_g h − L_g L_f h, and the bracket is itself a field: the Jacobian's ∂g·f − ∂f·g gives the same.
    #[test]
    fn the_commutator_of_lie_derivatives_is_the_bracket(x in state()) {
        let plant = Tangle::<f64>::new();
        let jacobians = plant.jacobians(x, [0.0, 0.0]).unwrap();
        // ∂gⱼ/∂x from the Jacobian with uⱼ = 1 less the one without input.
        let f = SVector::from(plant.drift_field(x));
        let g = plant.input_fields(x).map(SVector::from);
        let found = lie::<_, 4, 2, 2>(&plant, x);
        for (j, field) in g.iter().enumerate() {
            let u = [f64::from(u8::from(j == 0)), f64::from(u8::from(j == 1))];
            let of_field = plant.jacobians(x, u).unwrap().a - jacobians.a;
            let bracket = of_field * f - jacobians.a * field;
            let along_bracket = jacobians.c * bracket;
            // L_f L_g h: the slope along f of the slope along g, by nested numbers.
            let moving: [Dual<f64, 1>; 4] = core::array::from_fn(|i| Dual { value: x[i], slopes: [f[i]] });
            let field = plant.input_fields(moving)[j];
            let along_both = core::array::from_fn(|i| Dual { value: moving[i], slopes: [field[i]] });
            let outputs = plant.outputs(along_both);
            for i in 0..2 {
                let forth = outputs[i].slopes[0].slopes[0];
                let back = found.slopes[i][j][1];
                prop_assert!(close(forth - back, along_bracket[i]), "{} {}", forth - back, along_bracket[i]);
            }
        }
    }
}

/// The helper of coordinates is its own inverse.
#[test]
fn the_change_of_coordinates_can_be_undone() {
    let x = [0.3, -0.7, 1.1, 0.4];
    let back = Transformed::<Tangle<f64>>::back::<f64, f64>(Transformed::<Tangle<f64>>::forth::<
        f64,
        f64,
    >(x));
    for (found, expected) in back.iter().zip(x) {
        assert!((found - expected).abs() < 1e-15);
    }
}
