//! The largest difference between two texts of what the controllers made of a recording, column by column, relative to the largest value of
//! the column; exit code 1 if one exceeds the bound given as third argument.

use std::{env, fs};

use anyhow::{Context, ensure};
use replay::{Real, SIZE};

/// The rows of a text: for each controller its own number of columns.
fn rows(file: &str) -> anyhow::Result<Vec<Vec<Real>>> {
    let number = |digits: &str| -> anyhow::Result<Real> {
        ensure!(digits.len() == 2 * SIZE, "{digits} has the wrong length for this precision");
        Ok(Real::from_bits(u64::from_str_radix(digits, 16)? as _))
    };
    let text = fs::read_to_string(file).with_context(|| file.to_owned())?;
    text.lines().map(|line| line.split_ascii_whitespace().map(number).collect()).collect()
}

fn main() -> anyhow::Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [one, other, bound] = arguments.as_slice() else {
        anyhow::bail!("name two texts and a bound");
    };
    let (one, other, bound) = (rows(one)?, rows(other)?, bound.parse::<Real>()?);
    ensure!(one.len() == other.len(), "{} rows are not {}", one.len(), other.len());
    let mut worst: Real = 0.0;
    for columns in [3, 6] {
        let pairs = || one.iter().zip(&other).filter(|(row, _)| row.len() == columns);
        for column in 0..columns {
            let largest = pairs().map(|(row, _)| row[column].abs()).fold(0.0, Real::max);
            let apart = pairs().map(|(a, b)| (a[column] - b[column]).abs()).fold(0.0, Real::max);
            worst = worst.max(apart / largest);
        }
    }
    println!("largest difference, relative to the largest value of its column: {worst:.1e}");
    ensure!(worst <= bound, "that is more than {bound:e}");
    Ok(())
}
