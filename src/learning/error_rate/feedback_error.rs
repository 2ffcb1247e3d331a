use super::ErrorRate;
use crate::{Error, Scalar, learning::ClosedLoop};

/// ė_n = 0: the network is trained on the feedback alone, s = u_b. This is feedback-error learning, the predecessor of learning on the closed-loop
/// error.
///
/// It needs no rate and no model, and does not differentiate noise. What is lost is the identity s = −(u_n + Δ): the network does not hear of
/// Δ before Δ has moved e,
///
/// ė_n = −u_b − u_n − Δ, u̇_n = α·sgn(u_b),
///
/// so the learner is an integral action in the loop, and no longer outside of it:
///
/// * No [`Certificate`](crate::learning::Certificate) holds, nor its reaching time: α > B is not enough for u_n to meet −Δ, and e swings while it does.
/// * A boundary layer δ makes it an integral gain α/δ. The set-valued sign makes that 1/h, as far as αh reaches: for n = 1 the loop
///   rings at about √(k₁/h), decays like e^{−k₁t/2}, and is unstable from k₁h = 4/3 on.
/// * A constant Δ is learned completely as before, s = u_b = 0 there.
/// * Without any Δ, CLELC is not the feedback alone: every error of the reference is learned.
///
/// [`ModelAided`](super::ModelAided) does not need a sensor for ė_n either.
///
/// # References
/// M. Kawato, K. Furukawa, R. Suzuki, "A hierarchical neural-network model for control and learning of voluntary movement", Biological
/// Cybernetics 57, 1987. With a sliding-mode rule: E. Kayacan, E. Kayacan, H. Ramon, W. Saeys, "Adaptive neuro-fuzzy control of a spherical
/// rolling robot using sliding-mode-control-theory-based online learning algorithm", IEEE Transactions on Cybernetics 43(1), 2013.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FeedbackError;

impl<T: Scalar, const N: usize> ErrorRate<T, N> for FeedbackError {
    fn error_rate(&mut self, _at: &ClosedLoop<T, N>, _u_n: T, _dt: T) -> Result<T, Error> {
        // −0 changes no sum: s is u_b to the last bit.
        Ok(-T::zero())
    }
}
