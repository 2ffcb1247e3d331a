use nalgebra::SVector;

#[cfg(feature = "serde")]
use super::remembered;
use crate::{Scalar, scalar::constant};

/// What the law remembers of a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Past<T, const N: usize, const L: usize> {
    /// The state of the reference model.
    pub model: SVector<T, N>,
    /// Its ẋ_n.
    pub rate: T,
    pub phi: SVector<T, L>,
    /// μ = u_f + u_b − a(x).
    pub mu: T,
    pub gain: T,
    pub asked: T,
}

impl<T: Scalar, const N: usize, const L: usize> Past<T, N, L> {
    /// The state of the reference model a period later, with (u_applied − u)·b/κ̂ added to its ẋ_n for what the plant did not receive.
    pub fn advanced(&self, applied: Option<T>, kappa: T, dt: T) -> SVector<T, N> {
        let missing = applied.map_or(T::zero(), |applied| applied - self.asked);
        advanced(&self.model, self.rate + self.gain * missing / kappa, dt)
    }
}

/// A chain after a period in which its last derivative is `rate`: xᵢ ← Σ_j xᵢ₊ⱼ·hʲ/j!.
pub(super) fn advanced<T: Scalar, const N: usize>(
    x: &SVector<T, N>,
    rate: T,
    h: T,
) -> SVector<T, N> {
    SVector::from_fn(|i, _| {
        // Horner's scheme, from the last derivative down.
        let last = rate * h / constant((N - i) as f64);
        let tail =
            (i + 1..N).rev().fold(last, |tail, j| (x[j] + tail) * h / constant((j - i) as f64));
        x[i] + tail
    })
}

checked! {
    [T: Scalar, const N: usize, const L: usize] Past<T, N, L>, [T]
    { model: SVector<T, N>, rate: T, phi: SVector<T, L>, mu: T, gain: T, asked: T } =>
    known("last state of the model", model.iter().copied()).and_then(|()| {
        known("last b(x) and u", [gain, asked])?;
        for phi in phi.iter() {
            remembered("phi(x)", *phi)?;
        }
        remembered("rate of the model", rate)?;
        remembered("-a(x) + nu", mu)?;
        Ok(Self { model, rate, phi, mu, gain, asked })
    })
}
