//! The network of a loop of order 2 has two inputs.
use brunovsky::{plant::IntegratorChain, prelude::*};

fn main() {
    let gains = Gains::from_lambda(1.0).unwrap();
    let flc = FeedbackLinearization::new(IntegratorChain::<f64, 2>::new(), gains);
    let network = FuzzyNetwork::<f64, 3, 3>::evenly_spaced([1.0; 3]).unwrap();
    let learner = NeuroFuzzy::new(network, BackwardDifference::new(), NullRule);
    let _ = Clelc::new(flc, learner);
}
