//! Super-twisting: the implicit step against its inclusion, what remains of σ, when it gets there, and saturated actuators.

use brunovsky::{
    Error, Scalar,
    channel::Saturation,
    controller::{
        Controller, Limited, Measurement, Reference,
        sliding_mode::{
            SlidingSurface, Stepping, SuperTwisting, SuperTwistingCommand, SuperTwistingGains,
        },
    },
    plant::{IntegratorChain, Pendulum, ThirdOrder, Uncertain},
    simulation::TotalVariation,
};
use proptest::prelude::*;

use super::exact_loop;
use crate::{
    at_f32_and_f64,
    support::{num, real, run},
};

type Chain = SuperTwisting<IntegratorChain<f64, 1>, 1>;

fn chain(gains: SuperTwistingGains<f64>) -> Chain {
    SuperTwisting::new(IntegratorChain::new(), SlidingSurface::from_lambda(1.0).unwrap(), gains)
}

fn levant(bound: f64) -> Chain {
    chain(SuperTwistingGains::for_rate(bound).unwrap())
}

fn largest_sigma<'a>(
    samples: impl IntoIterator<Item = &'a (SuperTwistingCommand<f64>, f64)>,
) -> f64 {
    samples.into_iter().map(|(command, _)| command.sigma.abs()).fold(0.0, f64::max)
}

proptest! {
    /// ξ⁺ + h·k₁·|ξ⁺|^½·ς + h²·k₂·ς = σ with ξ⁺ = σ − h·u_s and ς = (w⁺ − w)/(h·k₂), a sign of ξ⁺.
    #[test]
    fn the_closed_form_solves_the_inclusion(
        sigmas in prop::collection::vec((-8.0..1.0_f64, any::<bool>()), 1..20),
        k1 in 0.01..20.0_f64, k2 in 0.01..20.0_f64, dt in 0.001..1.0_f64,
    ) {
        let mut controller = chain(SuperTwistingGains::new(k1, k2).unwrap());
        let mut before = 0.0;
        for (exponent, positive) in sigmas {
            let size = 10.0_f64.powf(exponent);
            let sigma = if positive { size } else { -size };
            let reference = Reference::setpoint(0.0);
            let command = controller.update(&Measurement::new([-sigma]), &reference, dt).unwrap();
            let xi = sigma - dt * command.u_s;
            let sign = (command.w - before) / (dt * k2);
            // Differences of numbers up to |σ| and |w|, each rounded a few times.
            let (small, rounding) = (1e-14 * size, 1e-14 * before.abs() / (dt * k2));
            if xi.abs() > 10.0 * small {
                prop_assert!((sign - xi.signum()).abs() <= 1e-12 + rounding);
            } else {
                prop_assert!(sign.abs() <= 1.0 + 1e-12 + rounding);
            }
            // The root of a ξ⁺ that is all rounding is larger than that.
            let root = xi.abs().sqrt() * f64::from(u8::from(xi.abs() > 10.0 * small));
            let left = xi + dt * (k1 * root + dt * k2) * sign;
            let slack = 1e-12 * size + dt * (k1 * root + dt * k2) * rounding + 10.0 * small;
            let root_slack = dt * k1 * (10.0 * small).sqrt();
            prop_assert!((left - sigma).abs() <= slack + root_slack, "{left} for {sigma}");
            before = command.w;
        }
    }

    /// With |Δ(k) − Δ(k−1)| ≤ L·h the sliding mode leaves σ(k+1) = −h·(Δ(k) − Δ(k−1)), which does not exceed the residual.
    #[test]
    fn what_remains_is_the_step_of_the_uncertainty(
        steps in prop::collection::vec(-1.0..1.0_f64, 400), bound in 0.1..10.0_f64, dt in 0.001..0.1_f64,
        sigma0 in -0.1..0.1_f64,
    ) {
        let mut delta = 0.0;
        let mut controller = levant(bound);
        let residual = controller.gains().residual(bound, dt).unwrap().unwrap();
        let samples = exact_loop(&mut controller, sigma0 * bound * dt, dt, 400, |k, _| {
            delta += bound * dt * steps[k];
            delta
        });
        for pair in samples[200..].windows(3) {
            let step = pair[1].1 - pair[0].1;
            prop_assert!((pair[2].0.sigma + dt * step).abs() <= 1e-9 * residual);
            prop_assert!((pair[2].0.w + pair[1].1).abs() <= 1e-9 * bound);
        }
        prop_assert!(largest_sigma(&samples[200..]) <= residual * (1.0 + 1e-9));
    }
}

