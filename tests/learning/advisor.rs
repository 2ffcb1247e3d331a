use approx::assert_relative_eq;
use brunovsky::{
    Error, Scalar,
    learning::{Advisor, Recommendation, Switching},
    plant::ThirdOrder,
    prelude::*,
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, any_magnitude, cases, real, rng, ulps};

in_both_precisions! {
    a_ramp_gives_its_slope,
    a_record_scaled_by_two_scales_what_is_recommended,
    it_does_not_matter_whether_learning_was_on,
    a_bad_sample_is_refused_and_changes_nothing,
    a_record_that_is_too_short_or_at_rest_is_refused,
    samples_of_any_magnitude_are_refused_or_give_an_answer,
}

const PERIOD: f64 = 0.01;

/// Normal numbers with a standard deviation of 1, by the method of Box and Muller.
fn normal() -> impl FnMut() -> f64 {
    let mut rng = rng();
    move || {
        let (u, v): (f64, f64) = (rng.random_range(1e-12..1.0), rng.random_range(0.0..1.0));
        (-2.0 * u.ln()).sqrt() * (core::f64::consts::TAU * v).cos()
    }
}

/// What is recommended for 40 s of Δ(t) and noise.
fn advice(delta: impl Fn(f64) -> f64, noise: impl FnMut() -> f64) -> Recommendation<f64> {
    recorded(delta, noise).recommend().unwrap()
}

fn recorded<T: Scalar>(delta: impl Fn(f64) -> f64, mut noise: impl FnMut() -> f64) -> Advisor<T> {
    let mut advisor = Advisor::new(real(PERIOD)).unwrap();
    for k in 0..4000 {
        let s = -(delta(f64::from(k) * PERIOD) + noise());
        advisor.push(T::zero(), real(s)).unwrap();
    }
    advisor
}

/// Means of a ramp differ by its slope at every scale.
fn a_ramp_gives_its_slope<T: Scalar>() {
    let advice = recorded::<T>(|t| 1.0 - 0.375 * t, || 0.0).recommend().unwrap();
    // Δ ≤ 15 is rounded, and its differences over a period divided by 0.01; the clearest window is no worse.
    assert_relative_eq!(advice.bound(), real(0.375), max_relative = ulps(15.0 / 0.00375 * 4.0));
    assert!(advice.resolved() && advice.switching() == Switching::SetValued);
}

/// B·h to B·h/100 a period, noise from nothing to many times that. The 95 % quantile of |cos| is 0.997.
#[test]
fn of_a_sine_in_noise_bound_and_noise_are_found() {
    for (amplitude, omega) in [(5.0, 1.0), (0.2, 3.0), (40.0, 0.4)] {
        let bound = amplitude * omega;
        for relative in [0.0, 0.1, 1.0, 10.0] {
            let mut normal = normal();
            let sigma = relative * bound * PERIOD;
            let advice = advice(|t| amplitude * (omega * t).sin(), || sigma * normal());
            let found = advice.bound() / bound;
            assert!((0.8..1.3).contains(&found), "{relative}: {found}, {advice}");
            assert!(advice.resolved());
            // Without noise the bend of Δ in a period is taken for it.
            let bend = amplitude * (omega * PERIOD).powi(2);
            assert!(advice.noise() < 1.1 * sigma + bend, "{sigma}: {advice}");
            assert!(advice.noise() > 0.9 * sigma);
        }
    }
}

/// White noise on x_n, differenced: the variance of the second difference is 20 and not 6·2 times that of x_n.
#[test]
fn differenced_noise_counts_for_a_little_more() {
    let (mut normal, sigma) = (normal(), 0.01);
    let mut last = 0.0;
    let differenced = || {
        let now = sigma / PERIOD * normal();
        let noise = now - last;
        last = now;
        noise
    };
    let advice = advice(|t| 5.0 * t.sin(), differenced);
    let found = advice.noise() / (2.0_f64.sqrt() * sigma / PERIOD);
    assert_relative_eq!(found, f64::sqrt(20.0 / 12.0), max_relative = 0.1);
    assert!((0.8..1.3).contains(&(advice.bound() / 5.0)), "{advice}");
}

/// Where nothing but noise is to be seen it says so.
#[test]
fn noise_alone_is_not_taken_for_a_clear_rate() {
    let advice = advice(|_| 3.0, normal());
    assert!(!advice.resolved(), "{advice}");
    assert_relative_eq!(advice.noise(), 1.0, max_relative = 0.1);
}

