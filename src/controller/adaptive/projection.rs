use nalgebra::SVector;

use crate::{
    Error, Scalar,
    error::{below, finite_vector, positive},
    scalar::{constant, epsilon},
};

/// The set that the parameters of a [`ModelReferenceAdaptive`](super::ModelReferenceAdaptive) stay in: the nearest point of it takes the place of
/// one outside, so they come no farther from any point inside.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(
            serialize = "T: Scalar + serde::Serialize",
            deserialize = "T: Scalar + serde::de::DeserializeOwned"
        )
    )
)]
pub enum Projection<T, const L: usize> {
    /// Everything.
    #[default]
    None,
    /// |θ̂| ≤ radius.
    Ball {
        /// The radius > 0.
        radius: T,
    },
    /// lowerᵢ ≤ θ̂ᵢ ≤ upperᵢ.
    Box {
        /// The least values.
        lower: SVector<T, L>,
        /// The greatest.
        upper: SVector<T, L>,
    },
}

impl<T: Scalar, const L: usize> Projection<T, L> {
    pub(super) fn validated(self) -> Result<Self, Error> {
        match &self {
            Self::None => {}
            Self::Ball { radius } => {
                positive("radius", *radius)?;
            }
            Self::Box { lower, upper } => {
                finite_vector("lower", lower)?;
                finite_vector("upper", upper)?;
                for (lower, upper) in lower.iter().zip(upper.iter()) {
                    below("lower", *lower, *upper)?;
                }
            }
        }
        Ok(self)
    }

    /// The nearest point to `theta`, inside to the last bit.
    pub(super) fn nearest(&self, theta: SVector<T, L>) -> SVector<T, L> {
        match self {
            Self::None => theta,
            Self::Ball { radius } => {
                // In units of the largest entry, so that no square overflows.
                let largest = theta.amax();
                let length =
                    if largest.is_zero() { largest } else { (theta / largest).norm() * largest };
                if length <= *radius {
                    return theta;
                }
                // A little short, by more than the norm of L entries is rounded.
                let short = T::one() - epsilon::<T>() * constant((L + 4) as f64);
                theta / length * (*radius * short)
            }
            Self::Box { lower, upper } => {
                SVector::from_fn(|i, _| theta[i].max(lower[i]).min(upper[i]))
            }
        }
    }
}
