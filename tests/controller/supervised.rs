//! An operator beside the controller: who decides, what happens at a transfer, and what the loop does afterwards, in closed form.

use brunovsky::{
    Error, Scalar,
    channel::Saturation,
    controller::{
        Command, Controller, Limited, Measurement, Mode, Reference, Supervised, SupervisedCommand,
    },
    learning::{LearningMode, ModelAided, SlidingMode},
    plant::{FeedbackLinearizable, IntegratorChain},
};
use nalgebra::{SMatrix, SVector};

use crate::{
    at_f32_and_f64,
    support::{Learning, flc, learning, num},
};

const DT: f64 = 0.01;
const LAMBDA: f64 = 2.0;
const DELTA: f64 = 1.5;
const ALPHA: f64 = 5.0;
const FADE: f64 = 3.0;

const FLC: Mode = Mode::Automatic(LearningMode::Off);
const FROZEN: Mode = Mode::Automatic(LearningMode::Frozen);
const CLELC: Mode = Mode::Automatic(LearningMode::Active);

type Chain<T> = IntegratorChain<T, 2>;
type Clelc<T> = Learning<Chain<T>, ModelAided<T>, T, 2>;

fn clelc<T: Scalar>() -> Clelc<T> {
    let rule = SlidingMode::new(num(ALPHA)).unwrap();
    learning(Chain::new(), LAMBDA, ModelAided::new(), rule)
}

fn supervised<T: Scalar>() -> Supervised<Clelc<T>, T, 1> {
    Supervised::new(clelc(), [num::<T>(FADE)]).unwrap()
}

/// The double integrator ẍ = u + Δ with Δ constant, after a period under the input held: exact.
fn after<T: Scalar>(x: SVector<T, 2>, u: T) -> SVector<T, 2> {
    let (h, acceleration) = (num::<T>(DT), u + num(DELTA));
    SVector::from([x[0] + h * (x[1] + acceleration * h * num(0.5)), x[1] + h * acceleration])
}

/// `samples` of the loop around the set point 0, which nobody but the controller itself tells what was applied.
fn run<T: Scalar, C: Controller<2, 1, Scalar = T, Reference = Reference<T, 2>>>(
    controller: &mut C,
    x: &mut SVector<T, 2>,
    samples: u32,
) -> Vec<(SVector<T, 2>, C::Command)> {
    let mut sample = |_| {
        let rest = Reference::setpoint(T::zero());
        let command = controller.update(&Measurement::new(*x), &rest, num(DT)).unwrap();
        let now = *x;
        *x = after(*x, command.input()[0]);
        (now, command)
    };
    (0..samples).map(&mut sample).collect()
}

/// x(k+1) = A·x(k) + (h²/2, h)·(w + Δ) under u = −k·x + w, so that A = Φ − (h²/2, h)ᵀ·k.
fn closed_loop() -> (SMatrix<f64, 2, 2>, SVector<f64, 2>) {
    let input = SVector::from([0.5 * DT * DT, DT]);
    let k = SMatrix::<f64, 1, 2>::new(LAMBDA * LAMBDA, 2.0 * LAMBDA);
    (SMatrix::<f64, 2, 2>::new(1.0, DT, 0.0, 1.0) - input * k, input)
}

/// Through every pair of modes, from far off: at the switch u stays where it was, to the rounding of what the controller asks for; then
/// |w| loses R·h a sample, and once it is gone the input is the controller's to the last bit.
fn no_transfer_has_a_bump<T: Scalar>() {
    let modes = [Mode::Manual, FLC, FROZEN, CLELC];
    for (from, to) in modes.into_iter().flat_map(|from| modes.map(|to| (from, to))) {
        let (mut controller, mut x) = (supervised::<T>(), SVector::from([num(1.0), num(-2.0)]));
        controller.set_manual([num::<T>(0.7)]).unwrap();
        // Something is learned first, and the operator is far from what the controller wants.
        for mode in [CLELC, Mode::Manual] {
            controller.select(mode);
            run(&mut controller, &mut x, 40);
        }
        controller.set_manual([num::<T>(-0.4)]).unwrap();
        controller.select(from);
        let before = run(&mut controller, &mut x, 5);
        controller.select(to);
        let last = before.last().unwrap().1;
        let (mut u, mut w) = (last.u[0], if from == to { last.offset[0] } else { T::zero() });
        for (k, (_, command)) in run(&mut controller, &mut x, 600).into_iter().enumerate() {
            assert_eq!(command.mode, to);
            let asked = command.asked.unwrap().u;
            let rounding = T::default_epsilon() * (asked.abs() + u.abs()) * num(4.0);
            let offset = command.offset[0];
            match to {
                Mode::Manual => assert_eq!((command.u[0], offset), (u, T::zero())),
                Mode::Automatic(_) if k == 0 && from != to => {
                    assert!((command.u[0] - u).abs() <= rounding);
                    assert_eq!(offset, u - asked);
                    w = offset;
                }
                Mode::Automatic(_) => {
                    let faded = (w.abs() - num::<T>(FADE) * num(DT)).max(T::zero());
                    assert_eq!(offset, faded.copysign(w));
                    assert_eq!(command.u[0], asked + offset);
                    w = offset;
                }
            }
            u = if to == Mode::Manual { u } else { command.u[0] };
        }
        assert!(w.is_zero());
    }
}

