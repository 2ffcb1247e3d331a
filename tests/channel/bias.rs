use brunovsky::{
    Error,
    channel::{Bias, Channel},
    nalgebra::SVector,
};

use super::arrived;

#[test]
fn the_bias_is_added() {
    let bias = Bias::new([0.5, -2.0]).unwrap();
    assert_eq!(arrived::<f64, _, 2>(&bias, [1.0, 2.0]), SVector::from([1.5, 0.0]));
}

#[test]
fn a_sum_beyond_the_range_is_refused() {
    let refused = Bias::new([f64::MAX]).unwrap().passed(&SVector::from([f64::MAX]), 1.0);
    assert!(matches!(
        refused.unwrap_err(),
        Error::NonFiniteEntry { name: "signal + bias", index: 0, .. }
    ));
}
