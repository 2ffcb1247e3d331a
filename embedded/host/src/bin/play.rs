//! Plays both recordings in the folder named on the command line, and prints what the controllers make of them, bit by bit.

use std::{env, fs, io::Write, path::Path};

use anyhow::Context;
use replay::{Robot, Study, ThirdOrderLoop};

fn play<S: Study>(recording: &Path) -> anyhow::Result<()> {
    let mut out = Vec::new();
    replay::play::<S>(&fs::read(recording)?, |line| out.extend_from_slice(line))?;
    std::io::stdout().write_all(&out)?;
    Ok(())
}

fn main() -> anyhow::Result<()> {
    let folder = env::args().nth(1).context("name the folder of the recordings")?;
    play::<ThirdOrderLoop>(&Path::new(&folder).join("third_order"))?;
    play::<Robot>(&Path::new(&folder).join("robot"))
}
