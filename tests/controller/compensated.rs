//! Any controller with a compensator on top: what s is, what it equals, and what the base is told.

use brunovsky::{
    Error, Scalar,
    channel::Saturation,
    controller::{
        Accept, Compensated, Controller, FeedbackLinearization, Gains, Limited, Measurement,
        Reference,
        sliding_mode::{
            IntegralSlidingMode, SlidingModeControl, SlidingSurface, SuperTwisting,
            SuperTwistingGains,
        },
    },
    fuzzy::FuzzyNetwork,
    learning::{
        BackwardDifference, LearningMode, Measured, ModelAided, NeuroFuzzy, NullCompensator,
        SlidingMode,
    },
    plant::{FeedbackLinearizable, IntegratorChain, Pendulum, Uncertain},
};
use nalgebra::SVector;

use crate::{
    at_f32_and_f64,
    support::{flc, learning, num, real, run},
};

fn pendulum<T: Scalar>() -> Pendulum<T> {
    Pendulum::new(num(0.8), num(0.5), num(0.1), num(9.81)).unwrap()
}

/// PI-D control of a position by nothing but gains, with back-calculation: u = P·e₁ + D·e₂ + I, İ = K·e₁ + (arrived − asked).
#[derive(Debug, Clone, Copy, PartialEq)]
struct PlainPid {
    integral: f64,
    asked: Option<f64>,
    told: Option<f64>,
}

const PID: PlainPid = PlainPid { integral: 0.0, asked: None, told: None };

impl Controller<2, 1> for PlainPid {
    type Scalar = f64;
    type Reference = Reference<f64, 2>;
    type Command = SVector<f64, 1>;

    fn update_if(
        &mut self,
        measurement: &Measurement<f64, 2, 1>,
        reference: &Reference<f64, 2>,
        dt: f64,
        accept: Accept<SVector<f64, 1>>,
    ) -> Result<SVector<f64, 1>, Error> {
        let e = reference.r - measurement.x;
        let told = measurement.applied.map(|applied| applied[0]);
        let missing = told.zip(self.asked).map_or(0.0, |(told, asked)| told - asked);
        let integral = self.integral + 4.0 * dt * e[0] + missing;
        let u = 8.0 * e[0] + 3.0 * e[1] + integral;
        accept(&SVector::from([u]))?;
        *self = Self { integral, asked: Some(u), told };
        Ok(SVector::from([u]))
    }

    fn reset(&mut self) {
        *self = PID;
    }
}

fn delta(t: f64) -> f64 {
    2.0 * (2.0 * t).sin() + 0.5
}

/// s = −(u_n(k−1) + Δ(t)) whatever the base is, with the measured ẋ_n and the u_n of a period ago.
fn learns_from_what_is_not_learned<C>(base: C)
where
    C: Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>>,
{
    let plant = Uncertain::matched(pendulum(), |t: f64, _: &_, _: &_| delta(t));
    let learner = IntegralSlidingMode::with_error_rate(4.0, Measured).unwrap();
    let controller = Compensated::new(base, pendulum(), learner);
    let reference = |t: f64| Reference::new([0.3 * t.sin(), 0.3 * t.cos()], -0.3 * t.sin());
    let samples = run(&plant, controller, reference, [0.8, -0.5], 0.01, 10.0);
    for pair in samples.windows(2) {
        // The last instant before the sample, at which ẋ is measured.
        let before = pair[1].t * (1.0 - f64::EPSILON);
        let expected = -(pair[0].command.u_n + delta(before));
        approx::assert_abs_diff_eq!(pair[1].command.s, expected, epsilon = 1e-11);
        let command = pair[1].command;
        let x = pair[1].x;
        let asked = pendulum().drift(&x) + pendulum().input_gain(&x) * command.u;
        let shares = command.u_f + command.u_b + command.u_n;
        approx::assert_abs_diff_eq!(asked, shares, epsilon = 1e-11);
    }
    let late = samples.iter().filter(|sample| sample.t > 5.0);
    let error = late.map(|sample| (sample.command.u_n + delta(sample.t)).abs());
    assert!(error.fold(0.0, f64::max) < 0.15);
}

#[test]
fn s_is_what_is_not_learned_around_any_base() {
    let surface = SlidingSurface::from_lambda(3.0).unwrap();
    let gains = SuperTwistingGains::for_rate(1.0).unwrap();
    learns_from_what_is_not_learned(flc(pendulum(), 3.0));
    learns_from_what_is_not_learned(SlidingModeControl::new(pendulum(), surface, 0.5).unwrap());
    learns_from_what_is_not_learned(SuperTwisting::new(pendulum(), surface, gains));
    learns_from_what_is_not_learned(PID);
    // A base that believes in another plant is as good a feedback as any.
    learns_from_what_is_not_learned(flc(Pendulum::new(1.5, 0.5, 0.0, 5.0).unwrap(), 3.0));
}

