use core::ops::Deref;

use nalgebra::SVector;

use crate::{
    Error, Scalar,
    error::{finite, finite_vector},
};

/// How strongly each rule of a network fires at one input: the normalized firing strengths w̃, which are not negative and sum to 1.
pub trait Strengths<T> {
    /// One number a rule.
    type Rules: Deref<Target = [T]>;

    /// w̃ in the order of the rules.
    fn strengths(&self) -> Self::Rules;

    /// w̃ᵀw̃, between 1 over the number of rules (all fire alike) and 1 (one fires alone).
    fn norm_squared(&self) -> T;
}

/// A network that is linear in its consequents: u_n = w̃(e)ᵀf, with w̃ ≥ 0 and Σ w̃_r = 1, so that u_n lies between the least and the greatest f_r.
///
/// A rule of adaptation is written once, for every network that gives it what it needs.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a fuzzy network",
    label = "not a network that a rule can train"
)]
pub trait Network: Clone {
    /// The number type.
    type Scalar: Scalar;
    /// The input e: a vector, whose size [`Over`] tells.
    type Input;
    /// How strongly each rule fires at one input.
    type Firing: Strengths<Self::Scalar>;

    /// The normalized firing strengths at a finite input `e`.
    fn fire(&self, e: &Self::Input) -> Self::Firing;

    /// u_n = Σ w̃_r·f_r for the rules of this network firing as `firing` says.
    fn output(&self, firing: &Self::Firing) -> Self::Scalar;

    /// Adds `rate`·w̃ to the consequents, which changes the output at that firing by `rate`·w̃ᵀw̃. This is the formula and no
    /// more: a rate that is not finite spoils them.
    fn move_consequents(&mut self, firing: &Self::Firing, rate: Self::Scalar);

    /// Lets `change` do what it wants with the consequents, one a rule, in the order of the rules. What is not finite afterwards spoils them.
    fn change_consequents(&mut self, change: impl FnOnce(&mut [Self::Scalar]));

    /// The same network, with memberships that stay where they are until a rule carries them along again.
    #[must_use]
    fn released(self) -> Self {
        self
    }
}

/// A network with I inputs: what a loop of that order can take.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a fuzzy network with {I} inputs",
    label = "a network of another size",
    note = "a network compensates a loop of the order that it has inputs, in the scalar of the loop, here `{T}`"
)]
pub trait Over<T: Scalar, const I: usize>: Network<Scalar = T, Input = SVector<T, I>> {
    /// The network's output u_n at the input `e`.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] for an input that is not finite, [`Error::NonFinite`] for an output beyond the range of `T`.
    fn evaluate(&self, e: &SVector<T, I>) -> Result<T, Error> {
        finite_vector("e", e)?;
        finite("u_n", self.output(&self.fire(e)))
    }
}

/// A network whose memberships can go along with the input, and flow: M² ↦ M² + 2τ and d ↦ d·e^{−τ} for the distance d = e − c and M = d/σ of each.
#[diagnostic::on_unimplemented(
    message = "the memberships of `{Self}` cannot flow",
    label = "this rule wants memberships that flow",
    note = "`.with_antecedents(Fixed)` leaves them where they are, in every network"
)]
pub trait Travelling: Network {
    /// Carries the memberships along with an input that has moved to `e`. The first time there is no move to follow: they stay
    /// where they are, and M² is to stay between `floor` and `ceiling`, 0 < `floor` < `ceiling`, from then on.
    fn carry(&mut self, e: &Self::Input, floor: Self::Scalar, ceiling: Self::Scalar);

    /// Lets the memberships that are carried along flow by τ.
    fn flow(&mut self, tau: Self::Scalar);
}
