//! A program with a path to a panic, which must not link: the proof that the proof can fail.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use firmware::{exit, recordings};

#[entry]
fn main() -> ! {
    let place = core::hint::black_box(usize::MAX);
    exit(if recordings::ROBOT[place] == 0 { Ok(()) } else { Err(()) })
}
