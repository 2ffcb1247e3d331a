//! A general plant is no model for feedback linearization.
use brunovsky::prelude::*;

struct General;

impl Plant<2, 1> for General {
    type Scalar = f64;
    fn derivative(&self, _t: f64, x: &SVector<f64, 2>, _u: &SVector<f64, 1>) -> SVector<f64, 2> {
        *x
    }
}

fn main() {
    let gains = Gains::<f64, 2>::from_lambda(1.0).unwrap();
    let _ = FeedbackLinearization::new(General, gains);
}
