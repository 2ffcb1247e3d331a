//! Integral sliding mode: the nominal trajectory is followed from the first instant on.

use brunovsky::{
    Error,
    channel::Saturation,
    controller::{
        Clelc, Controller, FeedbackLinearization, Gains, Limited, Measurement, Reference,
        sliding_mode::IntegralSlidingMode,
    },
    learning::{LearningMode, Measured, Switching},
    plant::{FeedbackLinearizable, IntegratorChain, Pendulum, Plant, ThirdOrder, Uncertain},
};
use nalgebra::SVector;

use super::exact_loop;
use crate::support::{flc, run};

const BOUND: f64 = 2.0;

/// How far the loop with Δ is from that of the feedback alone without it, over the whole run and in its first tenth.
fn distance<P, const N: usize>(plant: &P, x0: [f64; N], dt: f64) -> [f64; 2]
where
    P: Plant<N, 1, Scalar = f64> + FeedbackLinearizable<N, Scalar = f64>,
{
    let base = || flc(plant, 2.0);
    let disturbed = Uncertain::matched(plant, |t: f64, _: &_, _: &_| BOUND * (4.0 * t + 1.0).cos());
    let controller = Clelc::new(base(), IntegralSlidingMode::new(1.2 * BOUND).unwrap());
    let reference = |_| Reference::setpoint(0.3);
    let nominal = run(plant, base(), reference, x0, dt, 5.0);
    let robust = run(&disturbed, controller, reference, x0, dt, 5.0);
    let distances: Vec<_> = nominal.iter().zip(&robust).map(|(a, b)| (a.x - b.x).amax()).collect();
    let largest = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    [largest(&distances), largest(&distances[..distances.len() / 10])]
}

/// σ = −h·Δ is all that is left of Δ, at the start as later: it halves with h.
#[test]
fn the_nominal_trajectory_is_followed_to_the_period() {
    fn check<P, const N: usize>(plant: &P, x0: [f64; N])
    where
        P: Plant<N, 1, Scalar = f64> + FeedbackLinearizable<N, Scalar = f64>,
    {
        let (coarse, fine) = (distance(plant, x0, 0.002), distance(plant, x0, 0.001));
        for (coarse, fine) in coarse.into_iter().zip(fine) {
            let order = (coarse / fine).log2();
            assert!((order - 1.0).abs() < 0.15, "order {order}: {coarse}, {fine}");
            // ẋ_n is off by Δ for one period; the feedback amplifies no more than its transient.
            assert!(fine < 3.0 * BOUND * 0.001, "{fine}");
        }
    }
    check(&IntegratorChain::<f64, 1>::new(), [1.0]);
    check(&IntegratorChain::<f64, 2>::new(), [1.0, -2.0]);
    check(&Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap(), [1.0, -2.0]);
    check(&ThirdOrder::<f64>::new(), [1.0, -1.0, -5.0]);
}

type Chain = Clelc<IntegratorChain<f64, 1>, IntegralSlidingMode<f64>, 1>;

fn chain(k: f64) -> Chain {
    let base = FeedbackLinearization::new(IntegratorChain::new(), Gains::new([1.5]).unwrap());
    Clelc::new(base, IntegralSlidingMode::new(k).unwrap())
}

/// σ(k+1) = σ(k) − h·(u_n + Δ) and u_n = clamp(σ/h, −k, k): u_n(k) = −Δ(k−1), and σ(k) = −h·Δ(k−1), for every k > B.
#[test]
fn the_term_is_minus_the_uncertainty_of_the_period_before_whatever_the_gain() {
    let delta = |k: usize| BOUND * (0.7 * k as f64).sin();
    for gain in [2.1, 2100.0] {
        let mut controller = chain(gain);
        let samples = exact_loop(&mut controller, 1.0, 0.01, 500, |k, _| delta(k));
        assert_eq!(samples[0].0.u_n, 0.0);
        for pair in samples.windows(2) {
            assert!((pair[1].0.u_n + pair[0].1).abs() < 1e-10);
        }
        let sigma = controller.compensator().sigma();
        assert!((sigma + 0.01 * samples[498].1).abs() < 1e-12);
    }
    // Too small a gain cannot: u_n stays at its limit, and σ grows by h·(B − k).
    let mut weak = chain(1.5);
    let samples = exact_loop(&mut weak, 1.0, 0.01, 101, |_, _| -BOUND);
    assert_eq!(samples[100].0.u_n, 1.5);
    approx::assert_relative_eq!(
        weak.compensator().sigma(),
        0.01 * (BOUND + 99.0 * (BOUND - 1.5)),
        max_relative = 1e-10
    );
}

