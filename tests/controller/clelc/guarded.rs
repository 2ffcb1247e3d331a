//! The guard in closed loop: faults on which learning fails and feedback alone does not, and what must not be taken for a fault.

use brunovsky::{
    channel::Saturation,
    controller::{Clelc, ClelcCommand, Limited, Reference},
    fuzzy::FuzzyNetwork,
    learning::{
        BackwardDifference, ErrorRate, Guarded, Measured, ModelAided, NeuroFuzzy, SlidingMode,
        Switching, Watchdog,
    },
    plant::{IntegratorChain, Uncertain},
    simulation::{Sample, Simulation},
};
use nalgebra::SVector;

use super::faults::{Faulty, Real, Spring};
use crate::support::{flc, run};

const DT: f64 = 0.01;
const LAMBDA: f64 = 2.0;
const ALPHA: f64 = 5.0;
const REACH: f64 = ALPHA * DT;
const BOUND: f64 = 2.0;
const FADE: f64 = 4.0;
const DELTA: f64 = 1.5;
const X0: [f64; 2] = [1.0, -1.0];

/// A double integrator with nothing wrong with it but that the model does not know of Δ.
const FREE: Spring =
    Spring { stiffness: 0.0, damping: 0.0, gain: 1.0, since: f64::NEG_INFINITY, delta: DELTA };

type Learner<E> = NeuroFuzzy<FuzzyNetwork<f64, 2, 3>, E, SlidingMode<f64>>;

fn learner<E: ErrorRate<f64, 2>>(error_rate: E, switching: Switching<f64>) -> Learner<E> {
    let network = FuzzyNetwork::evenly_spaced([1.0, 1.0]).unwrap();
    let rule = SlidingMode::new(ALPHA).unwrap().with_switching(switching).unwrap();
    NeuroFuzzy::new(network, error_rate, rule)
}

/// It bears |Δ̇| ≤ 2, jumps of Δ up to 3, and an s that is off by 1e-9.
fn watchdog(switching: Switching<f64>) -> Watchdog<f64> {
    let rule = SlidingMode::new(ALPHA).unwrap().with_switching(switching).unwrap();
    let certificate = rule.certificate(DT, BOUND).unwrap();
    let patience = certificate.recovery_time(3.0, 1e-3).unwrap().unwrap();
    Watchdog::new(certificate, 1e-3 + 1e-9, patience).unwrap()
}

fn guarded<E: ErrorRate<f64, 2>>(error_rate: E) -> Guarded<Learner<E>, f64> {
    let switching = Switching::SetValued;
    Guarded::new(learner(error_rate, switching), watchdog(switching)).with_fallback(FADE).unwrap()
}

fn rest(_t: f64) -> Reference<f64, 2> {
    Reference::setpoint(0.0)
}

type Samples = Vec<Sample<f64, Reference<f64, 2>, ClelcCommand<f64>, 2, 1>>;

/// The run of 60 s of learning alone on `plant`, where the sensor of ẋ says what it `says` from 10 s on. Beside it:
///
/// * a guard that only flags, which changes nothing and has tripped in the end;
/// * one that falls back: until it trips, after 10 s, it is learning alone; then u_n fades at the rate; and once it is gone the loop is, to the
///   last bit, that of feedback linearization on `afterwards` from that state. It comes to rest at `x`.
fn falls_back(plant: Spring, says: fn(f64) -> f64, afterwards: Spring, x: f64) -> Samples {
    let model = flc(plant, LAMBDA);
    let bare = learner(Measured, Switching::SetValued);
    let (fault, end) = (1000, 60.0);
    let sensor = [fault, u32::MAX];
    let alone = Faulty::new(Clelc::new(model, bare), says, sensor);
    let alone = run(&Real(plant), alone, rest, X0, DT, end);

    let flag = Clelc::new(model, Guarded::new(bare, watchdog(Switching::SetValued)));
    let mut flag = Faulty::new(flag, says, sensor);
    let flagged = run(&Real(plant), &mut flag, rest, X0, DT, end);
    assert_eq!(flagged, alone);
    assert!(flag.controller.compensator().tripped());

    let clelc = Clelc::new(model, guarded(Measured));
    let samples = run(&Real(plant), Faulty::new(clelc, says, sensor), rest, X0, DT, end);
    let parts = samples.iter().zip(&alone).position(|(a, b)| a != b).unwrap();
    assert!(parts > fault as usize);
    let mut wanted = samples[parts - 1].command.u_n;
    assert!(wanted.abs() > FADE * DT);
    let mut gone = parts;
    while samples[gone].command.u_n != 0.0 {
        wanted = (wanted.abs() - FADE * DT).copysign(wanted);
        assert_eq!(samples[gone].command.u_n, wanted);
        gone += 1;
    }
    assert!(wanted.abs() <= FADE * DT * (1.0 + 1e-9));
    let left = end - samples[gone].t;
    let plain = run(&Real(afterwards), model, rest, samples[gone].x, DT, left);
    for (guarded, plain) in samples[gone..].iter().zip(&plain) {
        assert_eq!((guarded.x, guarded.u), (plain.x, plain.u));
    }
    approx::assert_abs_diff_eq!(samples.last().unwrap().x, SVector::from([x, 0.0]), epsilon = 1e-9);
    alone
}

