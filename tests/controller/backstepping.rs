//! Backstepping against its recursion, its gains by hand, and its Lyapunov function along a motion.

use brunovsky::{
    Error, Scalar,
    controller::{Backstepping, Controller, FeedbackLinearization, Gains, Measurement, Reference},
    plant::{FeedbackLinearizable, IntegratorChain, ThirdOrder, Uncertain, VanDerPol},
};
use nalgebra::{DMatrix, SVector};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{num, real, run},
};

/// k of N = 1, 2, 3, multiplied out by hand.
fn has_its_gains_by_hand<T: Scalar>() {
    let (c1, c2, c3) = (0.5, 1.25, 3.0);
    let one = Gains::<T, 1>::from_backstepping([num::<T>(c1)]).unwrap();
    let two = Gains::<T, 2>::from_backstepping([c1, c2].map(num::<T>)).unwrap();
    let three = Gains::<T, 3>::from_backstepping([c1, c2, c3].map(num::<T>)).unwrap();
    // Sums and products of these are exact in either precision.
    assert_eq!(one.as_vector().as_slice(), [c1].map(num::<T>));
    assert_eq!(two.as_vector().as_slice(), [1.0 + c1 * c2, c1 + c2].map(num::<T>));
    let expected = [c1 + c3 + c1 * c2 * c3, 2.0 + c1 * c2 + c1 * c3 + c2 * c3, c1 + c2 + c3];
    assert_eq!(three.as_vector().as_slice(), expected.map(num::<T>));
}

/// V falls by e^(−2·c·t) at least, from sample to sample but for the hold.
fn falls_in_any_precision<T: Scalar>() {
    let plant = ThirdOrder::<T>::new();
    let controller = Backstepping::new(plant, [1.0, 2.0, 1.5].map(num::<T>)).unwrap();
    let start = [1.0, -1.0, 0.5].map(num::<T>);
    let rest = |_| Reference::setpoint(T::zero());
    let samples = run(&plant, controller, rest, start, 0.001, 3.0);
    let first = real(samples[0].command.lyapunov());
    for sample in samples {
        let bound = first * (-2.0 * real(sample.t)).exp();
        assert!(real(sample.command.lyapunov()) <= bound * 1.02 + 1e-9, "{}", sample.t);
    }
}

at_f32_and_f64! {
    the_gains_are_those_by_hand => has_its_gains_by_hand,
    the_lyapunov_function_falls_exponentially => falls_in_any_precision,
}

/// The matrix of ż = S·z: −cᵢ on the diagonal, 1 above it and −1 below.
fn schwarz<const N: usize>(c: &[f64; N]) -> DMatrix<f64> {
    DMatrix::from_fn(N, N, |i, j| match () {
        () if i == j => -c[i],
        () if i + 1 == j => 1.0,
        () if i == j + 1 => -1.0,
        () => 0.0,
    })
}

/// z = M·e takes the companion matrix of k into that matrix: M·A = S·M, entry by entry.
fn is_the_loop_of_its_coordinates<const N: usize>(c: [f64; N]) {
    let controller = Backstepping::new(IntegratorChain::<f64, N>::new(), c).unwrap();
    let m = DMatrix::from_fn(N, N, |i, j| {
        controller.coordinates(&SVector::from_fn(|l, _| f64::from(u8::from(l == j))))[i]
    });
    let k = controller.gains().as_vector();
    let a = DMatrix::from_fn(N, N, |i, j| match () {
        () if i + 1 == N => -k[j],
        () => f64::from(u8::from(i + 1 == j)),
    });
    let (one, other) = (&m * &a, schwarz(&c) * &m);
    assert!((one - &other).amax() <= 1e-13 * other.amax(), "{c:?}");
}

proptest! {
    #[test]
    fn the_coordinates_obey_the_loop_that_the_law_is_made_for(c in prop::array::uniform6(0.1..5.0_f64)) {
        is_the_loop_of_its_coordinates([c[0]]);
        is_the_loop_of_its_coordinates([c[0], c[1]]);
        is_the_loop_of_its_coordinates([c[0], c[1], c[2]]);
        is_the_loop_of_its_coordinates([c[0], c[1], c[2], c[3]]);
        is_the_loop_of_its_coordinates(c);
    }

    /// Step by step as in the books: each virtual input, and z as what it lacks.
    #[test]
    fn the_input_is_that_of_the_recursion(
        c in prop::array::uniform3(0.1..5.0_f64), x in prop::array::uniform3(-2.0..2.0_f64),
        r in prop::array::uniform3(-2.0..2.0_f64), r_n_dot in -2.0..2.0_f64,
    ) {
        let plant = ThirdOrder::<f64>::new();
        let mut controller = Backstepping::new(plant, c).unwrap();
        let reference = Reference::new(r, r_n_dot);
        let command = controller.update(&Measurement::new(x), &reference, 0.01).unwrap();
        let [e1, e2, e3] = [r[0] - x[0], r[1] - x[1], r[2] - x[2]];
        let z1 = e1;
        let z2 = e2 + c[0] * z1;
        // ż₁ = e₂, ż₂ = e₃ + c₁·e₂.
        let z3 = (e3 + c[0] * e2) + c[1] * z2 + z1;
        // ż₃ = r⁽³⁾ − ẋ₃ + c₁·e₃ + c₂·ż₂ + ż₁ shall be −c₃·z₃ − z₂.
        let x3_dot = r_n_dot + c[0] * e3 + c[1] * (e3 + c[0] * e2) + e2 + c[2] * z3 + z2;
        let x = SVector::from(x);
        let u = (x3_dot - plant.drift(&x)) / plant.input_gain(&x);
        prop_assert!((command.z - SVector::from([z1, z2, z3])).amax() < 1e-12);
        prop_assert!((command.u - u).abs() < 1e-11 * (1.0 + u.abs()), "{} {}", command.u, u);
    }
}

