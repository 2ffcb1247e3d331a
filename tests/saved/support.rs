use std::fmt::Debug;

use brunovsky::{
    Scalar,
    controller::{Controller, Measurement, Reference},
};
use serde::{Serialize, de::DeserializeOwned};
use serde_json::Value;

/// A scalar that can be saved.
pub trait Number: Scalar + Serialize + DeserializeOwned {}

impl<T: Scalar + Serialize + DeserializeOwned> Number for T {}

pub fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// What is written and read again, as text and as bytes.
pub fn reloaded<S: Serialize + DeserializeOwned>(saved: &S) -> [S; 2] {
    let text = serde_json::to_string(saved).unwrap();
    let bytes = postcard::to_stdvec(saved).unwrap();
    [serde_json::from_str(&text).unwrap(), postcard::from_bytes(&bytes).unwrap()]
}

/// Checks that `saved` is read as it was written.
pub fn comes_back<S: Serialize + DeserializeOwned + PartialEq + Debug>(saved: &S) {
    for read in reloaded(saved) {
        assert_eq!(&read, saved);
        // Equality does not see the sign of a zero; the text does.
        assert_eq!(format!("{read:?}"), format!("{saved:?}"));
    }
}

/// Why `saved` with `value` at the place `pointer` is not loaded.
pub fn refusal<S: Serialize + DeserializeOwned>(saved: &S, pointer: &str, value: Value) -> String {
    let mut file = serde_json::to_value(saved).unwrap();
    assert!(serde_json::from_value::<S>(file.clone()).is_ok());
    *file.pointer_mut(pointer).unwrap_or_else(|| panic!("no {pointer}")) = value;
    match serde_json::from_value::<S>(file) {
        Ok(_) => panic!("{pointer} was loaded"),
        Err(error) => error.to_string(),
    }
}

/// A loop's signals at sample `k`: nothing that a plant would do, but all that a controller sees is there and moves.
pub fn measured<T: Scalar, const NX: usize, const NU: usize>(k: u32) -> Measurement<T, NX, NU> {
    let wave = |i: usize, phase: f64| num(1.5 + (0.13 * f64::from(k) + i as f64 + phase).sin());
    let x: [T; NX] = core::array::from_fn(|i| wave(i, 0.0));
    let x_dot: [T; NX] = core::array::from_fn(|i| wave(i, 1.0));
    let measurement = Measurement::new(x);
    // The sensor of ẋ drops out at times.
    if k % 5 < 3 { measurement.with_rate(x_dot) } else { measurement }
}

/// A reference that moves.
pub fn reference<T: Scalar, const N: usize>(k: u32, phase: f64) -> Reference<T, N> {
    let t = 0.05 * f64::from(k) + phase;
    let r: [T; N] = core::array::from_fn(|i| num(t.sin() * 0.7_f64.powi(i as i32) + 0.2));
    Reference::new(r, num(t.cos()))
}

/// Lets `controller` work, saves it at several moments, and compares what it and the loaded ones decide from there on.
pub fn goes_on<C, T, const NX: usize, const NU: usize>(
    mut controller: C,
    reference: impl Fn(u32) -> C::Reference,
) where
    T: Number,
    C: Controller<NX, NU, Scalar = T> + Serialize + DeserializeOwned + PartialEq + Debug,
    C::Command: Debug,
{
    let step = |controller: &mut C, k| {
        format!("{:?}", controller.update(&measured(k), &reference(k), num(0.02)).unwrap())
    };
    let mut loaded = Vec::new();
    for k in 0..80 {
        if [0, 1, 2, 40].contains(&k) {
            comes_back(&controller);
            loaded.extend(reloaded(&controller));
        }
        let command = step(&mut controller, k);
        for loaded in &mut loaded {
            assert_eq!(step(loaded, k), command, "at sample {k}");
        }
    }
    // The state after construction is saved too.
    controller.reset();
    for mut loaded in loaded {
        loaded.reset();
        assert_eq!(format!("{loaded:?}"), format!("{controller:?}"));
    }
}
