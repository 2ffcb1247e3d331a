//! First order: what remains of σ, when it is reached, and what the gain does not change.

use brunovsky::{
    Error, Scalar,
    controller::{
        Controller, Measurement, Reference,
        sliding_mode::{SlidingModeControl, SlidingSurface},
    },
    learning::Switching,
    plant::{FeedbackLinearizable, IntegratorChain, Pendulum, ThirdOrder, Uncertain},
    simulation::TotalVariation,
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::exact_loop;
use crate::{
    at_f32_and_f64,
    support::{num, real, run},
};

type Chain = SlidingModeControl<IntegratorChain<f64, 1>, 1>;

fn chain(k: f64) -> Chain {
    let surface = SlidingSurface::from_lambda(1.0).unwrap();
    SlidingModeControl::new(IntegratorChain::new(), surface, k).unwrap()
}

/// Every kind of sign for gain `k` at period `dt`.
fn signs(k: f64, dt: f64) -> [Chain; 7] {
    let (chain, reach) = (chain(k), k * dt);
    let switched = |switching| chain.with_switching(switching).unwrap();
    [
        chain,
        chain.with_saturation(0.0).unwrap(),
        chain.with_saturation(0.3 * reach).unwrap(),
        chain.with_saturation(2.5 * reach).unwrap(),
        switched(Switching::Explicit { delta: 0.4 * reach }),
        switched(Switching::Explicit { delta: 2.0 * reach }),
        switched(Switching::Implicit { delta: 0.5 * reach }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(32) })]

    /// σ ends within the residual whatever Δ does within its bound, be it an adversary that pushes away from zero.
    #[test]
    fn no_uncertainty_within_the_bound_leaves_more_than_the_residual(
        share in 0.05..0.9_f64, sigma0 in -1.0..1.0_f64, dt in 0.001..0.1_f64,
        noise in prop::collection::vec(-1.0..1.0_f64, 30),
    ) {
        let k = 2.0;
        let bound = share * k;
        // To the boundary layer in |σ(0)|/(k − B); into it geometrically, by a factor that depends on the sign and nears 1 as B nears k.
        let periods = 60 + (40.0 * (1.0 + sigma0.abs() / dt) / (1.0 - share).powi(2)) as usize;
        for controller in signs(k, dt) {
            let residual = controller.residual(bound, dt).unwrap().unwrap();
            for adversary in [true, false] {
                let mut tried = controller;
                let samples = exact_loop(&mut tried, sigma0, dt, periods, |k, command| {
                    if adversary { -bound.copysign(command.sigma) } else { bound * noise[k % 30] }
                });
                let last = samples.iter().rev().take(30);
                let largest = last.map(|(command, _)| command.sigma.abs()).fold(0.0, f64::max);
                prop_assert!(largest <= residual * (1.0 + 1e-6), "{controller:?}: {largest} > {residual}");
            }
        }
    }
}

/// Under a constant Δ = −B both are equilibria: σ = B·h of the set-valued sign, δ·B/k of the saturation.
#[test]
fn a_constant_uncertainty_leaves_all_of_the_residual() {
    let (k, bound, dt) = (2.0, 1.5, 0.01);
    for controller in [chain(k), chain(k).with_saturation(3.0 * k * dt).unwrap()] {
        let samples = exact_loop(&mut { controller }, 0.0, dt, 2000, |_, _| -bound);
        let residual = controller.residual(bound, dt).unwrap().unwrap();
        approx::assert_relative_eq!(samples[1999].0.sigma, residual, max_relative = 1e-12);
        approx::assert_relative_eq!(samples[1999].0.u_s, bound, max_relative = 1e-12);
    }
}

/// The sign itself takes σ from one side to the other by (k − B)·h at least; the set-valued one lets it rest.
#[test]
fn the_plain_sign_chatters_and_the_set_valued_one_does_not() {
    let (k, dt) = (2.0, 0.01);
    let variation = |controller: Chain| {
        let samples = exact_loop(&mut { controller }, 0.5, dt, 1000, |_, _| 1.0);
        TotalVariation::of(samples[500..].iter().map(|(command, _)| command.u)).unwrap()
    };
    let plain = variation(chain(k).with_saturation(0.0).unwrap());
    // Δ = k/2: u is −k three times in four and k once, so it changes sign twice in four periods.
    assert!((plain / (2.0 * k * 250.0) - 1.0).abs() < 0.02, "{plain}");
    assert!(variation(chain(k)) < 1e-10);
}

