use crate::{
    Error, Scalar,
    error::{finite, not_negative},
    learning::{Certificate, Switching},
};

/// How sgn(σ) is realized.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub(super) enum Sign<T> {
    /// As the sign of the learning rules.
    Switched(Switching<T>),
    /// clamp(σ/δ, −1, 1); sgn(σ) itself for δ = 0.
    Saturated { delta: T },
}

impl<T: Scalar> Sign<T> {
    pub fn validated(self) -> Result<Self, Error> {
        match self {
            Sign::Switched(switching) => switching.validated().map(Sign::Switched),
            Sign::Saturated { delta } => not_negative("delta", delta).map(|_| self),
        }
    }

    /// ς ∈ \[−1, 1\], where `reach` = k·h > 0 is the farthest that σ can be moved.
    pub fn sign(&self, sigma: T, reach: T) -> T {
        match *self {
            Sign::Switched(switching) => switching.sign(sigma, reach),
            // The set-valued sign is the saturation with δ = k·h.
            Sign::Saturated { delta } => Switching::SetValued.sign(sigma, delta),
        }
    }

    /// What remains of |σ| at the samples where σ(k+1) = σ(k) − k·h·ς(k) − ∫Δ dt, for k > `bound` ≥ |Δ|.
    pub fn residual(&self, k: T, bound: T, dt: T) -> Result<Option<T>, Error> {
        let residual = match *self {
            Sign::Switched(switching) => Certificate::new(k, switching, dt, bound)?.residual(),
            Sign::Saturated { delta } => (k > bound).then(|| {
                // A step from within the layer ends beyond zero by no more than one from its edge.
                let overshoot = (k * dt - delta).max(T::zero());
                (delta * bound / k).max(overshoot + bound * dt)
            }),
        };
        residual.map(|residual| finite("residual", residual)).transpose()
    }
}
