//! Where there is nothing to learn, CLELC is feedback linearization.

use brunovsky::{
    Scalar,
    controller::{
        Clelc, ClelcCommand, Controller, FeedbackLinearization, Gains, Measurement, Reference,
    },
    fuzzy::FuzzyNetwork,
    learning::{
        Antecedents, BackwardDifference, ErrorRate, FilteredDifference, Fixed, Flow, Measured,
        ModelAided, NullCompensator, SlidingMode, Switching,
    },
    plant::{ControlAffine, FeedbackLinearizable, IntegratorChain, Pendulum, ThirdOrder},
};
use nalgebra::SVector;
use num_traits::Float;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{flc, learning, num, real, run},
};

/// A model whose drift and gain are what the test says, zeros of either sign included.
#[derive(Clone, Copy)]
struct Given<T, const N: usize> {
    drift: T,
    gain: T,
}

impl<T: Scalar, const N: usize> FeedbackLinearizable<N> for Given<T, N> {
    type Scalar = T;

    fn drift(&self, _x: &SVector<T, N>) -> T {
        self.drift
    }

    fn input_gain(&self, _x: &SVector<T, N>) -> T {
        self.gain
    }
}

/// Equality that tells +0 from −0 (and no NaN gets this far).
fn same_bits<T: Scalar + Float>(a: T, b: T) -> bool {
    a == b && Float::is_sign_negative(a) == Float::is_sign_negative(b)
}

fn null_is_feedback_linearization<T: Scalar + Float, const N: usize>(numbers: &[f64], gain: f64) {
    let at = |i: usize| num::<T>(numbers[i]);
    let model = Given::<T, N> { drift: at(0), gain: num(gain) };
    let gains = Gains::from_lambda(num::<T>(1.5)).unwrap();
    let mut plain = FeedbackLinearization::new(model, gains);
    let mut null = Clelc::new(plain, NullCompensator::new(BackwardDifference::new()));
    for sample in 0..3 {
        let x = SVector::<T, N>::from_fn(|i, _| at(1 + 4 * sample + i));
        let r = SVector::<T, N>::from_fn(|i, _| at(13 + 4 * sample + i));
        let (measurement, reference) = (Measurement::new(x), Reference::new(r, at(25 + sample)));
        let a = plain.update(&measurement, &reference, num(0.1)).unwrap();
        let b = null.update(&measurement, &reference, num(0.1)).unwrap();
        assert!(
            same_bits(a.u, b.u) && same_bits(a.u_f, b.u_f) && same_bits(a.u_b, b.u_b),
            "{a:?} {b:?}"
        );
    }
}

/// Zeros of both signs, alone or among ordinary numbers: that −0 survives shows only where every share is a zero.
fn numbers() -> impl Strategy<Value = Vec<f64>> {
    let zero = || prop::sample::select(vec![0.0, -0.0]);
    let number = prop_oneof![zero(), -9.0..9.0_f64];
    prop_oneof![prop::collection::vec(zero(), 28), prop::collection::vec(number, 28)]
}

proptest! {
    #[test]
    fn with_the_null_compensator_it_is_feedback_linearization_bit_for_bit(
        numbers in numbers(), gain in prop_oneof![-3.0..-0.1_f64, 0.1..3.0_f64],
    ) {
        null_is_feedback_linearization::<f32, 1>(&numbers, gain);
        null_is_feedback_linearization::<f32, 2>(&numbers, gain);
        null_is_feedback_linearization::<f32, 3>(&numbers, gain);
        null_is_feedback_linearization::<f32, 4>(&numbers, gain);
        null_is_feedback_linearization::<f64, 1>(&numbers, gain);
        null_is_feedback_linearization::<f64, 2>(&numbers, gain);
        null_is_feedback_linearization::<f64, 3>(&numbers, gain);
        null_is_feedback_linearization::<f64, 4>(&numbers, gain);
    }
}

/// The same along a whole closed loop, whatever the source that watches s.
fn null_along_a_loop<T: Scalar, E: ErrorRate<T, 3> + Clone>(error_rate: E) {
    let plant = ThirdOrder::<T>::new();
    let start = [1.0, -1.0, -10.0].map(num::<T>);
    let reference = |t: T| Reference::new([t.sin(), t.cos(), -t.sin()], -t.cos());
    let plain = run(&plant, flc(plant, 3.0), reference, start, 0.01, 10.0);
    let null = Clelc::new(flc(plant, 3.0), NullCompensator::new(error_rate));
    for (a, b) in plain.iter().zip(run(&plant, null, reference, start, 0.01, 10.0)) {
        assert_eq!((a.x, a.u, a.command.u_b), (b.x, b.u, b.command.u_b));
    }
}

fn null_with_every_source<T: Scalar + Default>() {
    null_along_a_loop::<T, _>(Measured);
    null_along_a_loop::<T, _>(BackwardDifference::new());
    null_along_a_loop::<T, _>(FilteredDifference::new(num::<T>(0.05)).unwrap());
    null_along_a_loop::<T, _>(ModelAided::new());
}

/// The pendulum with its drift rounded at the size of 100: the same plant to rounding and not beyond, so that s is hardly ever
/// exactly zero and the learning has something to amplify if it can.
struct Rounded<T>(Pendulum<T>);

impl<T: Scalar> ControlAffine<2, 1> for Rounded<T> {
    type Scalar = T;

    fn drift_field(&self, x: &SVector<T, 2>) -> SVector<T, 2> {
        let nudge = num::<T>(100.0);
        SVector::from([x[1], (self.0.drift(x) + nudge) - nudge])
    }

    fn input_fields(&self, x: &SVector<T, 2>) -> SVector<T, 2> {
        SVector::from([T::zero(), self.0.input_gain(x)])
    }
}

