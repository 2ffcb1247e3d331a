use nalgebra::SVector;

use super::{AdaptationRule, Antecedents, Certificate, Switching};
use crate::{
    Error, Scalar,
    error::positive,
    fuzzy::{Firing, FuzzyNetwork, Grid, Inputs},
};

/// The sliding-mode learning rule, which makes the network's output obey u̇_n = α·sgn(s) (eq_dotun5).
///
/// | parameter | law | equation |
/// |---|---|---|
/// | consequents | ḟ_r = w̃_r/(w̃ᵀw̃)·α·sgn(s) | eq_fr |
/// | centres | ċ = ė + (e − c)·α·sgn(s) | eq_c_ik |
/// | widths | σ̇ = −(σ + σ³/(e − c)²)·α·sgn(s) | eq_sigma_ik |
///
/// [`Switching`] says how sgn(s) is discretized, [`Antecedents`] whether centres and widths move and what happens where their law is
/// singular. If α exceeds the bound B on |Δ̇|, s reaches zero within |s(0)|/(α − B); see [`Certificate`].
///
/// ```
/// use brunovsky::learning::{Antecedents, SlidingMode, Switching};
///
/// let recommended = SlidingMode::new(25.0)?;
/// let literal = SlidingMode::new(25.0)?.with_switching(Switching::Explicit { delta: 0.05 })?;
/// let remembering = recommended.with_antecedents(Antecedents::Fixed)?;
/// assert!(literal.certificate(0.01, 5.0)?.explicit_chatters());
/// # let _ = remembering;
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingMode<T> {
    alpha: T,
    switching: Switching<T>,
    antecedents: Antecedents<T>,
}

impl<T: Scalar> SlidingMode<T> {
    /// The rule with learning rate α > 0 (in the units of ẋ_n per second), the set-valued sign and flowing antecedents.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(alpha: T) -> Result<Self, Error> {
        Ok(Self {
            alpha: positive("alpha", alpha)?,
            switching: Switching::SetValued,
            antecedents: Antecedents::flow(),
        })
    }

    /// The same rule with another discretization of the sign.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`] for a boundary layer out of range.
    pub fn with_switching(self, switching: Switching<T>) -> Result<Self, Error> {
        Ok(Self { switching: switching.validated()?, ..self })
    }

    /// The same rule with another treatment of the antecedents.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotBelow`] or [`Error::NonFinite`] for bounds that are not 0 < floor < ceiling.
    pub fn with_antecedents(self, antecedents: Antecedents<T>) -> Result<Self, Error> {
        Ok(Self { antecedents: antecedents.validated()?, ..self })
    }

    /// What theory promises of this rule at period `dt` for an uncertainty with |Δ̇| ≤ `bound`.
    ///
    /// # Errors
    /// As [`Certificate::new`].
    pub fn certificate(&self, dt: T, bound: T) -> Result<Certificate<T>, Error> {
        Certificate::new(self.alpha, self.switching, dt, bound)
    }
}

impl<T: Scalar, const I: usize, const K: usize> AdaptationRule<T, I, K> for SlidingMode<T>
where
    Inputs<I>: Grid,
{
    fn follow(&mut self, network: &mut FuzzyNetwork<T, I, K>, e: &SVector<T, I>) {
        // ċ = ė + …: between samples the centres travel exactly as far as the input did.
        if let Antecedents::Flow { floor, ceiling } = self.antecedents {
            network.carry(e, floor, ceiling);
        }
    }

    fn adapt(
        &mut self,
        network: &mut FuzzyNetwork<T, I, K>,
        firing: &Firing<T, I, K>,
        s: T,
        dt: T,
    ) {
        let reach = self.alpha * dt;
        let travel = reach * self.switching.sign(s, reach);
        network.move_consequents(firing, travel / firing.norm_squared());
        if let Antecedents::Flow { .. } = self.antecedents {
            network.flow(travel);
        }
    }
}

checked! {
    [T: Scalar] SlidingMode<T>, [T]
    { alpha: T, switching: Switching<T>, antecedents: Antecedents<T> } =>
    Self::new(alpha).and_then(|rule| rule.with_switching(switching)?.with_antecedents(antecedents))
}
