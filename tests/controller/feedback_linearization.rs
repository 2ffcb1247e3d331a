//! Feedback linearization against the closed form of the linear error dynamics.

use brunovsky::{
    Error, Scalar,
    controller::{Controller, FeedbackLinearization, Gains, Measurement, Reference},
    plant::{FeedbackLinearizable, IntegratorChain, Pendulum, ThirdOrder, Uncertain, VanDerPol},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{error_dynamics, flc, num, real, run},
};

fn pendulum() -> Pendulum<f64> {
    Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap()
}

/// The hold of the input delays the feedback by half a period on average: the distance from continuous time halves with dt.
fn assert_first_order(error: impl Fn(f64) -> f64) {
    let measured = (error(0.001) / error(0.0005)).log2();
    assert!((measured - 1.0).abs() < 0.1, "order {measured}");
}

#[test]
fn the_third_order_system_follows_the_closed_form_of_three_equal_poles() {
    let plant = ThirdOrder::<f64>::new();
    // (s + 3)³ from (1, −1, −10): x₁ = (1 + 2t − 3.5t²)·e^(−3t).
    assert_first_order(|dt| {
        let samples =
            run(&plant, flc(plant, 3.0), |_| Reference::setpoint(0.0), [1.0, -1.0, -10.0], dt, 5.0);
        let errors = samples.iter().map(|sample| {
            let t = sample.t;
            (sample.x[0] - (1.0 + 2.0 * t - 3.5 * t * t) * (-3.0 * t).exp()).abs()
        });
        errors.fold(0.0, f64::max)
    });
}

/// r = sin t + (1, 2, …)-fold error at the start, with exact derivatives: e obeys the error dynamics whatever the plant.
fn follows_the_error_dynamics<P: FeedbackLinearizable<N, Scalar = f64>, const N: usize>(plant: &P) {
    let controller = flc(plant, 2.0);
    let derivative = |t: f64, order: usize| (t + order as f64 * core::f64::consts::FRAC_PI_2).sin();
    let reference =
        |t| Reference::new(SVector::<f64, N>::from_fn(|i, _| derivative(t, i)), derivative(t, N));
    let e0 = SVector::<f64, N>::from_fn(|i, _| 0.5 - 0.3 * i as f64);
    assert_first_order(|dt| {
        let samples = run(plant, controller, reference, reference(0.0).r - e0, dt, 3.0);
        let errors = samples.iter().step_by(100).map(|sample| {
            let e = sample.reference.r - sample.x;
            (e - error_dynamics(controller.gains().as_vector(), &e0, sample.t)).norm()
        });
        errors.fold(0.0, f64::max)
    });
}

#[test]
fn chains_of_one_to_four_follow_the_matrix_exponential_behind_a_moving_reference() {
    follows_the_error_dynamics(&IntegratorChain::<f64, 1>::new());
    follows_the_error_dynamics(&IntegratorChain::<f64, 2>::new());
    follows_the_error_dynamics(&IntegratorChain::<f64, 3>::new());
    follows_the_error_dynamics(&IntegratorChain::<f64, 4>::new());
}

#[test]
fn nonlinear_plants_follow_the_same_error_dynamics() {
    follows_the_error_dynamics(&VanDerPol::new(1.5).unwrap());
    follows_the_error_dynamics(&pendulum());
    follows_the_error_dynamics(&ThirdOrder::new());
}

/// At rest the loop reads k₁·e₁ = −Δ (eq_ndi_error): with e = r − x, a push forward leaves the plant ahead of the reference. The
/// hold does not move an equilibrium.
fn rests_beside_the_setpoint<P: FeedbackLinearizable<N, Scalar = f64>, const N: usize>(
    plant: &P,
    delta: f64,
) {
    let disturbed = Uncertain::matched(plant, |_: f64, _: &_, _: &_| delta);
    let samples = run(
        &disturbed,
        flc(plant, 2.0),
        |_| Reference::setpoint(0.4),
        SVector::zeros(),
        0.01,
        40.0,
    );
    let e = samples.last().unwrap().reference.r - samples.last().unwrap().x;
    let expected =
        SVector::<f64, N>::from_fn(
            |i, _| if i == 0 { -delta / 2.0_f64.powi(N as i32) } else { 0.0 },
        );
    // e^(−2·40) has died out; what is left is rounding, which the loop divides by k₁ ≥ 2.
    approx::assert_abs_diff_eq!(e, expected, epsilon = 1e-12);
}

#[test]
fn a_constant_uncertainty_leaves_minus_delta_over_the_first_gain() {
    for delta in [0.7, -0.2] {
        rests_beside_the_setpoint(&IntegratorChain::<f64, 1>::new(), delta);
        rests_beside_the_setpoint(&IntegratorChain::<f64, 2>::new(), delta);
        rests_beside_the_setpoint(&IntegratorChain::<f64, 3>::new(), delta);
        rests_beside_the_setpoint(&IntegratorChain::<f64, 4>::new(), delta);
        rests_beside_the_setpoint(&VanDerPol::new(1.5).unwrap(), delta);
        rests_beside_the_setpoint(&pendulum(), delta);
    }
}

/// u = b⁻¹·(−a + u_f + u_b) on a plant with a gain that depends on the state.
struct Bilinear;

impl FeedbackLinearizable<2> for Bilinear {
    type Scalar = f64;

    fn drift(&self, x: &SVector<f64, 2>) -> f64 {
        x[0].exp()
    }

    fn input_gain(&self, x: &SVector<f64, 2>) -> f64 {
        x[1]
    }
}

fn bilinear() -> FeedbackLinearization<Bilinear, 2> {
    FeedbackLinearization::new(Bilinear, Gains::new([2.0, 3.0]).unwrap())
}