/// The same steady state from gains a hundred times as large, and an input that moves only as −Δ does. The w of the explicit law moves by h·k₂ in every
/// sample, in one direction or the other.
#[test]
fn the_implicit_law_does_not_chatter_whatever_the_gains_are() {
    let dt = 0.01;
    let delta = |k: usize| (k as f64 * dt).sin();
    let late = |bound: f64, stepping| {
        let mut controller = levant(bound).with_stepping(stepping);
        let samples = exact_loop(&mut controller, 0.2, dt, 3000, |k, _| delta(k));
        samples[1500..].iter().map(|(command, _)| *command).collect::<Vec<_>>()
    };
    let variation = |samples: &[SuperTwistingCommand<f64>],
                     of: fn(&SuperTwistingCommand<_>) -> f64| {
        TotalVariation::of(samples.iter().map(of)).unwrap()
    };
    let fitting = late(1.0, Stepping::Implicit);
    let excessive = late(100.0, Stepping::Implicit);
    let difference = fitting.iter().zip(&excessive).map(|(a, b)| (a.u - b.u).abs());
    assert!(difference.fold(0.0, f64::max) < 1e-9);
    let own = TotalVariation::of((1500..3000).map(delta)).unwrap();
    // u(k) = −2Δ(k−1) + Δ(k−2) is −Δ(k) to O(h²): the two differ by what happens at turns and at the ends.
    assert!((variation(&fitting, |command| command.u) / own - 1.0).abs() < 0.01);
    assert!((variation(&fitting, |command| command.w) / own - 1.0).abs() < 0.01);
    for bound in [1.0, 100.0] {
        let explicit = late(bound, Stepping::Explicit);
        let moved = 1499.0 * dt * 1.1 * bound;
        approx::assert_relative_eq!(
            variation(&explicit, |command| command.w),
            moved,
            max_relative = 1e-9
        );
    }
}

/// Forward Euler written down as it is in the books.
#[test]
fn the_explicit_law_is_forward_euler() {
    let (k1, k2, dt) = (1.7, 0.9, 0.02);
    let gains = SuperTwistingGains::new(k1, k2).unwrap();
    let mut controller = chain(gains).with_stepping(Stepping::Explicit);
    let (mut sigma, mut w) = (0.8_f64, 0.0);
    for (command, _) in exact_loop(&mut controller, sigma, dt, 500, |_, _| 0.3) {
        assert!((command.sigma - sigma).abs() < 1e-9);
        // A rounding of σ is more of its root where σ is next to nothing.
        let u = k1 * sigma.abs().sqrt() * sigma.signum() + w;
        assert!((command.u - u).abs() < 1e-4, "{} for {u}", command.u);
        (sigma, w) = (sigma - dt * (command.u + 0.3), w + k2 * dt * command.sigma.signum());
    }
}

/// Δ̇ = ρ with |ρ| ≤ L, as hard on the loop as it can be: by the sign of σ, of z = −(w + Δ), of both, and by chance.
fn hardest(kind: usize, sigma: f64, z: f64, noise: f64) -> f64 {
    match kind {
        0 => 1.0_f64.copysign(-z),
        1 => 1.0_f64.copysign(z),
        2 => 1.0_f64.copysign(-sigma),
        3 => 1.0_f64.copysign(sigma),
        4 => 1.0,
        5 if sigma * z > 0.0 => 1.0_f64.copysign(-z),
        5 => 1.0_f64.copysign(sigma),
        _ => noise,
    }
}