/// A source that knows nothing at its first sample says s = 0 there.
#[test]
fn the_first_sample_does_not_count() {
    let delta = |t: f64| 5.0 * (t + 1.0).sin();
    let clean = advice(delta, || 0.0);
    let spoilt = advice(|t| if t == 0.0 { 0.0 } else { delta(t) }, || 0.0);
    assert_relative_eq!(spoilt.bound(), clean.bound(), max_relative = 0.05);
    assert_eq!(spoilt.switching(), clean.switching());
}

#[test]
fn what_is_recommended_has_a_certificate() {
    for relative in [0.0, 0.3, 2.0, 5.0, 50.0, 500.0] {
        let mut normal = normal();
        let advice = advice(|t| 5.0 * t.sin(), || relative * 5.0 * PERIOD * normal());
        let certificate = advice.certificate().unwrap();
        assert!(certificate.holds());
        assert_eq!(
            advice.rule().unwrap().certificate(PERIOD, advice.bound()).unwrap(),
            certificate
        );
        assert!(advice.alpha() >= 3.0 * advice.bound());
        assert_eq!(
            advice.residual().unwrap(),
            certificate.residual().unwrap() + 3.0 * advice.noise()
        );
        assert_eq!(advice.slack(), 3.0 * advice.noise());
        let text = advice.to_string();
        assert!(text.contains("set-valued") == (advice.switching() == Switching::SetValued));
        // On either side of σ = √8·B·h.
        let noisy = advice.noise() > 8.0_f64.sqrt() * advice.bound() * PERIOD;
        assert_eq!(noisy, advice.switching() != Switching::SetValued);
        if let Switching::Implicit { delta } = advice.switching() {
            assert_relative_eq!(delta, 3.0 * advice.noise());
            let cost = |t: f64| advice.bound() * t + advice.noise() * (PERIOD / (2.0 * t)).sqrt();
            let filter = delta / advice.alpha();
            assert!(cost(filter) < cost(1.01 * filter) && cost(filter) < cost(0.99 * filter));
        }
    }
}

/// Powers of two scale without rounding.
fn a_record_scaled_by_two_scales_what_is_recommended<T: Scalar>() {
    let advice = |scale: f64| {
        let mut normal = normal();
        recorded::<T>(|t| scale * 5.0 * t.sin(), || scale * 0.5 * normal()).recommend().unwrap()
    };
    let (one, four) = (advice(1.0), advice(4.0));
    let scale = real::<T>(4.0);
    assert_eq!(four.bound(), one.bound() * scale);
    assert_eq!(four.noise(), one.noise() * scale);
    assert_eq!(four.alpha(), one.alpha() * scale);
    assert_eq!(four.switching().delta(), one.switching().delta() * scale);
    assert_eq!(four.window(), one.window());
}

/// s + u_n = −Δ, in sixteenths and so without rounding.
fn it_does_not_matter_whether_learning_was_on<T: Scalar>() {
    let (mut off, mut on) = (Advisor::new(T::one()).unwrap(), Advisor::new(T::one()).unwrap());
    let mut rng = rng();
    for _ in 0..200 {
        let sixteenth = |k: i32| real::<T>(f64::from(k) / 16.0);
        let delta = sixteenth(rng.random_range(-99..99));
        let u_n = sixteenth(rng.random_range(-99..99));
        off.push(T::zero(), -delta).unwrap();
        on.push(u_n, -delta - u_n).unwrap();
    }
    assert_eq!(off, on);
}

fn a_bad_sample_is_refused_and_changes_nothing<T: Scalar>() {
    let mut advisor = recorded::<T>(f64::sin, || 0.0);
    let before = advisor.clone();
    for bad in NOT_FINITE.map(real::<T>) {
        assert!(matches!(advisor.push(bad, T::zero()), Err(Error::NonFinite { name: "u_n", .. })));
        assert!(matches!(advisor.push(T::zero(), bad), Err(Error::NonFinite { name: "s", .. })));
        assert!(matches!(Advisor::new(bad), Err(Error::NonFinite { name: "dt", .. })));
    }
    assert_eq!(advisor, before);
    for bad in [0.0, -1.0] {
        assert_eq!(
            Advisor::new(real::<T>(bad)),
            Err(Error::NotPositive { name: "dt", value: bad })
        );
    }
    advisor.reset();
    assert_eq!(advisor, Advisor::new(real(PERIOD)).unwrap());
}