/// From the sample at which w is gone: x = x* + Aʲ·(x − x*) with x* = (Δ/k₁, 0).
#[test]
fn after_a_transfer_to_feedback_alone_the_loop_is_that_of_feedback_alone() {
    let (a, _) = closed_loop();
    let rest = SVector::from([DELTA / (LAMBDA * LAMBDA), 0.0]);
    let (mut controller, mut x) = (supervised::<f64>(), SVector::from([1.0, -2.0]));
    run(&mut controller, &mut x, 50);
    controller.select(FLC);
    let samples = run(&mut controller, &mut x, 1500);
    let gone = samples.iter().position(|(_, command)| command.offset[0] == 0.0).unwrap();
    assert!(gone > 10);
    let mut wanted = samples[gone].0;
    for (x, _) in &samples[gone..] {
        approx::assert_abs_diff_eq!(*x, wanted, epsilon = 1e-12);
        wanted = rest + a * (wanted - rest);
    }
    approx::assert_abs_diff_eq!(x, rest, epsilon = 1e-9);
}

/// w is reported as applied, so it does not show in s: u_n goes straight to −Δ, α·h a sample, while w fades, and stays there. The state is
/// that of the linear loop under the known w + u_n + Δ, from the first sample to the last.
#[test]
fn after_a_transfer_to_learning_the_state_is_that_of_the_linear_loop_under_what_is_left() {
    let (a, input) = closed_loop();
    let (mut controller, mut x) = (supervised::<f64>(), SVector::from([1.0, -2.0]));
    controller.set_manual([0.3]).unwrap();
    run(&mut controller, &mut x, 50);
    controller.select(CLELC);
    let samples = run(&mut controller, &mut x, 1500);
    let (mut wanted, w0) = (samples[0].0, samples[0].1.offset[0]);
    for (k, (x, command)) in samples.iter().enumerate() {
        let k = k as f64;
        let u_n = -(ALPHA * DT * (k + 1.0)).min(DELTA);
        let w = (w0.abs() - FADE * DT * k).max(0.0).copysign(w0);
        approx::assert_abs_diff_eq!(*x, wanted, epsilon = 1e-10);
        approx::assert_abs_diff_eq!(command.asked.unwrap().u_n, u_n, epsilon = 1e-11);
        wanted = a * wanted + input * (w + u_n + DELTA);
    }
    approx::assert_abs_diff_eq!(x, SVector::zeros(), epsilon = 1e-9);
}

/// A minute of an operator who drives away while the controller asks for the opposite: nothing is learned, s goes on saying −Δ, and afterwards
/// |u_n| never exceeds |Δ|.
#[test]
fn learning_does_not_wind_up_while_the_operator_drives() {
    let (mut controller, mut x) = (supervised::<f64>(), SVector::zeros());
    controller.set_manual([2.0]).unwrap();
    for (_, command) in run(&mut controller, &mut x, 6000).into_iter().skip(1) {
        let asked = command.asked.unwrap();
        assert!(asked.u_n == 0.0 && command.u[0] == 2.0);
        // x₂ = 3.5·t, rounded and divided by h.
        approx::assert_abs_diff_eq!(asked.s, -DELTA, epsilon = 1e-10);
    }
    assert!(
        controller.controller().compensator().network().consequents().iter().all(|f| *f == 0.0)
    );
    controller.select(CLELC);
    for (_, command) in run(&mut controller, &mut x, 2000) {
        assert!(command.asked.unwrap().u_n.abs() <= DELTA + 1e-9);
    }
}

/// A plant that no input moves at x₁ = 7.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Dead;

impl FeedbackLinearizable<2> for Dead {
    type Scalar = f64;

    fn drift(&self, _x: &SVector<f64, 2>) -> f64 {
        0.0
    }

    fn input_gain(&self, x: &SVector<f64, 2>) -> f64 {
        if x[0] == 7.0 { 0.0 } else { 1.0 }
    }
}

#[test]
fn in_manual_mode_nothing_fails_whatever_the_sensors_say() {
    let rule = SlidingMode::new(ALPHA).unwrap();
    let learner = learning(Dead, LAMBDA, ModelAided::new(), rule);
    let mut controller = Supervised::<_, f64, 1>::new(learner, [FADE]).unwrap();
    controller.set_manual([1.25]).unwrap();
    let (good, rest) = (Measurement::new([1.0, 2.0]), Reference::setpoint(0.0));
    controller.update(&good, &rest, DT).unwrap();
    let inside = *controller.controller();
    let nan = f64::NAN;
    let bad = [
        (Measurement::new([nan, 0.0]), rest, DT),
        (good.with_rate([0.0, f64::INFINITY]), rest, DT),
        (good.with_applied([nan]), rest, DT),
        (good, Reference::setpoint(nan), DT),
        (Measurement::new([7.0, 0.0]), rest, DT),
        (good, rest, 0.0),
        (good, rest, nan),
        (Measurement::new([1e308, 1e308]), Reference::setpoint(-1e308), DT),
    ];
    for (measurement, reference, dt) in bad {
        let command = controller.update(&measurement, &reference, dt).unwrap();
        assert_eq!((command.u[0], command.mode), (1.25, Mode::Manual));
        assert!(command.asked.is_err());
        assert_eq!(*controller.controller(), inside);
    }
    // In automatic mode the same is an error, and leaves everything as it was.
    controller.select(CLELC);
    controller.update(&good, &rest, DT).unwrap();
    let before = controller;
    for (measurement, reference, dt) in bad {
        let refused: Result<SupervisedCommand<_, _, 1>, Error> =
            controller.update(&measurement, &reference, dt);
        assert!(refused.is_err());
        assert_eq!(controller, before);
    }
}

