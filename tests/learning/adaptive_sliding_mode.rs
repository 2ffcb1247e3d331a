use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::FuzzyNetwork,
    learning::{AdaptationRule, AdaptiveSlidingMode, Fixed, SlidingMode, Switching},
    nalgebra::SVector,
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, SWITCHINGS, real, rng, ulps};

in_both_precisions! {
    a_step_is_that_of_the_sliding_mode_with_the_rate_that_there_is,
    with_nothing_left_to_learn_the_rate_falls_to_the_floor,
    at_the_ceiling_it_is_the_rule_with_that_rate,
    a_parameter_out_of_range_is_refused,
}

const FLOOR: f64 = 0.5;

/// The rule with γ = `growth` and ε = `layer`, on a network at one input.
struct Loop<T: Scalar> {
    rule: AdaptiveSlidingMode<T>,
    network: FuzzyNetwork<T, 2, 3>,
}

impl<T: Scalar> Loop<T> {
    fn new(growth: f64, layer: f64) -> Self {
        let rule = SlidingMode::new(real(FLOOR)).unwrap();
        Self {
            rule: AdaptiveSlidingMode::new(rule, real(growth), real(layer)).unwrap(),
            network: FuzzyNetwork::evenly_spaced([T::one(), real(2.0)]).unwrap(),
        }
    }

    /// One sample with s = −(u_n + Δ): that s, and α after it.
    fn step(&mut self, delta: T, dt: T) -> (T, T) {
        let e = SVector::from([0.3, -0.4].map(real));
        self.rule.follow(&mut self.network, &e);
        let firing = self.network.fire(&e);
        let s = -(self.network.output(&firing) + delta);
        self.rule.adapt(&mut self.network, &firing, s, dt);
        (s, self.rule.alpha())
    }
}

fn a_step_is_that_of_the_sliding_mode_with_the_rate_that_there_is<T: Scalar>() {
    let (gamma, layer, dt, mut rng) = (3.0, 0.1, real::<T>(0.01), rng());
    for switching in SWITCHINGS {
        let switching = match switching {
            Switching::Explicit { delta } => Switching::Explicit { delta: real(delta) },
            Switching::Implicit { delta } => Switching::Implicit { delta: real(delta) },
            Switching::SetValued => Switching::SetValued,
        };
        let inner = SlidingMode::new(real::<T>(FLOOR)).unwrap().with_antecedents(Fixed);
        let inner = inner.with_switching(switching).unwrap();
        let mut rule = AdaptiveSlidingMode::new(inner, real(gamma), real(layer)).unwrap();
        let mut network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(), real(2.0)]).unwrap();
        let mut alpha = real::<T>(FLOOR);
        for _ in 0..500 {
            let e = [rng.random_range(-3.0..3.0), rng.random_range(-3.0..3.0)];
            let firing = network.fire(&SVector::from(e.map(real)));
            let (s, before) = (real::<T>(rng.random_range(-1.0..2.0)), network.output(&firing));
            rule.adapt(&mut network, &firing, s, dt);
            alpha = (alpha + real::<T>(gamma) * dt * (s.abs() - real(layer))).max(real(FLOOR));
            assert_abs_diff_eq!(rule.alpha(), alpha, epsilon = ulps::<T>(500.0) * alpha);
            let step = alpha * dt * switching.sign(s, alpha * dt);
            // u_n stays below 64, and sums up nine products.
            assert_abs_diff_eq!(
                network.output(&firing) - before,
                step,
                epsilon = ulps(64.0 * 16.0)
            );
        }
    }
}

/// s = 0 once Δ = 1 is learned, and from there on α falls by γεh a sample.
fn with_nothing_left_to_learn_the_rate_falls_to_the_floor<T: Scalar>() {
    let (growth, layer, dt) = (4.0, 0.25, real::<T>(0.125));
    let mut looped = Loop::<T>::new(growth, layer);
    let mut learned = None;
    for k in 0..400_u32 {
        let before = looped.rule.alpha();
        let (s, alpha) = looped.step(T::one(), dt);
        let fall = real::<T>(growth * layer) * dt;
        if s.abs() <= ulps(4.0) {
            learned.get_or_insert(k);
            assert_abs_diff_eq!(alpha, (before - fall).max(real(FLOOR)), epsilon = ulps(64.0));
        } else {
            assert!(learned.is_none(), "{k}: {s}");
        }
    }
    assert!(learned.is_some());
    assert_eq!(looped.rule.alpha(), real(FLOOR));
}

