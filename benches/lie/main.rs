//! The linearizing law by differentiation, beside the expressions that are derived by hand.
//!
//! The figure to read is the ratio of the two in one run; times alone say more about the machine. The last group has no counterpart: it shows how the
//! time grows with the order.

#[path = "../../tests/common/smooth_plants.rs"]
#[allow(dead_code)]
mod smooth_plants;

mod cascade;
mod textbook;

use std::hint::black_box;

use brunovsky::{
    Scalar,
    plant::{Along, Decouplable, Flow, Linearization, Link, SmoothPlant, TwoLinkArm},
    prelude::*,
};
use cascade::Cascade;
use criterion::{Criterion, criterion_group, criterion_main};
use smooth_plants::{Arm, FlexibleJoint};

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
fn by_hand<T: Scalar>(joint: &FlexibleJoint<T>, x: &SVector<T, 4>) -> Linearization<T, 4, 1> {
    textbook::linearization(joint, x)
}

#[inline(never)]
fn law<T: Scalar, P, const NX: usize, const N: usize, const M: usize>(
    plant: &P,
    x: &SVector<T, NX>,
) -> Result<Linearization<T, N, M>, Error>
where
    P: Decouplable<NX, N, M, Scalar = T>,
{
    plant.linearization(x)
}

/// Two implementations are worth comparing only if they compute the same.
fn assert_same<T: Scalar, const N: usize, const M: usize>(
    ours: &Linearization<T, N, M>,
    hand: &Linearization<T, N, M>,
) {
    let close = |ours: &[T], hand: &[T]| {
        let scale = hand.iter().fold(T::one(), |scale, entry| scale.max(entry.abs()));
        let off = ours.iter().zip(hand).fold(T::zero(), |off, (a, b)| off.max((*a - *b).abs()));
        assert!(off <= scale * T::default_epsilon() * real(1e3), "{ours:?} is not {hand:?}");
    };
    for (ours, hand) in ours.chains.iter().zip(&hand.chains) {
        close(ours.as_slice(), hand.as_slice());
    }
    close(ours.drift.as_slice(), hand.drift.as_slice());
    close(ours.matrix.as_slice(), hand.matrix.as_slice());
}

fn flexible_joint<T: Scalar>(criterion: &mut Criterion, precision: &str) -> Result<(), Error> {
    let [link, motor, weight, stiffness] = [1.2, 0.3, 9.0, 100.0].map(real::<T>);
    let joint = FlexibleJoint { link, motor, weight, stiffness };
    let plant = joint.linearized::<4>([real(0.1); 4])?;
    for x in states::<T, 4>() {
        assert_same(&law(&plant, &x)?, &by_hand(&joint, &x));
    }
    time(criterion, &format!("flexible joint, {precision}/by hand"), |x| by_hand(&joint, x));
    time(criterion, &format!("flexible joint, {precision}/differentiated"), |x| law(&plant, x));
    Ok(())
}

fn arm(criterion: &mut Criterion) -> Result<(), Error> {
    let links = [[2.0, 0.35, 0.15, 0.02], [1.5, 0.3, 0.2, 0.015]];
    let friction = [0.1, 0.2];
    let [first, second] =
        links.map(|[mass, length, centre, inertia]| Link { mass, length, centre, inertia });
    let written = TwoLinkArm::new([first, second], friction, 9.81)?;
    let derived = Arm { links, friction, gravity: 9.81, payload: 0.0 }.linearized::<2>([0.1; 4])?;
    for x in states::<f64, 4>() {
        assert_same(&law(&derived, &x)?, &law(&written, &x)?);
    }
    time(criterion, "two-link arm/by hand", |x| law(&written, x));
    time(criterion, "two-link arm/differentiated", |x| law(&derived, x));
    Ok(())
}

fn cascade<const N: usize>(criterion: &mut Criterion) -> Result<(), Error>
where
    Along: Flow<N>,
{
    let plant = Cascade::<N>.linearized::<N>([0.1; 6])?;
    time(criterion, &format!("cascade of order 6, relative degree {N}/differentiated"), |x| {
        law(&plant, x)
    });
    Ok(())
}

fn all(criterion: &mut Criterion) {
    let outcome = flexible_joint::<f64>(criterion, "f64")
        .and_then(|()| flexible_joint::<f32>(criterion, "f32"))
        .and_then(|()| arm(criterion))
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
