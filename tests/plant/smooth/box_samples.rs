//! The samples of a box: inside it, the same every time, and even.

use brunovsky::{Error, Scalar, plant::BoxSamples};

use crate::{at_f32_and_f64, support::num};

/// A quarter of the states lies in each half of each half; a Kronecker sequence is off by O(log n)/n, not by 1/√n.
fn fills_the_box_evenly<T: Scalar>() {
    let (low, high) = ([-1.0, 2.0, -5.0].map(num::<T>), [1.0, 3.0, 5.0].map(num::<T>));
    let samples = BoxSamples::new(low, high).unwrap();
    let mut counts = [[0_u32; 8]; 3];
    for x in samples.take(4000) {
        for i in 0..3 {
            assert!(low[i] <= x[i] && x[i] <= high[i]);
            let eighth = ((x[i] - low[i]) / (high[i] - low[i]) * num(8.0)).floor();
            counts[i][nalgebra::try_convert::<T, f64>(eighth).unwrap() as usize] += 1;
        }
    }
    for count in counts.as_flattened() {
        assert!(count.abs_diff(500) <= 12, "{count}");
    }
    assert!(samples.take(50).eq(samples.take(50)));
}

#[test]
fn pairs_of_coordinates_are_even_too() {
    let mut counts = [[0_u32; 4]; 4];
    for x in BoxSamples::new([0.0_f64; 2], [4.0; 2]).unwrap().take(3200) {
        counts[x[0] as usize][x[1] as usize] += 1;
    }
    for count in counts.as_flattened() {
        assert!(count.abs_diff(200) <= 15, "{count}");
    }
}

#[test]
fn a_corner_must_be_finite() {
    let error = BoxSamples::new([0.0, f64::NAN], [1.0; 2]).unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "low", index: 1, .. }));
    let error = BoxSamples::new([-f64::MAX, 0.0], [f64::MAX, 1.0]).unwrap_err();
    assert!(matches!(error, Error::NonFiniteEntry { name: "high - low", index: 0, .. }));
}

at_f32_and_f64! {
    samples_fill_the_box_evenly => fills_the_box_evenly,
}
