//! Times are multiples of dt to the last bit, and `until` counts them.

use brunovsky::{Scalar, integrators::Euler, plant::IntegratorChain, simulation::Simulation};
use nalgebra::SVector;
use proptest::prelude::*;

use super::{Scripted, idle};
use crate::{at_f32_and_f64, num};

const CHAIN: IntegratorChain<f64, 1> = IntegratorChain::new();

/// k·dt is one product, where a sum of a million terms would be off by thousands of roundings.
fn times_are_products<T: Scalar>() {
    let chain = IntegratorChain::<T, 1>::new();
    let dt = num::<T>(0.01);
    let simulation = Simulation::new(&chain, idle(), |t| t, [T::zero()], dt).unwrap();
    let mut samples = simulation.integrator(Euler).substeps(1).unwrap().zip(0_u64..);
    let (mut sum, mut last) = (T::zero(), T::zero());
    for (sample, k) in samples.by_ref().take(1_000_001) {
        let sample = sample.unwrap();
        assert_eq!((sample.k, sample.t), (k, num::<T>(k as f64) * dt));
        last = sample.t;
        sum += dt;
    }
    assert_eq!(last, num::<T>(1e6) * dt);
    assert_ne!(sum - dt, last, "the oracle tells the two apart");
}

/// How many samples `until` leaves.
fn count<T: Scalar>(dt: T, t_end: T) -> usize {
    let chain = IntegratorChain::<T, 1>::new();
    let simulation = Simulation::new(&chain, idle(), |t| t, [T::zero()], dt).unwrap();
    let simulation = simulation.integrator(Euler).substeps(1).unwrap();
    simulation.until(t_end).unwrap().count()
}

/// Quotients that are whole numbers in decimal and not in binary: 0.3/0.1 is 2.9999999999999996.
fn counts_awkward_quotients<T: Scalar>() {
    let cases = [
        (0.1, 0.3, 4),
        (0.1, 0.7, 8),
        (0.1, 1.0, 11),
        (0.1, 100.0, 1001),
        (0.01, 20.0, 2001),
        (0.02, 0.06, 4),
        (0.2, 180.0, 901),
        (0.001, 5.0, 5001),
        (0.1, 0.0, 1),
        (0.1, 0.05, 1),
        (0.1, 0.0999, 1),
        (0.1, 0.1001, 2),
        (0.1, 0.25, 3),
        (3.0, 1.0, 1),
    ];
    for (dt, t_end, samples) in cases {
        assert_eq!(count::<T>(num(dt), num(t_end)), samples, "{t_end}/{dt}");
    }
}

/// For every k: up to k·dt as computed, and up to half a period more, there are k + 1 samples.
fn counts_multiples<T: Scalar>(dt: f64, k: u32) {
    let dt = num::<T>(dt);
    let t_end = num::<T>(f64::from(k)) * dt;
    assert_eq!(count(dt, t_end), k as usize + 1);
    assert_eq!(count(dt, t_end + dt * num(0.5)), k as usize + 1);
}

proptest! {
    #[test]
    fn multiples_of_the_period_are_reached(dt in 1e-4..10.0_f64, k in 0..5000_u32) {
        counts_multiples::<f32>(dt, k);
        counts_multiples::<f64>(dt, k);
    }

    #[test]
    fn step_by_step_it_is_the_same_run(inputs in prop::collection::vec(-5.0..5.0_f64, 20), taken in 0..10_usize) {
        let script = |k: usize| SVector::from([inputs[k]]);
        let start = || Simulation::new(&CHAIN, Scripted::new(script), |t| t, [1.0], 0.1).unwrap();
        let whole: Vec<_> = start().until(1.5).unwrap().collect();
        prop_assert_eq!(whole.len(), 16);
        let mut stepped = start();
        let singly: Vec<_> = (0..16).map(|_| stepped.next().unwrap()).collect();
        prop_assert_eq!(&singly, &whole);
        // `until` ends at the time, however many samples are already gone.
        let mut resumed = start();
        let mut parts: Vec<_> = resumed.by_ref().take(taken).collect();
        parts.extend(resumed.until(1.5).unwrap());
        prop_assert_eq!(&parts, &whole);
    }
}

at_f32_and_f64! {
    the_time_of_a_sample_is_a_product_and_not_a_sum => times_are_products,
    quotients_that_are_whole_but_for_their_rounding_count_as_whole => counts_awkward_quotients,
}

#[test]
fn a_time_that_has_passed_leaves_nothing() {
    let mut simulation = Simulation::new(&CHAIN, idle(), |t| t, [0.0], 0.1).unwrap();
    assert_eq!(simulation.by_ref().take(8).count(), 8);
    assert_eq!(simulation.clone().until(0.3).unwrap().count(), 0);
    assert_eq!(simulation.clone().until(0.7).unwrap().count(), 0);
    assert_eq!(simulation.until(0.8).unwrap().count(), 1);
}

/// The scalar may be a dual number, which has no whole part.
#[test]
fn dual_numbers_are_counted_too() {
    use num_dual::Dual64;
    assert_eq!(count(Dual64::new(0.1, 1.0), Dual64::from(0.3)), 4);
}