/// When |σ| has come to stay within `layer`, for `seconds` from σ(0) and z(0) under a Δ̇ of that kind.
fn settled(
    gains: SuperTwistingGains<f64>,
    (sigma0, z0): (f64, f64),
    bound: f64,
    kind: usize,
    noise: &[f64],
    (dt, seconds, layer): (f64, f64, f64),
) -> Option<f64> {
    let mut delta = -z0;
    let periods = (seconds / dt) as usize;
    let samples = exact_loop(&mut chain(gains), sigma0, dt, periods, |k, command| {
        let now = delta;
        let rate = hardest(kind, command.sigma, -(command.w + delta), noise[k % noise.len()]);
        delta += bound * dt * rate;
        now
    });
    let last = samples.iter().rposition(|(command, _)| command.sigma.abs() > layer);
    let settled = last.map_or(0, |last| last + 1);
    (settled + 10 < periods).then_some(settled as f64 * dt)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(64) })]

    /// The bound of Moreno and Osorio's function holds in samples, give or take a few periods.
    #[test]
    fn sigma_is_gone_within_the_reaching_time(
        sigma0 in -1.0..1.0_f64, z0 in -1.0..1.0_f64, k1 in 0.5..4.0_f64, excess in 1.05..4.0_f64,
        bound in 0.05..1.0_f64, kind in 0..7_usize, noise in prop::collection::vec(-1.0..1.0_f64, 17),
    ) {
        let k2 = excess * (bound + 2.0 * bound * bound / (k1 * k1));
        let gains = SuperTwistingGains::new(k1, k2).unwrap();
        let time = gains.reaching_time(sigma0, z0, bound).unwrap().unwrap();
        prop_assume!(time < 200.0);
        let dt = time.min(1.0) * 1e-3;
        // z takes a period to appear in σ, and a change of its rate as long.
        let layer = 4.0 * dt * dt * (k2 + bound);
        let reached = settled(gains, (sigma0, z0), bound, kind, &noise, (dt, 1.2 * time, layer));
        eprintln!("RATIO {}", reached.unwrap_or(9e9)/time);
        prop_assert!(reached.is_some_and(|t| t <= time + 10.0 * dt), "{reached:?} for {time}");
    }

    /// Any k₂ > L and k₁² > k₂ + L does it, Levant's among them.
    #[test]
    fn every_tolerated_rate_is_overcome(
        sigma0 in -1.0..1.0_f64, z0 in -1.0..1.0_f64, k2 in 1.05..4.0_f64, excess in 1.02..3.0_f64,
        kind in 0..7_usize, noise in prop::collection::vec(-1.0..1.0_f64, 17),
    ) {
        let gains = SuperTwistingGains::new((excess * (k2 + 1.0)).sqrt(), k2).unwrap();
        prop_assert!(gains.tolerates().is_some_and(|limit| limit > 1.0));
        let residual = 1.001 * gains.residual(1.0, 0.005).unwrap().unwrap();
        for gains in [gains, SuperTwistingGains::for_rate(1.0).unwrap()] {
            let run = (0.005, 100.0, residual);
            let reached = settled(gains, (sigma0, z0), 1.0, kind, &noise, run);
            prop_assert!(reached.is_some(), "{gains:?}");
        }
    }
}

/// Beyond k₂ a steady rate is not overcome: in σ > 0 z goes on growing by L − k₂ a second.
#[test]
fn a_rate_above_the_second_gain_is_not_tolerated() {
    let gains = SuperTwistingGains::new(3.0, 1.0).unwrap();
    assert_eq!(gains.tolerates(), Some(1.0));
    assert_eq!(gains.residual(1.0, 0.01), Ok(None));
    assert_eq!(gains.reaching_time(1.0, 0.0, 1.0), Ok(None));
    assert_eq!(settled(gains, (0.1, 0.0), 1.1, 4, &[0.0], (0.01, 100.0, 0.01)), None);
    assert_eq!(SuperTwistingGains::new(0.9, 1.0).unwrap().tolerates(), None);
    // Too small a k₁ loses against a Δ̇ that always pushes where σ is going.
    let slow = SuperTwistingGains::new(0.2, 1.1).unwrap();
    assert_eq!(settled(slow, (0.1, 0.0), 1.0, 0, &[0.0], (0.01, 100.0, 0.01)), None);
    let levant = SuperTwistingGains::for_rate(2.0).unwrap();
    // 1.5²·L − 1.1·L = 1.15·L is more than k₂ = 1.1·L.
    approx::assert_relative_eq!(levant.tolerates().unwrap(), 2.2, max_relative = 1e-14);
    assert_eq!(levant.reaching_time(1.0, 0.0, 2.0), Ok(None));
    assert!(levant.reaching_time(1.0, 0.0, 0.5).unwrap().is_some());
}