/// An input that does not arrive is not in σ: after the saturation u_n is what it would be without it.
#[test]
fn a_saturated_actuator_does_not_wind_up_sigma() {
    let mut limited = Limited::new(chain(3.0), Saturation::symmetric([1.0]).unwrap());
    let mut x = -5.0;
    for k in 0..1500 {
        let command = limited.update(&Measurement::new([x]), &Reference::setpoint(0.0), 0.01);
        let command = command.unwrap();
        // Δ is a constant, known after a period, and with σ = −h·Δ as ever.
        assert!(k == 0 || (command.asked.u_n + 0.4).abs() < 1e-9, "{k}");
        x += 0.01 * (command.u[0] + 0.4);
    }
    assert!(x.abs() < 1e-3, "{x}");
}

/// With the measured ẋ_n, σ is the sum of h·s.
#[test]
fn another_source_of_the_rate_is_integrated_as_it_is() {
    let compensator = IntegralSlidingMode::with_error_rate(3.0, Measured).unwrap();
    let compensator = compensator.with_switching(Switching::Implicit { delta: 0.1 }).unwrap();
    let plant = Uncertain::matched(
        IntegratorChain::<f64, 2>::new(),
        |t: f64, _: &SVector<f64, 2>, _: &_| t.sin(),
    );
    let mut controller = Clelc::new(flc(IntegratorChain::<f64, 2>::new(), 2.0), compensator);
    let samples = run(&plant, &mut controller, |_| Reference::setpoint(1.0), [0.0, 0.0], 0.01, 3.0);
    let sum = samples.iter().map(|sample| 0.01 * sample.command.s).sum::<f64>();
    approx::assert_abs_diff_eq!(controller.compensator().sigma(), sum, epsilon = 1e-12);
    // s(k) = −(u_n(k−1) + Δ(k)).
    for pair in samples.windows(2) {
        let expected = -(pair[0].command.u_n + pair[1].t.sin());
        approx::assert_abs_diff_eq!(pair[1].command.s, expected, epsilon = 1e-12);
    }
}

/// Off, the loop is that of the feedback to the last bit, and a nominal trajectory begins where it is switched on again; frozen, u_n stays.
#[test]
fn the_learning_mode_switches_it_off_and_freezes_it() {
    let (mut controller, mut x) = (chain(3.0), -1.0);
    let mut after = |mode, delta: f64| {
        controller.set_learning(mode);
        let mut last = None;
        for _ in 0..50 {
            let (state, reference) = (Measurement::new([x]), Reference::setpoint(0.0));
            let command = controller.update(&state, &reference, 0.01).unwrap();
            let alone = controller.base().clone().update(&state, &reference, 0.01).unwrap();
            assert!(mode != LearningMode::Off || command.u == alone.u);
            x += 0.01 * (command.u + delta);
            last = Some((command.u_n, controller.compensator().sigma()));
        }
        last.unwrap()
    };
    let learned = after(LearningMode::Active, 0.7);
    approx::assert_abs_diff_eq!(learned.0, -0.7, epsilon = 1e-10);
    approx::assert_abs_diff_eq!(learned.1, -0.007, epsilon = 1e-12);
    assert_eq!(after(LearningMode::Frozen, -0.3), learned);
    assert_eq!(after(LearningMode::Off, 1.0), (0.0, 0.0));
    let again = after(LearningMode::Active, 1.0);
    approx::assert_abs_diff_eq!(again.0, -1.0, epsilon = 1e-10);
    // The Δ of the period before is in σ from the first sample on.
    approx::assert_abs_diff_eq!(again.1, -0.01, epsilon = 1e-12);
}

#[test]
fn a_bad_parameter_or_call_is_named() {
    let refused = IntegralSlidingMode::new(-1.0);
    assert_eq!(refused, Err(Error::NotPositive { name: "k", value: -1.0 }));
    let refused = IntegralSlidingMode::new(1.0).unwrap();
    assert!(refused.with_switching(Switching::Explicit { delta: 0.0 }).is_err());
    let mut far = chain(1e300);
    far.update(&Measurement::new([0.0]), &Reference::setpoint(0.0), 0.1).unwrap();
    let before = far;
    let refused = far.update(&Measurement::new([0.1]), &Reference::setpoint(0.0), 1e10);
    assert!(matches!(refused, Err(Error::NonFinite { name: "k*dt", .. })));
    let refused = far.update(&Measurement::new([f64::NAN]), &Reference::setpoint(0.0), 0.1);
    assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "x", .. })));
    assert_eq!(far, before);
}
