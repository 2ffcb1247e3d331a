//! The sliding-mode rule lets memberships flow, and triangles cannot.
use brunovsky::{fuzzy::TriangularNetwork, prelude::*};

fn main() {
    let network = TriangularNetwork::<f64, 2, 3>::evenly_spaced([1.0; 2]).unwrap();
    let rule = SlidingMode::new(1.0).unwrap();
    let _ = NeuroFuzzy::new(network, BackwardDifference::new(), rule);
}