fn pendulum<T: Scalar>() -> Pendulum<T> {
    Pendulum::new(num(0.8), num(0.5), num(0.1), num(9.81)).unwrap()
}

/// The largest difference of the states under CLELC with exact ė_n and under feedback linearization, and the largest |ẋ₂|.
fn difference<T: Scalar>(
    switching: Switching<T>,
    antecedents: impl Antecedents<FuzzyNetwork<T, 2, 3>> + Clone,
) -> (f64, f64) {
    let plant = Rounded(pendulum::<T>());
    let start = [num::<T>(0.8), num(-0.5)];
    let reference = |_| Reference::setpoint(num(0.3));
    let rule = SlidingMode::new(num::<T>(25.0)).unwrap();
    let rule = rule.with_switching(switching).unwrap().with_antecedents(antecedents);
    let learner = learning(pendulum(), 2.0, Measured, rule);
    let plain = run(&plant, flc(pendulum(), 2.0), reference, start, 0.01, 10.0);
    let learned = run(&plant, learner, reference, start, 0.01, 10.0);
    let pairs = plain.iter().zip(&learned);
    let largest = pairs.map(|(a, b)| real((a.x - b.x).amax())).fold(0.0, f64::max);
    (largest, plain.iter().map(|a| real(a.command.u_b).abs()).fold(20.0, f64::max))
}

/// Δ = 0 and u_n(0) = 0 make s ≡ 0 but for rounding, and a stable sign keeps |u_n| at the size of that rounding.
fn stable_signs_do_not_learn_from_rounding<T: Scalar>() {
    let stable = [
        Switching::SetValued,
        Switching::Implicit { delta: num(0.05) },
        Switching::Implicit { delta: T::zero() },
        // αh/δ = 0.5 and 1.25, both below 2.
        Switching::Explicit { delta: num(0.5) },
        Switching::Explicit { delta: num(0.2) },
    ];
    for switching in stable {
        for (difference, size) in
            [difference(switching, Fixed), difference(switching, Flow::default())]
        {
            // A few roundings of ẋ₂ enter u_n at a time and are taken back at the next; k₁ = 4 turns u_n into position. The bound
            // leaves room for a dozen roundings a sample and the sum of those of the states, one a substep.
            let rounding = real(T::default_epsilon()) * (12.0 * size + 100.0);
            assert!(difference <= rounding, "{switching:?}: {difference} > {rounding}");
        }
    }
}

/// The counterpart: αh/δ = 5 multiplies rounding by −4 a sample until it chatters with αh/2 − δ = 0.075.
fn an_unstable_sign_learns_rounding<T: Scalar>() {
    let (difference, _) = difference(Switching::Explicit { delta: num::<T>(0.05) }, Fixed);
    assert!(difference > 1e-6, "{difference}");
}

at_f32_and_f64! {
    the_null_compensator_changes_no_bit_of_a_whole_run => null_with_every_source,
    without_uncertainty_stable_learning_stays_at_rounding => stable_signs_do_not_learn_from_rounding,
    explicit_learning_beyond_its_limit_amplifies_rounding => an_unstable_sign_learns_rounding,
}

#[test]
fn a_reference_to_a_controller_controls_as_it_does() {
    type Object<'a> = dyn Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>, Command = ClelcCommand<f64>>
        + 'a;
    let plant = IntegratorChain::<f64, 2>::new();
    let fresh = learning(plant, 2.0, BackwardDifference::new(), SlidingMode::new(5.0).unwrap());
    let runs = |controller: &mut Object| {
        run(&plant, controller, |_| Reference::setpoint(1.0), [0.0, 0.0], 0.01, 2.0)
    };
    let (mut by_reference, mut as_object) = (fresh, fresh);
    let owned = run(&plant, fresh, |_| Reference::setpoint(1.0), [0.0, 0.0], 0.01, 2.0);
    let referred =
        run(&plant, &mut by_reference, |_| Reference::setpoint(1.0), [0.0, 0.0], 0.01, 2.0);
    assert_eq!(owned, referred);
    assert_eq!(owned, runs(&mut as_object));
    assert_eq!(by_reference, as_object);
    assert_ne!(as_object, fresh, "what was learned stays behind");
    let object: &mut Object = &mut as_object;
    Controller::reset(&mut { object });
    assert_eq!(as_object, fresh);
}

/// Without a report of the applied input it is the last command, and 0 before the first.
#[test]
fn an_input_reported_as_commanded_changes_nothing() {
    fn check<E: ErrorRate<f64, 2> + Clone>(error_rate: E) {
        let rule = SlidingMode::new(5.0).unwrap();
        let mut told = learning(pendulum::<f64>(), 2.0, error_rate, rule);
        let mut untold = told.clone();
        let mut last = 0.0;
        for k in 0..20 {
            let phase = f64::from(k);
            let state = Measurement::new([phase.sin(), phase.cos()]).with_rate([0.0, -phase.sin()]);
            let reference = Reference::setpoint(0.3);
            let command = untold.update(&state, &reference, 0.1).unwrap();
            let reported = state.with_applied([last]);
            assert_eq!(told.update(&reported, &reference, 0.1), Ok(command));
            last = command.u;
        }
        // A report of something else does change what is learned from.
        let state = Measurement::new([0.0, 0.0]).with_rate([0.0, 0.0]);
        let reported = state.with_applied([last + 1.0]);
        let reference = Reference::setpoint(0.3);
        let (a, b) =
            (untold.update(&state, &reference, 0.1), told.update(&reported, &reference, 0.1));
        assert_ne!(a.unwrap().s, b.unwrap().s);
    }
    check(Measured);
    check(ModelAided::new());
}
