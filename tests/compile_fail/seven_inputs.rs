//! A grid of rules has at most six inputs.
use brunovsky::prelude::*;

fn main() {
    let _ = FuzzyNetwork::<f64, 7, 3>::evenly_spaced([1.0; 7]);
}