/// A sensor that is turned round sees −ẋ₂ = −u − Δ, so s = u_n + 2u_b + Δ: of the right sign while u_n is slow and u_b = −u_n − Δ, of the wrong one
/// while it is fast. Learning alone goes round in a cycle, in which α is always too small for what s asks. Feedback alone does not look at the
/// sensor, and leaves x = Δ/k₁.
#[test]
fn a_sensor_that_is_turned_round_ends_in_feedback_alone() {
    let alone = falls_back(FREE, |x_dot| -x_dot, FREE, DELTA / (LAMBDA * LAMBDA));
    let widest = |from: usize| {
        alone[from..from + 1500].iter().map(|sample| sample.command.s.abs()).fold(0.0, f64::max)
    };
    approx::assert_relative_eq!(widest(3000), widest(4500), max_relative = 0.01);
    assert!(widest(4500) > 10.0 * REACH);
}

/// A sensor that is off by c is no different from a Δ that is greater by c: learning takes the loop to u_b = c, x = −c/k₁, where s = 0. What s
/// says is all that a guard has.
#[test]
fn a_bias_of_the_sensor_goes_unnoticed() {
    let clelc = Clelc::new(flc(FREE, LAMBDA), guarded(Measured));
    let mut controller = Faulty::new(clelc, |x_dot| x_dot + 0.5, [1000, u32::MAX]);
    let last = run(&Real(FREE), &mut controller, rest, X0, DT, 60.0).pop().unwrap();
    assert!(!controller.controller.compensator().tripped());
    approx::assert_abs_diff_eq!(last.command.s, 0.0, epsilon = 1e-9);
    approx::assert_abs_diff_eq!(last.x[0], -0.5 / (LAMBDA * LAMBDA), epsilon = 1e-9);
}

/// With b = −1 from t = 10 s on, ẋ₂ = 2a(x) − u_b − u_n + Δ = −12x₁ − 8x₂ − u_n + Δ: the spring is strong enough for the feedback of the wrong sign,
/// which leaves x = Δ/12. Where u_n is slow, x₁ = (Δ − u_n)/12 and s = (u_n − Δ)/3, so that learning runs away from the u_n = −Δ that it
/// had, by αh a sample in the end.
#[test]
fn an_input_whose_sign_flips_ends_in_feedback_alone() {
    let flipped = Spring { stiffness: 8.0, damping: 6.0, gain: -1.0, ..FREE };
    let flips = Spring { since: 10.0, ..flipped };
    let alone = falls_back(flips, |x_dot| x_dot, flipped, DELTA / 12.0);
    let [.., before, last] = &alone[..] else { panic!() };
    approx::assert_abs_diff_eq!(last.command.u_n - before.command.u_n, -REACH, epsilon = 1e-9);
    assert!(last.x[0] > 10.0);
}

/// b = 3 is beyond the margin b/b̂ < 2 of the set-valued sign: a step that can be taken whole doubles s, another takes 3αh off it, and |s| stays
/// between αh and 2αh but for the motion of the feedback. Feedback alone bears it, and leaves x = Δ/(3k₁).
#[test]
fn an_input_that_is_three_times_as_strong_ends_in_feedback_alone() {
    let strong = Spring { gain: 3.0, ..FREE };
    let grows = Spring { since: 10.0, ..strong };
    let alone = falls_back(grows, |x_dot| x_dot, strong, DELTA / (3.0 * LAMBDA * LAMBDA));
    for sample in alone.iter().rev().take(100) {
        let size = sample.command.s.abs() / REACH;
        assert!((0.9..2.1).contains(&size), "{size}");
    }
}

