//! Gains from values, λ and poles.

use brunovsky::controller::Gains;
use nalgebra::{Complex, SVector};

use super::{Bytes, Float, attack, numbers::Numbers};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    match bytes.byte() % 6 {
        0 => of_order::<T, 1>(bytes),
        1 => of_order::<T, 2>(bytes),
        2 => of_order::<T, 3>(bytes),
        3 => of_order::<T, 4>(bytes),
        4 => of_order::<T, 5>(bytes),
        _ => of_order::<T, 8>(bytes),
    }
}

fn of_order<T: Float, const N: usize>(bytes: &mut Bytes) {
    let gains = match bytes.byte() % 4 {
        0 => Gains::new(bytes.parameters::<T, N>()),
        1 => Gains::from_lambda(bytes.parameter()),
        2 => Gains::from_poles(bytes.parameters::<T, N>().map(|pole| -pole)),
        _ => {
            // Every other pole may be the conjugate of the one before it.
            let mut poles = [0; N].map(|_| Complex::new(-bytes.parameter::<T>(), bytes.number()));
            for i in 1..N {
                if bytes.odd() {
                    poles[i] = poles[i - 1].conj();
                }
            }
            Gains::from_poles(poles)
        }
    };
    let Ok(gains) = gains else { return };
    assert!(gains.as_vector().are_finite());
    // Necessary for the roots to lie on the left.
    assert!(gains.as_vector().iter().all(|k| *k > T::zero()));
    let e: SVector<T, N> = bytes.vector();
    let _ = gains.feedback(&e);
}