proptest! {
    #[test]
    fn the_input_gives_the_model_the_acceleration_asked_for(
        x0 in -3.0..3.0_f64, x1 in prop_oneof![-3.0..-0.1_f64, 0.1..3.0_f64],
        r in prop::array::uniform2(-3.0..3.0_f64), r_n_dot in -3.0..3.0_f64, dt in 1e-6..1e6_f64,
    ) {
        let x = [x0, x1];
        let command = bilinear().update(&Measurement::new(x), &Reference::new(r, r_n_dot), dt).unwrap();
        let nu = r_n_dot + 2.0 * (r[0] - x0) + 3.0 * (r[1] - x1);
        let x_n_dot = x0.exp() + x1 * command.u;
        prop_assert_eq!(command.u_f, r_n_dot);
        // A dozen roundings of terms that add up to less than 70.
        prop_assert!((command.u_f + command.u_b - nu).abs() <= 12.0 * f64::EPSILON * 70.0);
        prop_assert!((x_n_dot - nu).abs() <= 12.0 * f64::EPSILON * 70.0);
    }
}

fn works_in_any_precision<T: Scalar>() {
    let command = flc(ThirdOrder::<T>::new(), 3.0)
        .update(
            &Measurement::new([1.0, -1.0, -10.0].map(num)),
            &Reference::setpoint(T::zero()),
            num(0.01),
        )
        .unwrap();
    // u_b = −(27 − 27 − 90) = 90 and a = −2 + 1 + sin 10 + e.
    let a = -1.0 + 10.0_f64.sin() + 1.0_f64.exp();
    assert_eq!((command.u_f, command.u_b), (T::zero(), num(90.0)));
    let tolerance = 90.0 * 4.0 * real(T::default_epsilon());
    approx::assert_abs_diff_eq!(real(command.u), 90.0 - a, epsilon = tolerance);
}

at_f32_and_f64! {
    the_shares_are_those_of_the_law => works_in_any_precision,
}

#[test]
fn a_bad_call_names_what_was_bad() {
    let (good, setpoint) = (Measurement::new([0.0, 1.0]), Reference::setpoint(0.0));
    let refused = |measurement: Measurement<f64, 2, 1>, reference, dt| {
        bilinear().update(&measurement, &reference, dt).unwrap_err()
    };
    for value in [0.0, -0.0, -0.01] {
        assert_eq!(refused(good, setpoint, value), Error::NotPositive { name: "dt", value });
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(refused(good, setpoint, bad), Error::NonFinite { name: "dt", .. }));
        let measurements =
            [("x", Measurement::new([0.0, bad])), ("x_dot", good.with_rate([0.0, bad]))];
        for (wrong, measurement) in measurements {
            let error = refused(measurement, setpoint, 0.1);
            assert!(matches!(error, Error::NonFiniteEntry { name, index: 1, .. } if name == wrong));
        }
        let error = refused(good.with_applied([bad]), setpoint, 0.1);
        assert!(matches!(error, Error::NonFiniteEntry { name: "applied", index: 0, .. }));
        let error = refused(good, Reference::new([0.0, bad], 0.0), 0.1);
        assert!(matches!(error, Error::NonFiniteEntry { name: "r", index: 1, .. }));
        let error = refused(good, Reference::new([0.0, 0.0], bad), 0.1);
        assert!(matches!(error, Error::NonFinite { name: "r_n_dot", .. }));
    }
}

#[test]
fn where_the_law_has_no_answer_it_says_why() {
    let at =
        |x: [f64; 2], r: f64| bilinear().update(&Measurement::new(x), &Reference::setpoint(r), 0.1);
    // b = 0; also where −a + ν = −1 + 2·½ + 3·0 = 0 makes the quotient 0/0.
    for (x, r) in [([0.0, 0.0], 1.0), ([0.0, 0.0], 0.5), ([0.0, -0.0], 1.0)] {
        assert_eq!(at(x, r).unwrap_err(), Error::Singular { name: "b(x)", value: x[1] });
    }
    // b so small that the quotient overflows; one that is merely small is a large input.
    let tiny = 1e-309;
    assert_eq!(at([0.0, tiny], 1.0).unwrap_err(), Error::Singular { name: "b(x)", value: tiny });
    assert!(at([0.0, 1e-300], 1.0).unwrap().u.abs() > 1e299);
    assert!(matches!(at([1000.0, 1.0], 0.0), Err(Error::NonFinite { name: "a(x)", .. })));
    // u_b = 2·(r − x₁) overflows, and with r = x₁ − … just below it the sum with a does.
    assert!(matches!(at([0.0, 1.0], 1e308), Err(Error::NonFinite { name: "u_b", .. })));
    let sum =
        bilinear().update(&Measurement::new([0.0, 1.0]), &Reference::new([8e307, 1.0], 1e308), 0.1);
    assert!(matches!(sum, Err(Error::NonFinite { name: "-a(x) + nu", .. })));
}

#[test]
fn it_has_no_memory() {
    let (mut used, fresh) =
        (flc(ThirdOrder::<f64>::new(), 3.0), flc(ThirdOrder::<f64>::new(), 3.0));
    let (x, r) = (Measurement::new([1.0, 2.0, 3.0]), Reference::setpoint(1.0));
    let first = used.update(&x, &r, 0.1);
    used.update(&Measurement::new([f64::NAN; 3]), &r, 0.1).unwrap_err();
    assert_eq!(used, fresh);
    assert_eq!(used.update(&x, &r, 7.0), first, "dt does not enter the law");
    used.reset();
    assert_eq!(used, fresh);
}
