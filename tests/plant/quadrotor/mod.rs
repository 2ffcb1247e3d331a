//! The quadrotor against rigid-body mechanics that knows no Euler angles, and in closed loop.

mod attitude;
mod space;

use core::array;

use brunovsky::{Scalar, differentiation::Smooth, plant::QuadrotorAttitude};

use crate::support::num;

/// J of a quadrotor of some 30 cm, in kg·m².
const INERTIA: [f64; 3] = [0.008, 0.011, 0.017];

fn attitude<T: Scalar>() -> QuadrotorAttitude<T> {
    QuadrotorAttitude::new(INERTIA.map(num)).unwrap()
}

/// a × b.
fn cross<S: Smooth<T>, T: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

/// J⁻¹·(−ω × J·ω).
fn gyration<S: Smooth<T>, T: Scalar>(omega: [S; 3]) -> [S; 3] {
    let momentum = array::from_fn(|i| omega[i] * num::<T>(INERTIA[i]));
    let torque = cross(omega, momentum);
    array::from_fn(|i| -torque[i] / num::<T>(INERTIA[i]))
}
