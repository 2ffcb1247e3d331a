//! A plant of order 2 has two gains.
use brunovsky::{plant::IntegratorChain, prelude::*};

fn main() {
    let gains = Gains::<f64, 3>::from_lambda(1.0).unwrap();
    let _ = FeedbackLinearization::new(IntegratorChain::<f64, 2>::new(), gains);
}