/// B = 5 > α_max = 2: s goes on by (α_max − B)·h a sample.
fn at_the_ceiling_it_is_the_rule_with_that_rate<T: Scalar>() {
    let mut looped = Loop::<T>::new(100.0, 0.1);
    looped.rule = looped.rule.with_ceiling(real(2.0)).unwrap();
    let (mut delta, mut last, dt) = (T::zero(), T::zero(), real::<T>(0.01));
    for k in 0..1000 {
        delta += dt * real(5.0);
        let (s, alpha) = looped.step(delta, dt);
        assert!(alpha <= real(2.0));
        if k > 100 {
            assert_eq!(alpha, real(2.0));
            // u_n and Δ stay below 64.
            assert_abs_diff_eq!(s - last, real(-0.03), epsilon = ulps(64.0 * 16.0));
        }
        last = s;
    }
}

fn a_parameter_out_of_range_is_refused<T: Scalar>() {
    let rule = SlidingMode::new(T::one()).unwrap();
    let adaptive =
        |growth: f64, layer: f64| AdaptiveSlidingMode::new(rule, real(growth), real(layer));
    let good = adaptive(1.0, 1.0).unwrap();
    for bad in [0.0, -1.0] {
        let refused = |name| Error::NotPositive { name, value: bad };
        assert_eq!(adaptive(bad, 1.0).unwrap_err(), refused("growth of alpha"));
        assert_eq!(adaptive(1.0, bad).unwrap_err(), refused("layer"));
        assert_eq!(good.with_ceiling(real(bad)).unwrap_err(), refused("ceiling of alpha"));
    }
    for bad in NOT_FINITE {
        assert!(matches!(adaptive(bad, 1.0), Err(Error::NonFinite { .. })));
        assert!(matches!(adaptive(1.0, bad), Err(Error::NonFinite { .. })));
        assert!(matches!(good.with_ceiling(real(bad)), Err(Error::NonFinite { .. })));
    }
    assert_eq!(
        good.with_ceiling(T::one()).unwrap_err(),
        Error::NotBelow { name: "alpha", value: 1.0, limit: 1.0 }
    );
}

/// Δ̇ = −B outside of the layer is a rotation of (s − ε, (α − B)/√γ) by √γ a second. From (0, (α_min − B)/√γ) it takes s through
/// ε + (B − α_min)/√γ, and after π/√γ seconds back to ε with α = 2B − α_min; in samples up to the order of h.
#[test]
fn a_ramp_of_unknown_slope_turns_rate_and_s_in_a_circle() {
    let (growth, layer, bound) = (4.0_f64, 0.5, 6.0);
    let omega = growth.sqrt();
    let found = |dt: f64| {
        let mut looped = Loop::<f64>::new(growth, layer);
        // s starts at the edge, with α_min.
        let (mut delta, mut k, mut largest) = (-layer, 0, 0.0_f64);
        loop {
            let (s, alpha) = looped.step(delta, dt);
            largest = largest.max(s);
            if k > 10 && s <= layer {
                return [largest, f64::from(k) * dt, alpha];
            }
            delta -= bound * dt;
            k += 1;
        }
    };
    let wanted =
        [layer + (bound - FLOOR) / omega, core::f64::consts::PI / omega, 2.0 * bound - FLOOR];
    let errors = |dt: f64| {
        let found = found(dt);
        [0, 1, 2].map(|i| (found[i] - wanted[i]).abs() / wanted[i])
    };
    let (coarse, fine) = (errors(1e-2), errors(1e-3));
    for i in 0..3 {
        assert!(coarse[i] < 0.02 && fine[i] < 0.002, "{i}: {} {}", coarse[i], fine[i]);
    }
}

/// The promise: α ≤ B + m and |s| ≤ ε + m/√γ, under disturbances of every kind, B from 1 to 100, of which the rule knows nothing. √γ·h = 0.02
/// bounds what sampling adds to the energy of the rotation, and Δ moves by B·h before s tells.
#[test]
fn rate_and_s_stay_within_what_theory_promises_though_the_bound_is_not_known() {
    let (growth, layer, dt) = (100.0_f64, 0.3, 2e-3);
    for bound in [1.0, 10.0, 100.0] {
        let m = bound - FLOOR;
        let most = (layer + m / growth.sqrt()) * 1.03 + bound * dt;
        for kind in 0..4 {
            let (mut looped, mut rng) = (Loop::<f64>::new(growth, layer), rng());
            let mut delta = 0.0;
            for k in 0..50_000_u32 {
                let (s, alpha) = looped.step(delta, dt);
                assert!((FLOOR..=(bound + m) * 1.03).contains(&alpha), "{bound}, {kind}: {alpha}");
                assert!(s.abs() <= most, "{bound}, {kind}: {s}");
                let rate = match kind {
                    0 => (3.0 * f64::from(k) * dt).sin(),
                    1 => -s.signum(),
                    2 => f64::from(k / 5000 % 2) * 2.0 - 1.0,
                    _ => rng.random_range(-1.0..1.0),
                };
                delta += bound * rate * dt;
            }
        }
    }
}
