//! The Duffing oscillator against its energy, its wells, and its period from the arithmetic-geometric mean.

use brunovsky::{
    Scalar,
    plant::{Duffing, Plant, SmoothPlant},
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{Refusals, assert_equal_to_rounding, flow, num, power},
};

/// With ω² = α + β·A² and m = β·A²/(2ω²), x = A·cn(ωt, m): the period is T = 2π/(ω·AGM(1, √(1 − m))).
fn period([alpha, beta]: [f64; 2], amplitude: f64) -> f64 {
    let omega = (alpha + beta * amplitude * amplitude).sqrt();
    let m = beta * amplitude * amplitude / (2.0 * omega * omega);
    let (mut a, mut g) = (1.0, (1.0 - m).sqrt());
    // The mean converges quadratically.
    for _ in 0..6 {
        (a, g) = ((a + g) / 2.0, f64::sqrt(a * g));
    }
    core::f64::consts::TAU / (omega * a)
}

/// After half a period at −A, after a whole one at A; for springs that harden and that soften, and for swings across two wells.
fn swings_with_the_period_of_the_elliptic_cosine<T: Scalar>() {
    for (spring, amplitude) in [([1.0, 0.7], 1.5), ([1.0, -0.3], 1.2), ([-1.0, 1.0], 2.0)] {
        let [alpha, beta] = spring.map(num::<T>);
        let plant = Duffing::new(T::zero(), alpha, beta).unwrap();
        let t = period(spring, amplitude);
        for (part, end) in [(0.5, -amplitude), (1.0, amplitude)] {
            let start = [num::<T>(amplitude), T::zero()];
            let found = flow(&plant, start, [T::zero()], num(part * t), 8000);
            // Rk4 leaves (ωh)⁴/120 of a swing; 8000 steps round, and so does the period.
            assert_equal_to_rounding(&found, &SVector::from([num::<T>(end), T::zero()]), 2e4);
        }
    }
}

/// In its wells at ±√(−α/β), and between them.
fn rests_in_its_wells<T: Scalar>() {
    let plant = Duffing::new(num(0.3), num::<T>(-4.0), num(1.0)).unwrap();
    for x in [-2.0, 0.0, 2.0] {
        let rest = SVector::from([num::<T>(x), T::zero()]);
        let rate = plant.derivative(T::zero(), &rest, &SVector::zeros());
        assert_eq!(rate, SVector::<T, 2>::zeros());
    }
    // Unstable between the wells, with −α = λ² + d·λ; stable in them, with the stiffness −2α.
    let slope = |x: f64| plant.jacobians([num::<T>(x), T::zero()], [T::zero()]).unwrap().a[(1, 0)];
    assert_eq!((slope(0.0), slope(2.0)), (num(4.0), num(-8.0)));
}

at_f32_and_f64! {
    it_swings_with_the_period_of_the_elliptic_cosine => swings_with_the_period_of_the_elliptic_cosine,
    it_rests_in_its_wells_and_between_them => rests_in_its_wells,
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_energy_changes_by_the_power_of_the_input_and_of_the_damping(
        damping in 0.0..2.0_f64, spring in prop::array::uniform2(-3.0..3.0_f64),
        x in prop::array::uniform2(-3.0..3.0_f64), u in -5.0..5.0_f64,
    ) {
        let x = SVector::from(x);
        let plant = Duffing::new(damping, spring[0], spring[1]).unwrap();
        let dual = Duffing::new(num(damping), num(spring[0]), num(spring[1])).unwrap();
        let found = power(|x| dual.energy(x), &x, &plant.derivative(0.0, &x, &[u].into()));
        let expected = (u - damping * x[1]) * x[1];
        // β·x³·ẋ ≤ 3·27·3 cancels.
        prop_assert!((found - expected).abs() <= 16.0 * f64::EPSILON * 300.0, "{found} {expected}");
    }

    #[test]
    fn mirroring_the_state_and_the_input_mirrors_the_motion(
        x in prop::array::uniform2(-4.0..4.0_f64), u in -5.0..5.0_f64,
    ) {
        let plant = Duffing::new(0.2, -1.0, 0.8).unwrap();
        let (x, u) = (SVector::from(x), SVector::from([u]));
        // Changing signs is exact in floating point, and the law is odd term by term.
        prop_assert_eq!(plant.derivative(0.0, &-x, &-u), -plant.derivative(0.0, &x, &u));
    }
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    Refusals(&[("damping", |v| Duffing::new(v, 1.0, 1.0))]).none_is_negative();
    Refusals(&[
        ("linear", |v| Duffing::new(0.1, v, 1.0)),
        ("cubic", |v| Duffing::new(0.1, 1.0, v)),
    ])
    .all_are_finite();
    assert!(Duffing::new(0.0, -1.0, -1.0).is_ok());
}