/// V(0) − V(T) = ∫Σ cᵢ·zᵢ² dt along the motion behind a moving reference, with the trapezoidal rule and a hold of first order.
#[test]
fn what_the_lyapunov_function_loses_is_dissipated() {
    let plant = VanDerPol::new(1.2).unwrap();
    let c = [0.8, 2.5];
    let wave = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
    let left = |dt: f64| {
        let controller = Backstepping::new(plant, c).unwrap();
        let samples = run(&plant, controller, wave, [1.5, -1.0], dt, 2.0);
        let rate = |z: &SVector<f64, 2>| c[0] * z[0] * z[0] + c[1] * z[1] * z[1];
        let pairs = samples.windows(2);
        let dissipated: f64 = pairs
            .map(|pair| 0.5 * dt * (rate(&pair[0].command.z) + rate(&pair[1].command.z)))
            .sum();
        let (first, last) = (&samples[0], &samples[samples.len() - 1]);
        (first.command.lyapunov() - last.command.lyapunov() - dissipated).abs()
    };
    let order = (left(0.002) / left(0.001)).log2();
    assert!((order - 1.0).abs() < 0.1, "order {order}");
}

/// V̇ ≤ −c·|z|² + |z_n|·|Δ|: in the end |z| ≤ |Δ|/c.
#[test]
fn an_uncertainty_leaves_no_more_than_its_share() {
    let model = IntegratorChain::<f64, 3>::new();
    let plant = Uncertain::matched(model, |t: f64, _: &_, _: &_| 0.8 * (1.7 * t).sin());
    let controller = Backstepping::new(model, [1.0, 1.5, 2.0]).unwrap();
    let samples =
        run(&plant, controller, |_| Reference::setpoint(0.0), [2.0, 0.0, 0.0], 0.002, 30.0);
    for sample in samples.iter().filter(|sample| sample.t > 15.0) {
        assert!(sample.command.z.norm() <= 0.8, "{}", sample.t);
    }
}

/// The same input as feedback linearization with the gains it amounts to, to the last bit.
#[test]
fn it_is_feedback_linearization_with_its_own_gains() {
    let plant = VanDerPol::new(1.2).unwrap();
    let mut controller = Backstepping::new(plant, [0.8, 2.5]).unwrap();
    let mut plain = FeedbackLinearization::new(plant, *controller.gains());
    for k in 0..50 {
        let x = Measurement::new([f64::from(k).sin(), f64::from(3 * k).cos()]);
        let reference = Reference::new([f64::from(k).cos(), 0.3], -0.2);
        let command = controller.update(&x, &reference, 0.1).unwrap();
        let other = plain.update(&x, &reference, 0.1).unwrap();
        assert_eq!((command.u, command.u_f, command.u_b), (other.u, other.u_f, other.u_b));
    }
}

#[test]
fn bad_input_is_refused_by_name_and_leaves_no_trace() {
    let model = IntegratorChain::<f64, 2>::new();
    for value in [0.0, -1.0] {
        let refused = Error::NotPositive { name: "c", value };
        assert_eq!(Backstepping::new(model, [1.0, value]), Err(refused));
        assert_eq!(Gains::from_backstepping([value, 1.0]), Err(refused));
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = Backstepping::new(model, [1.0, bad]);
        assert!(matches!(refused, Err(Error::NonFinite { name: "c", .. })));
    }
    assert!(Backstepping::new(model, [1e200, 1e200]).is_err());
    let before = Backstepping::new(model, [1.0, 2.0]).unwrap();
    let mut used = before;
    let rest = Reference::setpoint(0.0);
    for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
        assert!(used.update(&Measurement::new([0.0, bad]), &rest, 0.1).is_err());
    }
    assert!(used.update(&Measurement::new([0.0, 0.0]), &rest, 0.0).is_err());
    assert_eq!(used, before);
    used.reset();
    assert_eq!(used, before);
}