/// u_b = a + b·u_base − u_f is rounded, and so is all that follows; the learning forgets it as it forgets any error of s.
fn around_feedback_linearization<T: Scalar>() {
    let plant = Uncertain::matched(pendulum::<T>(), |t: T, _: &_, _: &_| t.sin());
    let rule = SlidingMode::new(num::<T>(5.0)).unwrap();
    let clelc = learning(pendulum::<T>(), 2.0, ModelAided::new(), rule);
    let learner = *clelc.compensator();
    let compensated = Compensated::new(flc(pendulum::<T>(), 2.0), pendulum(), learner);
    let (reference, start) = (|_| Reference::setpoint(num(0.3)), [num::<T>(0.8), num(-0.5)]);
    let a = run(&plant, clelc, reference, start, 0.01, 5.0);
    let b = run(&plant, compensated, reference, start, 0.01, 5.0);
    // ModelAided divides the roundings of x₂, below 2, by h = 0.01; everything else is smaller.
    let rounding = 2000.0 * real(T::default_epsilon());
    for (a, b) in a.iter().zip(&b) {
        assert!(real((a.x - b.x).amax()) <= rounding);
        assert!(real((a.command.u_n - b.command.u_n).abs()) <= 5.0 * rounding);
        assert!(real((a.command.u_b - b.command.u_b).abs()) <= 5.0 * rounding);
    }
}

/// With nothing to add the input is the base's, to the last bit, whatever b is.
fn with_nothing_to_add<T: Scalar>() {
    #[derive(Clone, Copy)]
    struct Vanishing<T>(T);
    impl<T: Scalar> FeedbackLinearizable<2> for Vanishing<T> {
        type Scalar = T;
        fn drift(&self, x: &SVector<T, 2>) -> T {
            x[0] * num(0.3)
        }
        fn input_gain(&self, _: &SVector<T, 2>) -> T {
            self.0
        }
    }
    let start = [num::<T>(0.8), num(-0.5)];
    let reference = |_| Reference::setpoint(num(0.3));
    let plain = run(&pendulum::<T>(), flc(pendulum(), 2.0), reference, start, 0.01, 3.0);
    for gain in [1.0, -1.0, 0.0] {
        let model = Vanishing(num::<T>(gain));
        let null = NullCompensator::new(BackwardDifference::new());
        let watched = Compensated::new(flc(pendulum(), 2.0), model, null);
        let network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap();
        let rule = SlidingMode::new(num::<T>(5.0)).unwrap();
        let mut off = Compensated::new(
            flc(pendulum(), 2.0),
            model,
            NeuroFuzzy::new(network, BackwardDifference::new(), rule),
        );
        off.set_learning(LearningMode::Off);
        let watched = run(&pendulum::<T>(), watched, reference, start, 0.01, 3.0);
        let off = run(&pendulum::<T>(), off, reference, start, 0.01, 3.0);
        for ((plain, watched), off) in plain.iter().zip(&watched).zip(&off) {
            assert_eq!(plain.command, watched.command.base);
            assert_eq!((plain.u, plain.u), (watched.u, off.u));
        }
    }
}

at_f32_and_f64! {
    around_feedback_linearization_it_is_clelc_to_rounding => around_feedback_linearization,
    without_a_learned_term_the_input_is_that_of_the_base => with_nothing_to_add,
}

type OnPid<K> = Compensated<PlainPid, IntegratorChain<f64, 2>, K, 2>;

fn on_pid() -> OnPid<IntegralSlidingMode<f64>> {
    Compensated::new(PID, IntegratorChain::new(), IntegralSlidingMode::new(3.0).unwrap())
}

/// All that arrives is news to nobody: the base is told its own command, to the last bit, though u_base + u_n − u_n is not u_base.
#[test]
fn a_base_whose_share_arrives_is_told_its_own_command() {
    let mut controller = on_pid();
    let (mut x, mut last) = (SVector::from([0.3, -0.7]), None::<(f64, f64)>);
    for k in 0..300 {
        let mut measurement = Measurement::new(x);
        if let Some((u, _)) = last {
            measurement = measurement.with_applied([u]);
        }
        let command = controller.update(&measurement, &Reference::setpoint(0.0), 0.01).unwrap();
        assert_eq!(controller.base().told, last.map(|(_, u_base)| u_base));
        assert!(k < 2 || command.u != command.base[0]);
        last = Some((command.u, command.base[0]));
        x += SVector::from([x[1], command.u + 1.3]) * 0.01;
    }
    // Without a report it gets none.
    controller.update(&Measurement::new(x), &Reference::setpoint(0.0), 0.01).unwrap();
    assert_eq!(controller.base().told, None);
}