/// Behind an actuator that cannot hold Δ, a difference takes what does not arrive for uncertainty: it trips, u_n goes away, and the actuator gives
/// what it has. Learning that knows what arrived has nothing to be ashamed of.
#[test]
fn a_saturated_actuator_trips_only_the_learner_that_does_not_know_of_it() {
    fn end<E: ErrorRate<f64, 2> + Clone>(error_rate: E) -> (bool, f64, f64) {
        let model = IntegratorChain::<f64, 2>::new();
        let plant = Uncertain::matched(model, |_: f64, _: &_, _: &_| 1.0);
        let clelc = Clelc::new(flc(model, LAMBDA), guarded(error_rate));
        let mut limited = Limited::new(clelc, Saturation::symmetric([0.5]).unwrap());
        let last = run(&plant, &mut limited, rest, [0.0, 0.0], DT, 10.0).pop().unwrap();
        (limited.controller().compensator().tripped(), last.command.asked.u_n, last.u[0])
    }
    assert_eq!(end(BackwardDifference::new()), (true, 0.0, -0.5));
    let (tripped, u_n, u) = end(ModelAided::new());
    assert!(!tripped && u == -0.5);
    approx::assert_abs_diff_eq!(u_n, -1.0, epsilon = 1e-9);
}

fn never_trips(switching: Switching<f64>, delta: impl Fn(f64) -> f64) -> bool {
    let model = IntegratorChain::<f64, 2>::new();
    let plant = Uncertain::matched(model, |t: f64, _: &_, _: &_| delta(t));
    let guarded = Guarded::new(learner(Measured, switching), watchdog(switching));
    let mut clelc = Clelc::new(flc(model, LAMBDA), guarded);
    run(&plant, &mut clelc, rest, X0, DT, 30.0);
    !clelc.compensator().tripped()
}

/// A sine as fast as B at its fastest, a triangle that always is, and one that jumps by 3 every 5 s, in every direction; then slopes beyond B.
#[test]
fn an_uncertainty_within_the_bound_never_trips_it_and_a_faster_one_does() {
    let delta = 0.02;
    let triangle = |t: f64| BOUND * ((t + 0.5).rem_euclid(2.0) - 1.0).abs();
    for switching in
        [Switching::SetValued, Switching::Implicit { delta }, Switching::Explicit { delta: 0.05 }]
    {
        assert!(never_trips(switching, |t| BOUND / 3.0 * (3.0 * t).sin()));
        assert!(never_trips(switching, triangle));
        for jump in [3.0, -3.0] {
            let jumping = |t: f64| triangle(t) + jump * f64::from((t / 5.0) as u32 % 2);
            assert!(never_trips(switching, jumping));
        }
        assert!(never_trips(switching, |t| BOUND * t));
    }
    for switching in [Switching::SetValued, Switching::Implicit { delta }] {
        for slope in [1.2 * BOUND, -2.0 * BOUND, 2.0 * ALPHA] {
            assert!(!never_trips(switching, |t| slope * t), "{switching:?}, {slope}");
        }
    }
}

/// The sensor is mended at 20 s, and 10 s later the guard is armed again with a fresh learner: the input moves no faster than the certificate's αh
/// and the feedback has it, and the error that feedback alone had left is learned away.
#[test]
fn a_rearmed_guard_learns_again_without_a_bump() {
    let clelc = Clelc::new(flc(FREE, LAMBDA), guarded(Measured));
    let mut controller = Faulty::new(clelc, |x_dot| -x_dot, [1000, 2000]);
    let fallen = run(&Real(FREE), &mut controller, rest, X0, DT, 30.0);
    let last = fallen.last().unwrap();
    assert!(controller.controller.compensator().tripped() && last.command.u_n == 0.0);
    approx::assert_abs_diff_eq!(last.x[0], DELTA / (LAMBDA * LAMBDA), epsilon = 1e-9);

    let fresh = learner(Measured, Switching::SetValued);
    controller.controller.compensator_mut().rearm(fresh);
    let plant = Real(FREE);
    let again = Simulation::new(&plant, &mut controller, rest, last.x, DT).unwrap();
    let samples: Vec<_> = again.take(2000).map(Result::unwrap).collect();
    for (k, sample) in samples.iter().enumerate() {
        let u_n = -(REACH * (k as f64 + 1.0)).min(DELTA);
        approx::assert_abs_diff_eq!(sample.command.u_n, u_n, epsilon = 1e-9);
    }
    approx::assert_abs_diff_eq!(samples.last().unwrap().x, SVector::zeros(), epsilon = 1e-9);
    assert!(!controller.controller.compensator().tripped());
}