/// ξ and time scale: (σ, z, L) → (c²·σ, c·z, L), t → c·t leaves the law as it is.
#[test]
fn the_reaching_time_is_homogeneous_and_odd() {
    let gains = SuperTwistingGains::new(2.0, 3.0).unwrap();
    let time = |sigma, z| gains.reaching_time(sigma, z, 0.7).unwrap().unwrap();
    for (sigma, z) in [(1.0, 0.3), (-0.4, 1.0), (0.0, 2.0), (0.6, -0.9)] {
        approx::assert_relative_eq!(time(-sigma, -z), time(sigma, z), max_relative = 1e-14);
        approx::assert_relative_eq!(
            time(9.0 * sigma, 3.0 * z),
            3.0 * time(sigma, z),
            max_relative = 1e-13
        );
    }
    assert_eq!(time(0.0, 0.0), 0.0);
}

/// On a nonlinear plant of order 3 the same: σ is of the order h², and so is the error.
#[test]
fn a_nonlinear_plant_is_left_with_an_error_of_second_order() {
    let plant = Uncertain::matched(ThirdOrder::new(), |t: f64, _: &_, _: &_| 5.0 * t.sin());
    let error = |dt: f64| {
        let surface = SlidingSurface::from_lambda(3.0).unwrap();
        let gains = SuperTwistingGains::for_rate(8.0).unwrap();
        let controller = SuperTwisting::new(ThirdOrder::new(), surface, gains);
        let samples =
            run(&plant, controller, |_| Reference::setpoint(0.0), [1.0, -1.0, -2.0], dt, 20.0);
        let late = samples.iter().filter(|sample| sample.t > 12.0);
        late.map(|sample| sample.x[0].abs()).fold(0.0, f64::max)
    };
    let order = (error(0.02) / error(0.01)).log2();
    assert!((order - 2.0).abs() < 0.2, "{order}");
}

fn pendulum() -> Pendulum<f64> {
    Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap()
}

/// Conditioned, w stays within what the actuator can do, and the overshoot after a long saturation is a fraction of that of the w that winds up.
#[test]
fn a_saturated_actuator_does_not_wind_up_w() {
    let surface = SlidingSurface::from_lambda(1.0).unwrap();
    for stepping in [Stepping::Implicit, Stepping::Explicit] {
        let gains = SuperTwistingGains::for_rate(1.0).unwrap();
        let model = IntegratorChain::<f64, 1>::new();
        let law = SuperTwisting::new(model, surface, gains).with_stepping(stepping);
        let limit = Saturation::symmetric([1.0]).unwrap();
        let (mut told, mut untold) = (Limited::new(law, limit), law);
        let (mut x, mut y, mut w, mut undershoot) = (10.0_f64, 10.0_f64, 0.0_f64, [0.0_f64; 2]);
        for _ in 0..4000 {
            let reference = Reference::setpoint(0.0);
            let command = told.update(&Measurement::new([x]), &reference, 0.01).unwrap();
            w = w.max(command.asked.w.abs());
            x += 0.01 * (command.u[0] + 0.2);
            let u = untold.update(&Measurement::new([y]), &reference, 0.01).unwrap().u;
            y += 0.01 * (u.clamp(-1.0, 1.0) + 0.2);
            undershoot = [undershoot[0].min(x), undershoot[1].min(y)];
        }
        assert!(w <= 1.0 + 0.011 + 1e-12, "{stepping:?}: {w}");
        assert!(x.abs() < 1e-3, "{stepping:?}: {x}");
        assert!(undershoot[1] < -5.0, "{stepping:?}: {undershoot:?}");
        assert!(undershoot[0] > -0.5, "{stepping:?}: {undershoot:?}");
    }
}

