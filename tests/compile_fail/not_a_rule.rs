//! Switching is a part of a rule, and no rule.
use brunovsky::prelude::*;

fn main() {
    let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([1.0; 2]).unwrap();
    let _ = NeuroFuzzy::new(network, BackwardDifference::new(), Switching::<f64>::SetValued);
}