fn pendulum() -> Pendulum<f64> {
    Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap()
}

/// In the sliding mode u_s = σ/h, whatever k is: the runs differ by rounding once both have reached the surface.
#[test]
fn a_gain_a_hundred_times_too_large_changes_nothing_in_the_sliding_mode() {
    let plant = Uncertain::matched(pendulum(), |t: f64, _: &_, _: &_| 2.0 * (3.0 * t).sin());
    let surface = SlidingSurface::from_lambda(3.0).unwrap();
    let inputs = |k: f64| {
        let controller = SlidingModeControl::new(pendulum(), surface, k).unwrap();
        // From the surface, because the way to it is another one for every k.
        let samples = run(&plant, controller, |_| Reference::setpoint(0.5), [0.4, 0.3], 0.01, 10.0);
        samples.iter().map(|sample| sample.command.u).collect::<Vec<_>>()
    };
    let (fitting, excessive) = (inputs(3.0), inputs(300.0));
    let variation = |u: &[f64]| TotalVariation::of(u.iter().copied()).unwrap();
    let (a, b) = (variation(&fitting), variation(&excessive));
    assert!((a - b).abs() <= 1e-9 * a, "{a} and {b}");
    let difference = fitting.iter().zip(&excessive).map(|(a, b)| (a - b).abs());
    assert!(difference.fold(0.0, f64::max) < 1e-9);
}

/// Against Δ = B from below σ falls by (k − B) a second: the certificate's time is attained, to a period and the motion of u_b.
#[test]
fn the_surface_is_reached_when_the_certificate_says() {
    let (bound, margin, dt) = (2.0, 0.5, 0.001);
    let plant = Uncertain::matched(ThirdOrder::new(), |_: f64, _: &_, _: &_| -bound);
    let surface = SlidingSurface::from_lambda(2.0).unwrap();
    let controller =
        SlidingModeControl::for_bound(ThirdOrder::new(), surface, bound, margin).unwrap();
    assert_eq!(controller.gain(), 2.5);
    // σ = 1 at the start is held up by Δ = −B; σ = −1 is brought down by it, at k + B a second.
    for (x1, time) in [(-0.25, 2.0), (0.25, 1.0 / 4.5)] {
        let samples =
            run(&plant, controller, |_| Reference::setpoint(0.0), [x1, 0.0, 0.0], dt, 3.0);
        let sigma0 = samples[0].command.sigma;
        assert_eq!(sigma0, -4.0 * x1);
        assert_eq!(controller.reaching_time(sigma0, bound).unwrap(), Some(2.0));
        let layer = controller.residual(bound, dt).unwrap().unwrap() * 1.1;
        let reached = samples.iter().find(|sample| sample.command.sigma.abs() <= layer).unwrap();
        assert!((reached.t - time).abs() < 0.02 * time, "{} for {time}", reached.t);
        let after = samples.iter().filter(|sample| sample.t > reached.t);
        assert!(after.into_iter().all(|sample| sample.command.sigma.abs() <= layer));
    }
}

/// |σ| ≤ φ and real poles leave |e₁| ≤ φ/c₁.
#[test]
fn the_error_stays_within_the_residual_over_the_first_coefficient() {
    let (bound, dt) = (2.0, 0.01);
    let surface = SlidingSurface::from_lambda(3.0).unwrap();
    for frequency in [0.3, 2.0, 9.0, 40.0] {
        let delta = move |t: f64, _: &_, _: &_| bound * (frequency * t).sin();
        let plant = Uncertain::matched(ThirdOrder::new(), delta);
        let controller = SlidingModeControl::new(ThirdOrder::new(), surface, 3.0).unwrap();
        let reference =
            |t: f64| Reference::new([0.1 * t.sin(), 0.1 * t.cos(), -0.1 * t.sin()], -0.1 * t.cos());
        let samples = run(&plant, controller, reference, [0.0, 0.1, 0.0], dt, 30.0);
        let late = samples.iter().skip(1000);
        let sigma = late.clone().map(|sample| sample.command.sigma.abs()).fold(0.0, f64::max);
        let error = late.map(|sample| (sample.reference.r - sample.x)[0].abs()).fold(0.0, f64::max);
        let residual = controller.residual(bound, dt).unwrap().unwrap();
        // u_b moves by O(h) in a period, which is the O(h²) of σ.
        assert!(sigma <= 1.1 * residual, "{frequency}: {sigma} > {residual}");
        assert!(error <= sigma / 9.0 * 1.01, "{frequency}: {error} > {sigma}/9");
    }
}