proptest! {
    /// A report that all has arrived is no news, to the last bit.
    #[test]
    fn an_input_reported_as_commanded_changes_nothing(
        states in prop::collection::vec(prop::array::uniform2(-1.0..1.0_f64), 20), explicit in any::<bool>(),
    ) {
        let surface = SlidingSurface::from_lambda(2.0).unwrap();
        let gains = SuperTwistingGains::for_rate(3.0).unwrap();
        let stepping = if explicit { Stepping::Explicit } else { Stepping::Implicit };
        let mut told = SuperTwisting::new(pendulum(), surface, gains).with_stepping(stepping);
        let (mut untold, mut last) = (told, 0.0);
        for x in states {
            let (state, reference) = (Measurement::new(x), Reference::setpoint(0.3));
            let command = untold.update(&state, &reference, 0.1).unwrap();
            prop_assert_eq!(told.update(&state.with_applied([last]), &reference, 0.1), Ok(command));
            prop_assert_eq!(told, untold);
            last = command.u;
        }
        told.reset();
        prop_assert_eq!(told, SuperTwisting::new(pendulum(), surface, gains).with_stepping(stepping));
    }

    /// Conditioning to the input of another σ is what that σ would have done.
    #[test]
    fn w_is_what_the_state_that_asks_for_the_applied_input_makes_of_it(
        sigma in -0.2..0.2_f64, other in -0.2..0.2_f64, k1 in 0.1..3.0_f64, k2 in 0.1..3.0_f64,
    ) {
        let (dt, reference) = (0.1, Reference::setpoint(0.0));
        let start = chain(SuperTwistingGains::new(k1, k2).unwrap());
        let (mut told, mut really) = (start, start);
        told.update(&Measurement::new([-sigma]), &reference, dt).unwrap();
        let applied = really.update(&Measurement::new([-other]), &reference, dt).unwrap().u;
        let state = Measurement::new([0.05]);
        let a = told.update(&state.with_applied([applied]), &reference, dt).unwrap();
        let b = really.update(&state, &reference, dt).unwrap();
        prop_assert!((a.w - b.w).abs() <= 1e-14);
    }
}

fn shares_in_any_precision<T: Scalar>() {
    let surface = SlidingSurface::from_lambda(num::<T>(1.0)).unwrap();
    let gains = SuperTwistingGains::new(num::<T>(2.0), num(4.0)).unwrap();
    let mut controller = SuperTwisting::new(IntegratorChain::<T, 2>::new(), surface, gains);
    let mut at = |x: [f64; 2]| {
        let measurement = Measurement::new(x.map(num::<T>));
        controller.update(&measurement, &Reference::setpoint(T::zero()), num(0.5)).unwrap()
    };
    // h²·k₂ = 1 and h·k₁ = 1: of σ = 3 is left y² + y = 2, so y = 1, ξ⁺ = 1 and u_s = (3 − 1)/h.
    let first = at([-1.0, -2.0]);
    assert_eq!((first.sigma, first.u_b, first.w), (num(3.0), num(2.0), num(2.0)));
    approx::assert_relative_eq!(
        real(first.u_s),
        4.0,
        max_relative = 4.0 * real(T::default_epsilon())
    );
    // |σ| = 0.5 ≤ 1: all of it, w += σ/h.
    let second = at([0.0, 0.5]);
    assert_eq!((second.sigma, second.u_s, second.w), (num(-0.5), num(-1.0), num(1.0)));
    assert_eq!(second.u, num(-0.5));
}

at_f32_and_f64! {
    the_shares_are_those_of_the_law => shares_in_any_precision,
}

#[test]
fn a_bad_parameter_or_call_is_named() {
    assert_eq!(
        SuperTwistingGains::new(0.0, 1.0),
        Err(Error::NotPositive { name: "k1", value: 0.0 })
    );
    assert!(matches!(
        SuperTwistingGains::new(1.0, f64::NAN),
        Err(Error::NonFinite { name: "k2", .. })
    ));
    let name = "bound on the rate of the uncertainty";
    assert_eq!(SuperTwistingGains::for_rate(-1.0), Err(Error::NotPositive { name, value: -1.0 }));
    let gains = SuperTwistingGains::for_rate(1.0).unwrap();
    assert_eq!(gains.residual(-1.0, 0.1), Err(Error::Negative { name, value: -1.0 }));
    assert!(gains.reaching_time(f64::NAN, 0.0, 0.0).is_err());

    let mut controller = levant(1.0);
    let at = |controller: &mut Chain, x, dt| {
        controller.update(&Measurement::new([x]), &Reference::setpoint(0.0), dt)
    };
    at(&mut controller, 1.0, 0.1).unwrap();
    let before = controller;
    assert!(matches!(
        at(&mut controller, f64::NAN, 0.1),
        Err(Error::NonFiniteEntry { name: "x", .. })
    ));
    assert!(matches!(at(&mut controller, 1.0, -0.1), Err(Error::NotPositive { name: "dt", .. })));
    let refused = at(&mut controller, 1.0, f64::MAX);
    assert!(matches!(refused, Err(Error::NonFinite { name: "k2*dt", .. })));
    assert_eq!(controller, before);
}
