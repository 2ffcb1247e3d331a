use super::AdaptationRule;
use crate::{Error, Scalar, error::positive, fuzzy::Network};

/// Gradient descent on ½·s² over the consequents: ḟ_r = η·s·w̃_r, by the explicit Euler method.
///
/// As s = −(u_n + Δ), −∂(½s²)/∂f_r = s·w̃_r. The output follows u̇_n = η·w̃ᵀw̃·s: a first-order lag with time constant
/// 1/(η·w̃ᵀw̃), at least 1/η, where the sliding-mode rule arrives in finite time. Stable while η·dt·w̃ᵀw̃ < 2; as w̃ᵀw̃ ≤ 1,
/// η·dt < 2 suffices.
///
/// # References
/// B. Widrow, M. E. Hoff, "Adaptive switching circuits", IRE WESCON Convention Record, 1960 (the least-mean-squares rule).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GradientDescent<T> {
    rate: T,
}

impl<T: Scalar> GradientDescent<T> {
    /// Gradient descent with learning rate η > 0 in 1/s.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(rate: T) -> Result<Self, Error> {
        Ok(Self { rate: positive("learning rate", rate)? })
    }
}

impl<T: Scalar, W: Network<Scalar = T>> AdaptationRule<W> for GradientDescent<T> {
    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: T, dt: T) {
        network.move_consequents(firing, self.rate * s * dt);
    }
}