fn shares_in_any_precision<T: Scalar>() {
    let surface = SlidingSurface::from_lambda(num::<T>(3.0)).unwrap();
    let mut controller = SlidingModeControl::new(ThirdOrder::new(), surface, num(5.0)).unwrap();
    let measurement = Measurement::new([1.0, -1.0, 0.25].map(num::<T>));
    let command = controller.update(&measurement, &Reference::setpoint(T::zero()), num(0.01));
    let command = command.unwrap();
    // e = −x: σ = −0.25 + 6 − 9 = −3.25 and u_b = 6·e₃ + 9·e₂ = −1.5 + 9.
    assert_eq!((command.sigma, command.u_f), (num(-3.25), T::zero()));
    assert_eq!((command.u_b, command.u_s), (num(7.5), num(-5.0)));
    let a = -1.0 - 0.25_f64.sin() + 1.0_f64.exp();
    approx::assert_abs_diff_eq!(
        real(command.u),
        2.5 - a,
        epsilon = 40.0 * real(T::default_epsilon())
    );
}

at_f32_and_f64! {
    the_shares_are_those_of_the_law => shares_in_any_precision,
}

#[test]
fn a_bad_parameter_or_call_is_named() {
    let surface = SlidingSurface::<f64, 1>::from_lambda(1.0).unwrap();
    let refused = |k| SlidingModeControl::new(IntegratorChain::<f64, 1>::new(), surface, k);
    assert_eq!(refused(0.0), Err(Error::NotPositive { name: "k", value: 0.0 }));
    assert!(matches!(refused(f64::INFINITY), Err(Error::NonFinite { name: "k", .. })));
    let negative = Error::Negative { name: "bound on the uncertainty", value: -1.0 };
    let for_bound =
        SlidingModeControl::for_bound(IntegratorChain::<f64, 1>::new(), surface, -1.0, 1.0);
    assert_eq!(for_bound, Err(negative));
    assert_eq!(chain(1.0).reaching_time(1.0, -1.0), Err(negative));
    assert_eq!(chain(1.0).residual(-1.0, 0.1), Err(negative));
    assert_eq!(chain(1.0).reaching_time(1.0, 1.0), Ok(None));
    assert_eq!(chain(1.0).residual(1.0, 0.1), Ok(None));
    assert!(chain(1.0).with_saturation(-0.1).is_err());
    assert!(chain(1.0).with_switching(Switching::Explicit { delta: 0.0 }).is_err());

    let mut far = chain(1e300);
    let refused = far.update(&Measurement::new([0.0]), &Reference::setpoint(1.0), 1e10);
    assert!(matches!(refused, Err(Error::NonFinite { name: "k*dt", .. })));
    let refused = far.update(&Measurement::new([0.0]), &Reference::setpoint(1.0), 0.0);
    assert_eq!(refused, Err(Error::NotPositive { name: "dt", value: 0.0 }));
}

/// The drift overflows and the gain vanishes.
struct Fragile;

impl FeedbackLinearizable<2> for Fragile {
    type Scalar = f64;

    fn drift(&self, x: &SVector<f64, 2>) -> f64 {
        x[0].exp()
    }

    fn input_gain(&self, x: &SVector<f64, 2>) -> f64 {
        x[1]
    }
}

#[test]
fn where_the_law_has_no_answer_it_says_why() {
    let surface = SlidingSurface::from_lambda(1.0).unwrap();
    let mut controller = SlidingModeControl::new(Fragile, surface, 1.0).unwrap();
    let mut at = |x: [f64; 2], r: f64| {
        controller.update(&Measurement::new(x), &Reference::setpoint(r), 0.1).unwrap_err()
    };
    assert_eq!(at([0.0, 0.0], 1.0), Error::Singular { name: "b(x)", value: 0.0 });
    assert!(matches!(at([1000.0, 1.0], 0.0), Error::NonFinite { name: "a(x)", .. }));
    assert!(matches!(at([0.0, 1.0], f64::NAN), Error::NonFiniteEntry { name: "r", .. }));
}
