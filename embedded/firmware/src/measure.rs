//! Instructions and stack of a control step.

use brunovsky::Error;
use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};
use replay::{Study, rows};

use crate::{print_row, stack};

/// Plays a recording and prints the mean and the largest number of instructions of a step, and its bytes of stack.
pub fn measure<S: Study>(name: &str, recording: &[u8]) -> Result<(), Error> {
    let mut study = S::start()?;
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
    for row in rows::<S>(recording) {
        let mut taken = 0;
        let depth = stack::used(|| {
            taken = instructions(|| result = step(&mut study, &row)).saturating_sub(nothing);
        });
        result?;
        sum += taken;
        most = most.max(taken);
        deepest = deepest.max(depth);
        steps += 1;
    }
    print_row(name, &[sum.checked_div(steps).unwrap_or(0), most, deepest]);
    Ok(())
}

/// Out of line, as a call from an interrupt would be.
#[inline(never)]
fn step<S: Study>(study: &mut S, row: &S::Row) -> Result<(), Error> {
    core::hint::black_box(study.update(row)?);
    Ok(())
}

/// The instructions of `work`: the emulator takes 64 ns for each, and the timer ticks every 40 ns.
fn instructions(work: impl FnOnce()) -> u32 {
    let start = SYST::get_current();
    work();
    let ticks = start.wrapping_sub(SYST::get_current()) & 0x00ff_ffff;
    (ticks * 40 + 32) / 64
}
