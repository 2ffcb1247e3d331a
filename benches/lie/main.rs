//! The linearizing law by differentiation, beside the expressions that are derived by hand.
//!
//! The figure to read is the ratio of the two in one run; times alone say more about the machine. The last group has no counterpart: it shows how the
//! time grows with the order.

mod cascade;
mod flexible_joint;

use std::hint::black_box;

use brunovsky::{
    Scalar,
    plant::{Along, Decouplable, Flow, Linearization, SmoothPlant},
    prelude::*,
};
use cascade::Cascade;
use criterion::{Criterion, criterion_group, criterion_main};
use flexible_joint::FlexibleJoint;

fn real<T: Scalar>(value: f64) -> T {
    brunovsky::nalgebra::convert(value)
}

/// States along a smooth path.
fn states<T: Scalar, const N: usize>() -> Vec<SVector<T, N>> {
    let state = |k: usize| SVector::from_fn(|i, _| real(0.4 + (0.02 * k as f64 + i as f64).sin()));
    (0..256).map(state).collect()
}

/// A function of the state, over and over.
fn time<T: Scalar, R, const N: usize>(
    criterion: &mut Criterion,
    name: &str,
    law: impl Fn(&SVector<T, N>) -> R,
) {
    let states = states::<T, N>();
    let mut k = 0;
    criterion.bench_function(name, |bencher| {
        bencher.iter(|| {
            k = (k + 1) % states.len();
            law(black_box(&states[k]))
        });
    });
}

#[inline(never)]
fn derived<T: Scalar>(joint: &FlexibleJoint<T>, x: &SVector<T, 4>) -> Linearization<T, 4, 1> {
    joint.by_hand(x)
}

#[inline(never)]
fn differentiated<T: Scalar, P, const NX: usize, const N: usize, const M: usize>(
    plant: &P,
    x: &SVector<T, NX>,
) -> Result<Linearization<T, N, M>, Error>
where
    P: Decouplable<NX, N, M, Scalar = T>,
{
    plant.linearization(x)
}

fn flexible_joint<T: Scalar>(criterion: &mut Criterion, precision: &str) -> Result<(), Error> {
    let joint = FlexibleJoint::new([1.2, 0.3, 9.0, 100.0].map(real::<T>));
    let plant = joint.linearized::<4>([real(0.1); 4])?;
    // Two implementations are worth comparing only if they compute the same.
    for x in states::<T, 4>() {
        let (ours, hand) = (differentiated(&plant, &x)?, derived(&joint, &x));
        let scale = real::<T>(1e5);
        assert!((ours.drift - hand.drift).amax() <= scale * T::default_epsilon() * real(10.0));
        assert!((ours.chains[0] - hand.chains[0]).amax() <= scale * T::default_epsilon());
        assert!((ours.matrix - hand.matrix).amax() <= scale * T::default_epsilon());
    }
    time(criterion, &format!("flexible joint, {precision}/by hand"), |x| derived(&joint, x));
    time(criterion, &format!("flexible joint, {precision}/differentiated"), |x| {
        differentiated(&plant, x)
    });
    Ok(())
}

fn cascade<const N: usize>(criterion: &mut Criterion) -> Result<(), Error>
where
    Along: Flow<N>,
{
    let plant = Cascade::<N>.linearized::<N>([0.1; 6])?;
    time(criterion, &format!("cascade of order 6, relative degree {N}/differentiated"), |x| {
        differentiated(&plant, x)
    });
    Ok(())
}

fn all(criterion: &mut Criterion) {
    let outcome = flexible_joint::<f64>(criterion, "f64")
        .and_then(|()| flexible_joint::<f32>(criterion, "f32"))
        .and_then(|()| cascade::<1>(criterion))
        .and_then(|()| cascade::<2>(criterion))
        .and_then(|()| cascade::<3>(criterion))
        .and_then(|()| cascade::<4>(criterion))
        .and_then(|()| cascade::<5>(criterion))
        .and_then(|()| cascade::<6>(criterion));
    if let Err(error) = outcome {
        eprintln!("{error}");
    }
}

criterion_group!(benches, all);
criterion_main!(benches);
