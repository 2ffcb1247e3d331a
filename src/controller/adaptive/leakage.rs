use crate::{Error, Scalar, error::positive};

/// What pulls the parameters of a [`ModelReferenceAdaptive`](super::ModelReferenceAdaptive) back to where they started.
///
/// Without it, noise and whatever is not of the form θᵀφ(x) move the parameters for ever where the regressor does not hold them (parameter
/// drift). Leakage bounds them and costs a steady error, a [`Projection`](super::Projection) does not.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub enum Leakage<T> {
    /// Nothing does.
    #[default]
    None,
    /// σ-modification: θ̂̇ = … − γ·σ·(θ̂ − θ̂(0)).
    ///
    /// P. A. Ioannou, P. V. Kokotović, "Instability analysis and improvement of robustness of adaptive control", *Automatica* 20(5), 1984.
    Sigma {
        /// σ > 0; γ·σ in 1/s is the rate of forgetting.
        sigma: T,
    },
    /// e-modification: θ̂̇ = … − γ·σ·|s|·(θ̂ − θ̂(0)), which fades with the error.
    ///
    /// K. S. Narendra, A. M. Annaswamy, "A new adaptive law for robust adaptation without persistent excitation", *IEEE Transactions on Automatic
    /// Control* 32(2), 1987.
    Error {
        /// σ > 0.
        sigma: T,
    },
}

impl<T: Scalar> Leakage<T> {
    pub(super) fn validated(self) -> Result<Self, Error> {
        match self {
            Self::None => {}
            Self::Sigma { sigma } | Self::Error { sigma } => {
                positive("sigma", sigma)?;
            }
        }
        Ok(self)
    }

    /// σ, or σ·|s|.
    pub(super) fn rate(&self, s: T) -> T {
        match *self {
            Self::None => T::zero(),
            Self::Sigma { sigma } => sigma,
            Self::Error { sigma } => sigma * s.abs(),
        }
    }
}
