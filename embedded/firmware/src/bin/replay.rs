//! Plays both recordings and prints what the controllers make of them, bit by bit.
#![no_std]
#![no_main]

use brunovsky::Error;
use cortex_m_rt::entry;
use firmware::{exit, print, recordings};
use replay::{Robot, ThirdOrderLoop, play};

#[entry]
fn main() -> ! {
    exit(both())
}

fn both() -> Result<(), Error> {
    play::<ThirdOrderLoop>(recordings::THIRD_ORDER, print)?;
    play::<Robot>(recordings::ROBOT, print)
}
