//! The controllers of both studies, driven by recorded sequences: the same code on every machine.
//!
//! A recording is a table of numbers, little-endian, one row a sample. What the controllers make of it is written in hexadecimal, bit by
//! bit, one line a sample, so that two machines agree if and only if their texts do.
#![no_std]
#![forbid(unsafe_code)]

use brunovsky::Error;

mod chain;
mod robot;
mod text;
mod third_order;

pub use chain::{Chain, chain, feedback, trained};
pub use robot::Robot;
pub use text::hexadecimal;
pub use third_order::ThirdOrderLoop;

/// The precision that the machine works in.
#[cfg(not(feature = "double"))]
pub type Real = f32;
/// The precision that the machine works in.
#[cfg(feature = "double")]
pub type Real = f64;

/// Bytes of a number.
pub const SIZE: usize = size_of::<Real>();

/// A controller with what it takes from a row of its recording and what it shows of its decision.
pub trait Study: Sized {
    /// The columns of the recording.
    type Row: AsRef<[Real]> + AsMut<[Real]> + Default + Copy;
    /// What is shown of a decision.
    type Shown: AsRef<[Real]>;

    /// The controller as the study starts.
    fn start() -> Result<Self, Error>;

    /// One sample.
    fn update(&mut self, row: &Self::Row) -> Result<Self::Shown, Error>;
}

/// The rows of a recording; what is left over at its end is no row.
pub fn rows<S: Study>(recording: &[u8]) -> impl Iterator<Item = S::Row> {
    let columns = S::Row::default().as_ref().len().max(1);
    recording.chunks_exact(columns * SIZE).map(|bytes| {
        let mut row = S::Row::default();
        for (number, bytes) in row.as_mut().iter_mut().zip(bytes.as_chunks().0) {
            *number = Real::from_le_bytes(*bytes);
        }
        row
    })
}

/// Plays a recording to the controller and gives `line` the text of every sample.
pub fn play<S: Study>(recording: &[u8], mut line: impl FnMut(&[u8])) -> Result<(), Error> {
    let mut study = S::start()?;
    for row in rows::<S>(recording) {
        hexadecimal(study.update(&row)?.as_ref(), &mut line);
    }
    Ok(())
}