/// What an actuator cuts off is cut off from the base: it is told what u_n left for it.
#[test]
fn a_base_behind_a_saturated_actuator_is_told_what_was_left_for_it() {
    let mut limited = Limited::new(on_pid(), Saturation::symmetric([2.0]).unwrap());
    let mut x = SVector::from([-3.0, 0.0]);
    let mut last = None;
    for _ in 0..300 {
        let reference = Reference::setpoint(0.0);
        let command = limited.update(&Measurement::new(x), &reference, 0.01).unwrap();
        if let Some((u, u_n)) = last {
            approx::assert_abs_diff_eq!(
                limited.controller().base().told.unwrap(),
                u - u_n,
                epsilon = 1e-12
            );
        }
        last = Some((command.u[0], command.asked.u_n));
        x += SVector::from([x[1], command.u[0] + 1.3]) * 0.01;
    }
}

/// An integrator with back-calculation and a learner on top, through a saturation and after it: neither winds up, and the integral ends at what the model
/// asks of it, 0, as Δ is learned.
#[test]
fn an_integrating_base_and_the_learner_do_not_fight() {
    let plant = Uncertain::matched(IntegratorChain::<f64, 2>::new(), |_: f64, _: &_, _: &_| 1.0);
    let limit = Saturation::symmetric([2.0]).unwrap();
    let reference = |_| Reference::setpoint(0.0);
    let mut both = Limited::new(on_pid(), limit);
    let samples = run(&plant, &mut both, reference, [-3.0, 0.0], 0.01, 40.0);
    assert!(samples.iter().any(|sample| sample.command.is_limited()));
    approx::assert_abs_diff_eq!(both.controller().base().integral, 0.0, epsilon = 1e-3);
    approx::assert_abs_diff_eq!(samples.last().unwrap().command.asked.u_n, -1.0, epsilon = 1e-9);
    assert!(samples.last().unwrap().x.amax() < 1e-3);
    let overshoot = samples.iter().map(|sample| sample.x[0]).fold(0.0, f64::max);

    // The same two and nobody tells them.
    let (mut blind, mut x, mut farthest) = (on_pid(), SVector::from([-3.0, 0.0]), 0.0_f64);
    for _ in 0..4000 {
        let u = blind.update(&Measurement::new(x), &Reference::setpoint(0.0), 0.01).unwrap().u;
        x += SVector::from([x[1], u.clamp(-2.0, 2.0) + 1.0]) * 0.01;
        farthest = farthest.max(x[0]);
    }
    assert!(overshoot < 0.01 && farthest > 0.5, "{overshoot}, {farthest}");
}

#[test]
fn a_refused_call_leaves_base_and_compensator_as_they_were() {
    let learner = IntegralSlidingMode::with_error_rate(3.0, Measured).unwrap();
    let mut controller = Compensated::new(PID, IntegratorChain::<f64, 2>::new(), learner);
    let (good, reference) =
        (Measurement::new([0.1, 0.2]).with_rate([0.2, 0.3]), Reference::setpoint(0.5));
    controller.update(&good, &reference, 0.1).unwrap();
    let before = controller;
    let missing = controller.update(&Measurement::new([0.1, 0.2]), &reference, 0.1);
    assert_eq!(missing, Err(Error::Missing { name: "measured rate of x_n" }));
    assert!(controller.update(&good, &Reference::setpoint(f64::NAN), 0.1).is_err());
    assert!(controller.update(&good, &reference, 0.0).is_err());
    let refused = Error::Missing { name: "permission" };
    assert_eq!(controller.update_if(&good, &reference, 0.1, &mut |_| Err(refused)), Err(refused));
    assert_eq!(controller, before);
    controller.reset();
    assert_eq!(controller, Compensated::new(PID, IntegratorChain::new(), learner));
}

/// The gain vanishes at x₂ = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Fragile;

impl FeedbackLinearizable<2> for Fragile {
    type Scalar = f64;

    fn drift(&self, _: &SVector<f64, 2>) -> f64 {
        0.0
    }

    fn input_gain(&self, x: &SVector<f64, 2>) -> f64 {
        x[1]
    }
}

#[test]
fn a_learned_term_without_an_input_to_give_it_is_an_error() {
    let base = FeedbackLinearization::new(
        IntegratorChain::<f64, 2>::new(),
        Gains::new([1.0, 1.0]).unwrap(),
    );
    let learner = IntegralSlidingMode::with_error_rate(3.0, Measured).unwrap();
    let mut controller = Compensated::new(base, Fragile, learner);
    let at = |x: [f64; 2], rate| Measurement::new(x).with_rate([x[1], rate]);
    let (reference, dt) = (Reference::setpoint(0.0), 0.1);
    // s = −(u_n + ẋ₂ − b·u): 0 at first, so nothing is added, and then not.
    let first = controller.update(&at([1.0, 0.0], 0.0), &reference, dt).unwrap();
    assert_eq!(first.u, first.base.u);
    let refused = controller.update(&at([1.0, 0.0], 1.0), &reference, dt);
    assert_eq!(refused, Err(Error::Singular { name: "b(x)", value: 0.0 }));
    controller.update(&at([1.0, 0.5], 1.0), &reference, dt).unwrap();
}
