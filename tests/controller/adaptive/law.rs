use brunovsky::{
    Scalar,
    channel::Saturation,
    controller::{
        Controller, Limited, Measurement, ModelReferenceAdaptive, Reference, StateRegressor,
    },
    learning::LearningMode,
    plant::{IntegratorChain, Uncertain, VanDerPol},
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{adaptive, constant, watched};
use crate::{
    at_f32_and_f64,
    support::{flc, num, real, run},
};

fn waves(t: f64) -> Reference<f64, 2> {
    let (slow, fast) = (0.7 * t, 2.0 * t);
    Reference::new(
        [slow.sin() + fast.sin(), 0.7 * slow.cos() + 2.0 * fast.cos()],
        -0.49 * slow.sin() - 4.0 * fast.sin(),
    )
}

/// θ of the law is that of ẋ_n = Λ·(u + θᵀx).
const THETA: [f64; 2] = [1.5, -0.8];

fn plant(strength: f64) -> impl brunovsky::plant::Plant<2, 1, Scalar = f64> {
    let [t1, t2] = THETA;
    Uncertain::matched(
        IntegratorChain::<f64, 2>::new(),
        move |_: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>| {
            strength * (u[0] + t1 * x[0] + t2 * x[1]) - u[0]
        },
    )
}

/// V at every tenth of a second of a run of 4 s, from the truth; and V(0) − V(4) − ∫εᵀQε dt, which the law says is 0.
fn energies(strength: f64, dt: f64) -> (Vec<f64>, f64) {
    let mut controller = adaptive(1.5, StateRegressor, 3.0).with_model_at([0.0, 0.0]).unwrap();
    if strength != 1.0 {
        controller = controller.with_unknown_effectiveness(2.0, [0.1, 5.0]).unwrap();
    }
    let (mut energies, mut dissipated) = (vec![], 0.0);
    let every = (0.1 / dt).round() as u64;
    watched(
        &plant(strength),
        controller,
        waves,
        [0.6, -0.4],
        dt,
        (4.0 / dt) as usize + 1,
        |sample, controller| {
            let epsilon = controller.model_state().unwrap() - sample.x;
            let theta = controller.parameters() - SVector::from(THETA);
            let kappa = controller.inverse_effectiveness() - 1.0 / strength;
            let of_state = epsilon.dot(&(controller.lyapunov_matrix() * epsilon));
            if sample.k % every == 0 {
                energies
                    .push(of_state + strength * (theta.norm_squared() / 3.0 + kappa * kappa / 2.0));
            }
            dissipated += epsilon.norm_squared() * dt;
        },
    );
    let left = energies[0] - energies[energies.len() - 1] - dissipated;
    (energies, left)
}

/// Sampling adds what is of the order of h, or smaller, to a balance that is exact in continuous time.
#[test]
fn the_lyapunov_function_falls_by_what_is_dissipated() {
    for strength in [1.0, 0.6] {
        let (fine, left) = energies(strength, 0.001);
        for pair in fine.windows(2) {
            assert!(pair[1] < pair[0] + 1e-3 * fine[0], "{fine:?}");
        }
        let (_, twice) = energies(strength, 0.002);
        assert!(left.abs() < 0.02 * fine[0], "{left} of {}", fine[0]);
        let order = (twice / left).abs().log2();
        // Terms of h² are still there.
        assert!(order > 0.8, "order {order}");
    }
}

/// Two sines excite two parameters, and the gain with them; what is left is the hold's, of the order of h.
#[test]
fn excited_parameters_become_the_true_ones() {
    let apart = |strength: f64, dt: f64| {
        let mut controller = adaptive(1.5, StateRegressor, 5.0);
        if strength != 1.0 {
            controller = controller.with_unknown_effectiveness(2.0, [0.1, 5.0]).unwrap();
        }
        let mut apart = 0.0;
        let count = (200.0 / dt) as usize;
        watched(&plant(strength), controller, waves, [0.0, 0.0], dt, count, |_, controller| {
            let theta = controller.parameters() - SVector::from(THETA);
            let kappa = controller.inverse_effectiveness() - 1.0 / strength;
            apart = theta.norm().max(kappa.abs());
        });
        apart
    };
    for strength in [1.0, 0.6] {
        let (coarse, fine) = (apart(strength, 0.02), apart(strength, 0.01));
        assert!(fine < 0.05, "{fine}");
        assert!(fine < 0.7 * coarse, "{coarse} {fine}");
    }
}

/// A constant under a hold is explained by φ = 1 without a remainder, so nothing but rounding is left, at any N.
fn learns_a_constant<const N: usize>(theta: f64) {
    let plant = Uncertain::matched(IntegratorChain::<f64, N>::new(), |_: f64, _: &_, _: &_| theta);
    let controller = adaptive::<_, N, 1>(1.0, constant, 4.0);
    let (mut learned, mut e) = (0.0, f64::MAX);
    let goal = |_| Reference::setpoint(0.5);
    watched(&plant, controller, goal, [0.0; N], 0.05, 4000, |sample, controller| {
        learned = controller.parameters()[0];
        e = (sample.reference.r - sample.x).norm();
    });
    approx::assert_abs_diff_eq!(learned, theta, epsilon = 1e-12);
    assert!(e < 1e-12, "{e}");
}

#[test]
fn a_constant_is_learned_to_the_last_digits() {
    for theta in [0.7, -3.0] {
        learns_a_constant::<1>(theta);
        learns_a_constant::<2>(theta);
        learns_a_constant::<3>(theta);
        learns_a_constant::<4>(theta);
    }
}

/// AᵀP + PA = −I for two poles at −λ, by hand: p₁₂ = 1/(2λ²), p₂₂ = (1 + 1/λ²)/(4λ); s weighs ε with them.
fn weighs_by_the_lyapunov_matrix<T: Scalar>() {
    let lambda = 1.5;
    let base = flc(IntegratorChain::<T, 2>::new(), lambda);
    let regressor = |_: &SVector<T, 2>| SVector::from([T::one()]);
    let mut controller =
        ModelReferenceAdaptive::new(base, regressor, num(0.1), [T::one(); 2]).unwrap();
    controller = controller.with_model_at([num::<T>(0.5), num(-2.0)]).unwrap();
    let (p12, p22) = (0.5 / (lambda * lambda), (1.0 + 1.0 / (lambda * lambda)) / (4.0 * lambda));
    let x = Measurement::new([num::<T>(1.0), num(1.0)]);
    let command = controller.update(&x, &Reference::setpoint(T::zero()), num(0.1)).unwrap();
    let expected = p12 * (0.5 - 1.0) + p22 * (-2.0 - 1.0);
    let tolerance = 32.0 * real(T::default_epsilon());
    approx::assert_abs_diff_eq!(real(command.s), expected, epsilon = tolerance);
}

at_f32_and_f64! {
    s_weighs_the_error_by_the_lyapunov_matrix => weighs_by_the_lyapunov_matrix,
}

/// Without anything to learn, x_m and x are one, but for rounding; switched off, they need not be.
#[test]
fn without_uncertainty_it_is_feedback_linearization() {
    let plant = VanDerPol::new(0.8).unwrap();
    let base = flc(plant, 2.0);
    let plain = run(&plant, base, waves, [1.0, 0.0], 0.01, 3.0);
    let learning = ModelReferenceAdaptive::new(base, StateRegressor, 5.0, [1.0, 1.0]).unwrap();
    let mut off = learning.with_parameters([3.0, -2.0]).unwrap();
    off.set_learning(LearningMode::Off);
    for (sample, other) in run(&plant, off, waves, [1.0, 0.0], 0.01, 3.0).iter().zip(&plain) {
        assert_eq!((sample.u, sample.command.u_b), (other.u, other.command.u_b));
        assert_eq!((sample.command.u_a, sample.command.s), (0.0, 0.0));
    }
    // The first sample, from θ̂ = 0 and ε = 0, learning.
    assert_eq!(run(&plant, learning, waves, [1.0, 0.0], 0.01, 0.0)[0].u, plain[0].u);
}

#[test]
fn frozen_parameters_stay_and_act() {
    let theta = SVector::from([1.0, -0.5]);
    let mut controller = adaptive(1.5, StateRegressor, 5.0).with_parameters(theta).unwrap();
    controller.set_learning(LearningMode::Frozen);
    watched(&plant(1.0), controller, waves, [0.5, 0.0], 0.01, 300, |sample, controller| {
        assert_eq!(*controller.parameters(), theta);
        approx::assert_abs_diff_eq!(sample.command.u_a, -theta.dot(&sample.x), epsilon = 1e-14);
    });
}

/// A limit on the input is no uncertainty: the chain at its limit and the model that is told of it go the same way.
#[test]
fn a_limit_of_the_actuator_is_not_learned() {
    let plant = IntegratorChain::<f64, 2>::new();
    let far = |_| Reference::setpoint(5.0);
    let mut limited_at_all = false;
    let limited = Limited::new(adaptive(2.0, constant, 5.0), Saturation::symmetric([0.5]).unwrap());
    watched(&plant, limited, far, [0.0, 0.0], 0.01, 1500, |sample, limited| {
        limited_at_all |= sample.command.is_limited();
        assert!(limited.controller().parameters()[0].abs() < 1e-11);
    });
    assert!(limited_at_all);
    // The same run without a report: it takes the missing force for a push back.
    let mut blind = adaptive(2.0, constant, 5.0);
    let (mut x, mut v) = (0.0, 0.0);
    for _ in 0..100 {
        let u =
            blind.update(&Measurement::new([x, v]), &far(0.0), 0.01).unwrap().u.clamp(-0.5, 0.5);
        x += 0.01 * v + 0.5e-4 * u;
        v += 0.01 * u;
    }
    assert!(blind.parameters()[0] < -1.0, "{}", blind.parameters());
}

proptest! {
    /// With φ odd the law is odd, bit for bit.
    #[test]
    fn the_mirrored_motion_is_answered_by_the_mirrored_input(
        samples in prop::collection::vec(prop::array::uniform6(-3.0..3.0_f64), 1..20),
    ) {
        let mut controller = adaptive(1.5, StateRegressor, 5.0);
        let mut mirrored = controller;
        for [x1, x2, r1, r2, r3, u] in samples {
            let at = |sign: f64| Measurement::new([sign * x1, sign * x2]).with_applied([sign * u]);
            let to = |sign: f64| Reference::new([sign * r1, sign * r2], sign * r3);
            let one = controller.update(&at(1.0), &to(1.0), 0.1).unwrap();
            let other = mirrored.update(&at(-1.0), &to(-1.0), 0.1).unwrap();
            prop_assert_eq!(one.u, -other.u);
        }
    }
}
