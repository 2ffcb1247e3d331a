//! Instructions, stack and memory of a control step.

use core::hint::black_box;

use brunovsky::{Error, elementary::sin, prelude::*};
use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};
use replay::{Real, Study, rows};

use crate::{by_hand::ByHand, print_row, stack};

/// Measures `study` on its recording.
pub fn study<S: Study>(recording: &[u8]) -> Result<(), Error> {
    let mut study = S::start()?;
    measure(size_of::<S>(), rows::<S>(recording), |row| study.update(row))
}

/// Measures a step without a controller: what is left is what the others have to be compared with.
pub fn nothing() -> Result<(), Error> {
    measure(0, states::<1>(), |x| Ok(*x))
}

/// Measures `controller` at rest at 0, with a state that moves along smooth waves.
pub fn waves<C, const N: usize>(controller: C) -> Result<(), Error>
where
    C: Controller<N, 1, Scalar = Real, Reference = Reference<Real, N>>,
{
    holding(controller, Reference::setpoint(0.0))
}

/// Measures `controller` with a `reference` that rests.
pub fn holding<C, const N: usize>(mut controller: C, reference: C::Reference) -> Result<(), Error>
where
    C: Controller<N, 1, Scalar = Real>,
{
    steps(size_of::<C>(), reference, |x, r, dt| controller.update(x, r, dt))
}

/// Measures `controller` as one of those that are chosen at run time.
pub fn behind_dyn<C, const N: usize>(mut controller: C) -> Result<(), Error>
where
    C: Controller<N, 1, Scalar = Real, Reference = Reference<Real, N>> + 'static,
{
    // Without the box the compiler knows what was chosen.
    let chosen: &mut Dynamic<C, N> = black_box(&mut controller);
    steps(size_of::<C>(), Reference::setpoint(0.0), |x, r, dt| chosen.update(x, r, dt))
}

type Dynamic<C, const N: usize> = dyn Controller<
        N,
        1,
        Scalar = Real,
        Reference = Reference<Real, N>,
        Command = <C as Controller<N, 1>>::Command,
    >;

/// Measures the law that is written by hand.
pub fn by_hand(mut law: ByHand) -> Result<(), Error> {
    steps(size_of::<ByHand>(), Reference::setpoint(0.0), |x, r, dt| law.update(x, r, dt))
}

/// What a controller is given comes out of black boxes, so that no part of a step is done when the program is built.
fn steps<R, D, const N: usize>(
    size: usize,
    reference: R,
    mut step: impl FnMut(&Measurement<Real, N, 1>, &R, Real) -> Result<D, Error>,
) -> Result<(), Error> {
    let (reference, dt) = (black_box(reference), black_box(0.01));
    let measured = |x: SVector<Real, N>| black_box(Measurement::new(x).with_rate(SVector::zeros()));
    measure(size, states().map(measured), |x| step(x, &reference, dt))
}

/// Smooth waves, off every centre at the start.
fn states<const N: usize>() -> impl Iterator<Item = SVector<Real, N>> {
    let wave = |k: u16, i: usize| 0.3 + 0.5 * sin(0.02 * Real::from(k) + i as Real);
    (0..512).map(move |k| SVector::from_fn(|i, _| wave(k, i)))
}

/// Makes a step for each of the `rows` and prints, in one line: the mean and the largest number of instructions of a step, its bytes of
/// stack, and the bytes of the controller.
fn measure<R, D>(
    size: usize,
    rows: impl Iterator<Item = R>,
    mut step: impl FnMut(&R) -> Result<D, Error>,
) -> Result<(), Error> {
    let Some(peripherals) = Peripherals::take() else { return Ok(()) };
    let mut timer = peripherals.SYST;
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(0x00ff_ffff);
    timer.clear_current();
    timer.enable_counter();

    // What the measurement itself takes.
    let nothing = instructions(|| {});
    let (mut sum, mut most, mut deepest, mut steps) = (0, 0, 0, 0);
    let mut result = Ok(());
    for row in rows {
        let mut taken = 0;
        let depth = stack::used(|| {
            taken = instructions(|| result = called(&mut step, &row)).saturating_sub(nothing);
        });
        result?;
        sum += taken;
        most = most.max(taken);
        deepest = deepest.max(depth);
        steps += 1;
    }
    print_row("", &[sum.checked_div(steps).unwrap_or(0), most, deepest, size as u32]);
    Ok(())
}

/// Out of line, as a call from an interrupt would be.
#[inline(never)]
fn called<R, D>(step: &mut impl FnMut(&R) -> Result<D, Error>, row: &R) -> Result<(), Error> {
    black_box(step(row)?);
    Ok(())
}

/// The instructions of `work`: the emulator takes 64 ns for each, and the timer ticks every 40 ns.
fn instructions(work: impl FnOnce()) -> u32 {
    let start = SYST::get_current();
    work();
    let ticks = start.wrapping_sub(SYST::get_current()) & 0x00ff_ffff;
    (ticks * 40 + 32) / 64
}
