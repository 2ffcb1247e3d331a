//! Only plants can be simulated.
use brunovsky::{plant::IntegratorChain, prelude::*};

struct Stone;

fn main() {
    let gains = Gains::<f64, 2>::from_lambda(1.0).unwrap();
    let flc = FeedbackLinearization::new(IntegratorChain::<f64, 2>::new(), gains);
    let _ = Simulation::new(&Stone, flc, |_t| Reference::setpoint(0.0), [0.0, 0.0], 0.01);
}