#[test]
fn taking_over_starts_from_the_last_input_and_goes_where_the_operator_says() {
    let (mut controller, mut x) = (supervised::<f64>(), SVector::from([1.0, 0.0]));
    controller.set_manual([9.0]).unwrap();
    controller.select(CLELC);
    let last = run(&mut controller, &mut x, 30).last().unwrap().1.u[0];
    controller.select(Mode::Manual);
    assert_eq!(run(&mut controller, &mut x, 1)[0].1.u[0], last);
    controller.set_manual([0.5]).unwrap();
    // Selecting what is selected is no second take-over, before the next sample or after it.
    controller.select(CLELC);
    run(&mut controller, &mut x, 1);
    controller.select(Mode::Manual);
    controller.set_manual([0.5]).unwrap();
    controller.select(Mode::Manual);
    assert_eq!(run(&mut controller, &mut x, 1)[0].1.u[0], 0.5);
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = controller.set_manual([bad]).unwrap_err();
        assert!(matches!(refused, Error::NonFiniteEntry { name: "manual input", index: 0, .. }));
    }
    assert_eq!(run(&mut controller, &mut x, 1)[0].1.u[0], 0.5);
}

/// With the limits around it, what arrives is within them in every mode, through every transfer.
#[test]
fn limits_around_it_hold_for_the_operator_and_the_offset() {
    let limits = Saturation::symmetric([5.0]).unwrap();
    let mut controller = Limited::new(supervised::<f64>(), limits);
    let mut x = SVector::from([3.0, 0.0]);
    controller.controller_mut().set_manual([50.0]).unwrap();
    for mode in [Mode::Manual, CLELC, Mode::Manual, FLC, CLELC] {
        controller.controller_mut().select(mode);
        for (_, command) in run(&mut controller, &mut x, 100) {
            assert!(command.u[0].abs() <= 5.0);
            assert!(command.asked.asked.unwrap().u_n.abs() <= DELTA + 1e-9);
        }
    }
    run(&mut controller, &mut x, 10_000);
    approx::assert_abs_diff_eq!(x, SVector::zeros(), epsilon = 1e-9);
}

/// Before any transfer there is no offset: the first mode selected is the controller inside, to the last bit.
#[test]
fn without_a_transfer_it_is_the_controller_inside() {
    let (mut bare, mut wrapped) = (clelc::<f64>(), supervised());
    wrapped.select(CLELC);
    let (mut x, mut y) = (SVector::from([1.0, -2.0]), SVector::from([1.0, -2.0]));
    let bare = run(&mut bare, &mut x, 500);
    for ((x, bare), (y, wrapped)) in bare.into_iter().zip(run(&mut wrapped, &mut y, 500)) {
        assert_eq!((x, Ok(bare), bare.u), (y, wrapped.asked, wrapped.u[0]));
    }
}

#[test]
fn the_learning_mode_of_the_loop_is_not_the_operators_business() {
    let mut controller = supervised::<f64>();
    controller.set_learning(LearningMode::Active);
    assert_eq!(controller.mode(), Mode::Manual);
    controller.select(FLC);
    controller.set_learning(LearningMode::Active);
    assert_eq!(controller.mode(), CLELC);
}

#[test]
fn reset_forgets_the_run_and_keeps_the_mode_and_the_operators_input() {
    let mut fresh = supervised::<f64>();
    fresh.set_manual([0.3]).unwrap();
    fresh.select(CLELC);
    let (mut used, mut x) = (fresh, SVector::from([1.0, -2.0]));
    run(&mut used, &mut x, 50);
    assert_ne!(used, fresh);
    used.reset();
    assert_eq!(used, fresh);
}

#[test]
fn a_fade_that_is_not_positive_is_refused() {
    let attempt = |fade: f64| {
        Supervised::<_, f64, 1>::new(flc(Chain::<f64>::new(), 1.0), [fade]).unwrap_err()
    };
    assert_eq!(attempt(0.0), Error::NotPositive { name: "fade", value: 0.0 });
    assert_eq!(attempt(-1.0), Error::NotPositive { name: "fade", value: -1.0 });
    assert!(matches!(attempt(f64::NAN), Error::NonFinite { name: "fade", .. }));
}

at_f32_and_f64! {
    at_every_transfer_the_input_stays_and_its_offset_fades_at_the_rate => no_transfer_has_a_bump,
}
