use super::AdaptationRule;
use crate::{
    Error, Scalar,
    error::{not_negative, positive},
    fuzzy::Network,
};

/// Gradient descent on ½·s² over the consequents: ḟ_r = η·s·w̃_r − σ·f_r within |f_r| ≤ F, by the Euler method.
///
/// As s = −(u_n + Δ), −∂(½s²)/∂f_r = s·w̃_r. Alone, with σ = 0 and no F, the output follows u̇_n = η·w̃ᵀw̃·s: a first-order lag with time constant
/// 1/(η·w̃ᵀw̃), at least 1/η, where the sliding-mode rule arrives in finite time. Stable while η·dt·w̃ᵀw̃ < 2; as w̃ᵀw̃ ≤ 1,
/// η·dt < 2 suffices.
///
/// | with | step of a period h | what for | price |
/// |---|---|---|---|
/// | [`with_leakage`](Self::with_leakage), the σ-modification | f⁺ = (f + ηh·s·w̃)/(1 + σh) | noise and a Δ that no f fits make the f_r drift; with it they stay below η·max\|s\|/σ | s does not go to 0: it rests at −Δ/(1 + η·w̃ᵀw̃/σ) |
/// | [`with_projection`](Self::with_projection) | the nearest to f⁺ with \|f_r\| ≤ F | \|u_n\| ≤ F at every e, not only where it was learned | what lies beyond F is left to the feedback |
///
/// [`Bounded`](super::Bounded) limits u_n instead, at the input that there is. The leakage is a backward Euler step, stable for every σh.
///
/// # References
/// B. Widrow, M. E. Hoff, "Adaptive switching circuits", IRE WESCON Convention Record, 1960 (the least-mean-squares rule).
/// P. A. Ioannou, J. Sun, "Robust Adaptive Control", Prentice Hall, 1996, chapter 8 (leakage, projection).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GradientDescent<T> {
    rate: T,
    leakage: T,
    bound: Option<T>,
}

impl<T: Scalar> GradientDescent<T> {
    /// Gradient descent with learning rate η > 0 in 1/s.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(rate: T) -> Result<Self, Error> {
        Ok(Self { rate: positive("learning rate", rate)?, leakage: T::zero(), bound: None })
    }

    /// The same rule that forgets with `leakage` σ ≥ 0 in 1/s.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn with_leakage(self, leakage: T) -> Result<Self, Error> {
        Ok(Self { leakage: not_negative("leakage", leakage)?, ..self })
    }

    /// The same rule with every |f_r| ≤ `bound` = F > 0, in the units of u_n.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_projection(self, bound: T) -> Result<Self, Error> {
        Ok(Self { bound: Some(positive("bound of the consequents", bound)?), ..self })
    }

    fn projected(&self, f: T) -> T {
        self.bound.map_or(f, |bound| f.max(-bound).min(bound))
    }
}

impl<T: Scalar, W: Network<Scalar = T>> AdaptationRule<W> for GradientDescent<T> {
    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: T, dt: T) {
        let rate = self.rate * s * dt;
        network.move_consequents(firing, rate);
        if self.leakage.is_zero() && self.bound.is_none() {
            return;
        }
        let kept = (T::one() + self.leakage * dt).recip();
        network.change_consequents(|consequents| {
            for f in consequents {
                *f = self.projected(*f * kept);
            }
        });
    }
}

checked! {
    [T: Scalar] GradientDescent<T>, [T] { rate: T, leakage: T, bound: Option<T> } =>
    Self::new(rate).and_then(|rule| rule.with_leakage(leakage)).and_then(|rule| match bound {
        Some(bound) => rule.with_projection(bound),
        None => Ok(rule),
    })
}