fn a_record_that_is_too_short_or_at_rest_is_refused<T: Scalar>() {
    let mut advisor = Advisor::new(real::<T>(PERIOD)).unwrap();
    for k in 0..22 {
        let found = advisor.recommend().unwrap_err();
        assert_eq!(
            found,
            Error::Length { name: "record of the uncertainty", expected: 22, found: k }
        );
        advisor.push(T::one(), T::one()).unwrap();
    }
    assert_eq!(
        advisor.recommend().unwrap_err(),
        Error::Singular { name: "rate of the uncertainty", value: 0.0 }
    );
}

/// Whatever was taken, what is recommended has a certificate that holds, or an error says why not.
fn samples_of_any_magnitude_are_refused_or_give_an_answer<T: Scalar>() {
    proptest!(cases(200), |(samples in prop::collection::vec((any_magnitude::<T>(), any_magnitude::<T>()), 100))| {
        let mut advisor = Advisor::new(real::<T>(PERIOD)).unwrap();
        let mut taken = 0;
        for (u_n, s) in samples {
            taken += u32::from(advisor.push(u_n, s).is_ok());
        }
        prop_assert!(taken > 50);
        if let Ok(advice) = advisor.recommend() {
            prop_assert!(advice.certificate().unwrap().holds());
            prop_assert!(advice.rule().is_ok());
        }
    });
}

/// The paper's third-order system under Δ = 5·sin t with noise on the measured x₃: |u_n + Δ| of every sample but the first five seconds, or with
/// learning off what the advisor is told.
fn run(
    rule: Option<SlidingMode<f64>>,
    sigma: f64,
    seconds: f64,
    noise: &mut impl FnMut() -> f64,
) -> (Advisor<f64>, Vec<f64>) {
    let model = ThirdOrder::new();
    let plant = Uncertain::matched(model, |t: f64, _x: &_, _u: &_| 5.0 * t.sin());
    let network = FuzzyNetwork::<_, 3, 3>::evenly_spaced([2.0, 2.0, 20.0]).unwrap();
    let learner =
        NeuroFuzzy::new(network, ModelAided::new(), rule.unwrap_or(SlidingMode::new(1.0).unwrap()));
    let flc = FeedbackLinearization::new(model, Gains::from_lambda(3.0).unwrap());
    let mut clelc = Clelc::new(flc, learner);
    clelc.set_learning(if rule.is_some() { LearningMode::Active } else { LearningMode::Off });
    let (mut x, mut u) = (SVector::from([1.0, -1.0, -10.0]), SVector::zeros());
    let (mut advisor, mut left) = (Advisor::new(PERIOD).unwrap(), Vec::new());
    for k in 0..(seconds / PERIOD) as u32 {
        let t = f64::from(k) * PERIOD;
        let seen = x + SVector::from([0.0, 0.0, sigma * noise()]);
        let measurement = Measurement::new(seen).with_applied(u);
        let command = clelc.update(&measurement, &Reference::setpoint(0.0), PERIOD).unwrap();
        u = SVector::from([command.u]);
        advisor.push(command.u_n, command.s).unwrap();
        if t > 5.0 {
            left.push((command.u_n + 5.0 * t.sin()).abs());
        }
        x = Rk4.integrate(|t, x: &_| plant.derivative(t, x, &u), t, &x, PERIOD, 2).unwrap();
    }
    (advisor, left)
}

/// One record of 40 s with learning off; then learning on noise that was not seen. The source is half a period late, by B·h/2, and noise beyond 3σ is
/// one sample in 370.
#[test]
fn what_was_learned_from_a_record_holds_on_noise_that_was_not_seen() {
    for sigma in [0.0, 1e-4, 1e-3, 1e-2] {
        let mut normal = normal();
        let (advisor, _) = run(None, sigma, 40.0, &mut normal);
        let advice = advisor.recommend().unwrap();
        assert!((0.8..1.3).contains(&(advice.bound() / 5.0)), "{advice}");
        let promise = advice.residual().unwrap() + 0.5 * 5.0 * PERIOD;
        for _ in 0..5 {
            let (_, left) = run(Some(advice.rule().unwrap()), sigma, 20.0, &mut normal);
            let beyond = left.iter().filter(|left| **left > promise).count();
            assert!(beyond as f64 <= 0.003 * left.len() as f64, "{sigma}: {beyond}, {advice}");
            // Nor is it a promise that anything would keep.
            let rms = (left.iter().map(|left| left * left).sum::<f64>() / left.len() as f64).sqrt();
            let expected = advice.expected().unwrap();
            assert!((expected / 4.0..expected).contains(&rms), "{sigma}: {rms}, {advice}");
        }
    }
}
