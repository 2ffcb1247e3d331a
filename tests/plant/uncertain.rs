//! An uncertainty adds to the derivative and to nothing else.

use brunovsky::{
    Scalar,
    plant::{IntegratorChain, Matched, Plant, ThirdOrder, Uncertain, Uncertainty},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, flow, num},
};

/// A plant on the bottom rung with two inputs.
struct Mixed;

impl Plant<2, 2> for Mixed {
    type Scalar = f64;

    fn derivative(&self, t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1] * u[0], t - u[1]])
    }
}

fn scalar_delta(t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 2>) -> f64 {
    t * x[0] - u[1]
}

fn vector_delta(t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 2>) -> SVector<f64, 2> {
    SVector::from([t + u[0], x[0] * x[1]])
}

proptest! {
    #[test]
    fn a_vector_uncertainty_acts_in_every_state_equation(
        t in 0.0..9.0_f64, x in prop::array::uniform2(-9.0..9.0_f64), u in prop::array::uniform2(-9.0..9.0_f64),
    ) {
        let plant = Uncertain::new(Mixed, vector_delta);
        let expected = SVector::from([
            x[1] * u[0] + (t + u[0]),
            (t - u[1]) + x[0] * x[1],
        ]);
        // The same operations in the same order.
        assert_eq!(plant.derivative(t, &x.into(), &u.into()), expected);
    }

    #[test]
    fn a_matched_uncertainty_acts_in_the_last_state_equation_alone(
        t in 0.0..9.0_f64, x in prop::array::uniform2(-9.0..9.0_f64), u in prop::array::uniform2(-9.0..9.0_f64),
    ) {
        let (x, u) = (x.into(), u.into());
        let nominal = Mixed.derivative(t, &x, &u);
        let delta = scalar_delta(t, &x, &u);
        let expected = SVector::from([nominal[0], nominal[1] + delta]);
        assert_eq!(Uncertain::matched(Mixed, scalar_delta).derivative(t, &x, &u), expected);
        assert_eq!(Uncertain::new(Mixed, Matched(scalar_delta)).derivative(t, &x, &u), expected);
        assert_eq!(Matched(scalar_delta).delta(t, &x, &u), SVector::from([0.0, delta]));
    }

    #[test]
    fn uncertainties_on_top_of_each_other_add_up(
        t in 0.0..9.0_f64, x in prop::array::uniform2(-9.0..9.0_f64), u in prop::array::uniform2(-9.0..9.0_f64),
    ) {
        let both = Uncertain::matched(Uncertain::new(Mixed, vector_delta), scalar_delta);
        let (x, u) = (x.into(), u.into());
        let sum = Mixed.derivative(t, &x, &u) + vector_delta(t, &x, &u) + SVector::from([0.0, scalar_delta(t, &x, &u)]);
        assert_eq!(both.derivative(t, &x, &u), sum);
    }
}

/// On a chain with one input, as the paper has it: the disturbance 5·sin t, a wrong drift and a wrong input gain at once.
fn adds_to_the_last_equation_of_a_chain<T: Scalar>() {
    let plant =
        Uncertain::matched(ThirdOrder::<T>::new(), |t: T, x: &SVector<T, 3>, u: &SVector<T, 1>| {
            num::<T>(5.0) * t.sin() + x[0] * x[2] + u[0]
        });
    let (t, x, u) = (
        num::<T>(2.0),
        SVector::from([1.0, -1.0, -10.0].map(num::<T>)),
        SVector::from([num::<T>(0.5)]),
    );
    let mut expected = ThirdOrder::new().derivative(t, &x, &u);
    expected[2] += num::<T>(5.0) * t.sin() + x[0] * x[2] + u[0];
    assert_eq!(plant.derivative(t, &x, &u), expected);
}

/// ẋ₂ = u + c on two integrators is the chain under the input u + c.
fn a_constant_is_as_good_as_an_input<T: Scalar>() {
    let chain = IntegratorChain::<T, 2>::new();
    let plant = Uncertain::matched(chain, |_t: T, _x: &_, _u: &_| num::<T>(0.75));
    let (x, t) = ([num::<T>(1.0), num(-2.0)], num(1.5));
    let disturbed = flow(&plant, x, [num::<T>(-0.5)], t, 1);
    assert_equal_to_rounding(&disturbed, &flow(&chain, x, [num::<T>(0.25)], t, 1), 16.0);
}

at_f32_and_f64! {
    on_a_chain_it_acts_where_the_input_does => adds_to_the_last_equation_of_a_chain,
    a_constant_uncertainty_is_a_constant_input => a_constant_is_as_good_as_an_input,
}
