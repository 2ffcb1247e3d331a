//! A plant on one rung has the rungs below it, and users can implement any of them.

use brunovsky::{
    Scalar,
    plant::{ControlAffine, FeedbackLinearizable, IntegratorChain, Plant, ThirdOrder},
};
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, flow, num},
};

/// The top rung, generic over the scalar: a(x) = x₁·x₃ − x₂, b(x) = 2 + x₂.
struct Jerk<T>(T);

impl<T: Scalar> FeedbackLinearizable<3> for Jerk<T> {
    type Scalar = T;

    fn drift(&self, x: &SVector<T, 3>) -> T {
        x[0] * x[2] - x[1]
    }

    fn input_gain(&self, x: &SVector<T, 3>) -> T {
        self.0 + x[1]
    }
}

/// The middle rung with two inputs, speed v and turn rate ω: ẋ = v·cos θ, ẏ = v·sin θ, θ̇ = ω.
struct Unicycle;

impl ControlAffine<3, 2> for Unicycle {
    type Scalar = f64;

    fn drift_field(&self, _x: &SVector<f64, 3>) -> SVector<f64, 3> {
        SVector::zeros()
    }

    fn input_fields(&self, x: &SVector<f64, 3>) -> SMatrix<f64, 3, 2> {
        let (sin, cos) = x[2].sin_cos();
        SMatrix::<f64, 3, 2>::new(cos, 0.0, sin, 0.0, 0.0, 1.0)
    }
}

/// The bottom rung with two inputs, neither of them linear: ẋ₁ = u₁² + t, ẋ₂ = x₁·sin u₂.
struct General<T>(core::marker::PhantomData<T>);

impl<T: Scalar> Plant<2, 2> for General<T> {
    type Scalar = T;

    fn derivative(&self, t: T, x: &SVector<T, 2>, u: &SVector<T, 2>) -> SVector<T, 2> {
        SVector::from([u[0] * u[0] + t, x[0] * u[1].sin()])
    }
}

/// Asks for the bottom rung, whatever the plant was written on.
fn rate<P: Plant<NX, NU>, const NX: usize, const NU: usize>(
    plant: P,
    t: P::Scalar,
    x: &SVector<P::Scalar, NX>,
    u: &SVector<P::Scalar, NU>,
) -> SVector<P::Scalar, NX> {
    plant.derivative(t, x, u)
}

fn has_the_chain_form<T: Scalar>(entries: [f64; 3], u: f64, t: f64) {
    let plant = Jerk(num::<T>(2.0));
    let x = SVector::from(entries.map(num));
    let (a, b) = (plant.drift(&x), plant.input_gain(&x));
    let u = num::<T>(u);
    assert_eq!(plant.drift_field(&x), SVector::from([x[1], x[2], a]));
    assert_eq!(plant.input_fields(&x), SVector::from([T::zero(), T::zero(), b]));
    // One product and one sum, in the order of the law, so equal to the last bit; 0 is only added to x₂ and x₃.
    let expected = SVector::from([x[1], x[2], a + b * u]);
    let u = SVector::from([u]);
    assert_eq!(plant.derivative(num(t), &x, &u), expected);
    assert_eq!(rate(&plant, num(t), &x, &u), expected);
    assert_eq!(rate(&&plant, num(t), &x, &u), expected);
    let object: &dyn FeedbackLinearizable<3, Scalar = T> = &plant;
    assert_eq!(rate(object, num(t), &x, &u), expected);
}

proptest! {
    #[test]
    fn the_top_rung_gives_the_chain_form_by_value_by_reference_and_as_an_object(
        x in prop::array::uniform3(-9.0..9.0_f64), u in -9.0..9.0_f64, t in 0.0..9.0_f64,
    ) {
        has_the_chain_form::<f32>(x, u, t);
        has_the_chain_form::<f64>(x, u, t);
    }

    #[test]
    fn a_control_affine_plant_is_affine_in_its_inputs(
        theta in -3.0..3.0_f64, u in prop::array::uniform2(-2.0..2.0_f64), t in 0.0..9.0_f64,
    ) {
        let x = SVector::from([1.0, 2.0, theta]);
        let expected = SVector::from([u[0] * theta.cos(), u[0] * theta.sin(), u[1]]);
        assert_equal_to_rounding(&rate(Unicycle, t, &x, &u.into()), &expected, 4.0);
    }
}

#[test]
fn a_chain_of_one_integrator_is_the_shortest() {
    let plant = IntegratorChain::<f64, 1>::new();
    let x = SVector::from([4.0]);
    assert_eq!(plant.drift_field(&x), SVector::from([0.0]));
    assert_eq!(rate(plant, 0.0, &x, &[3.0].into()), SVector::from([3.0]));
}

#[test]
fn a_unicycle_with_constant_inputs_drives_a_circle_of_radius_v_over_omega() {
    let (v, omega, t) = (1.5, 0.75, 4.0);
    let found = flow(&Unicycle, [0.0, 0.0, 0.0], [v, omega], t, 4000);
    let turned: f64 = omega * t;
    let radius = v / omega;
    let expected = [radius * turned.sin(), radius * (1.0 - turned.cos()), turned];
    // Rk4 at h = 0.001: h⁴ = 1e-12, and 4000 additions of rounding 2e-16.
    approx::assert_abs_diff_eq!(found, SVector::from(expected), epsilon = 2e-12);
}

/// For constant u: x₁ = p + q·t + t²/2 with q = u₁², and x₂ its integral times sin u₂, a polynomial of degree 3 that Rk4 meets
/// in one step.
fn depends_on_time_state_and_both_inputs<T: Scalar>() {
    let (p, u, t) = (0.5, [1.5, -0.7], 1.25);
    let q: f64 = u[0] * u[0];
    let found = flow(
        &General(core::marker::PhantomData),
        [num::<T>(p), num(2.0)],
        u.map(num::<T>),
        num(t),
        1,
    );
    let integral = p * t + q * t.powi(2) / 2.0 + t.powi(3) / 6.0;
    let expected = [p + q * t + t * t / 2.0, 2.0 + integral * f64::sin(u[1])];
    assert_equal_to_rounding(&found, &SVector::from(expected.map(num)), 16.0);
}

at_f32_and_f64! {
    a_general_plant_sees_time_state_and_both_inputs => depends_on_time_state_and_both_inputs,
}

#[test]
fn plants_above_the_bottom_rung_do_not_depend_on_time() {
    let (x, u) = (SVector::from([1.0, -1.0, -10.0]), SVector::from([0.3]));
    let plant = ThirdOrder::<f64>::new();
    assert_eq!(rate(plant, 0.0, &x, &u), rate(plant, 1e6, &x, &u));
    let (x, u) = (SVector::from([1.0, -1.0, 0.4]), SVector::from([0.3, 0.1]));
    assert_eq!(rate(Unicycle, 0.0, &x, &u), rate(Unicycle, 1e6, &x, &u));
}
