use crate::{
    Error, Scalar,
    elementary::hypot,
    error::{not_negative, positive},
    scalar::constant,
};

/// How sgn(s) in u̇_n = α·sgn(s) is discretized. It decides whether learning works at all.
///
/// | variant | ς over one period h | when |
/// |---|---|---|
/// | `Explicit { delta }` | s/(\|s\| + δ) | to reproduce the paper. Chatters with amplitude αh/2 − δ unless αh/δ < 2 |
/// | `Implicit { delta }` | s⁺/(\|s⁺\| + δ) with s⁺ = s − αh·s⁺/(\|s⁺\| + δ) | noisy ė_n: δ filters it, at the price of a residual of s; δ = 0 is `SetValued` |
/// | `SetValued` | clamp(s/(αh), −1, 1) | the default: no chattering at any αh, no residual of its own, nothing to tune |
///
/// `SetValued` takes s to zero in one step, if the model's input gain b̂ is right; in general to (1 − b/b̂)·s. It needs 0 < b/b̂ < 2,
/// `Explicit` 0 < b/b̂ < 2·δ/(αh), `Implicit` 0 < b/b̂ < 2·(1 + δ/(αh)).
///
/// The implicit variants are backward Euler steps of ṡ = −α·sgn(s), solved in closed form; for them |s⁺| ≤ |s| whatever αh is.
///
/// # References
/// The smoothed sign is the paper's second remark. V. Acary, B. Brogliato, "Implicit Euler numerical scheme and
/// chattering-free implementation of sliding mode systems", Systems & Control Letters 59(5), 2010.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub enum Switching<T> {
    /// Forward Euler with the smoothed sign.
    Explicit {
        /// The boundary layer δ > 0, in the units of s.
        delta: T,
    },
    /// Backward Euler with the smoothed sign.
    Implicit {
        /// The boundary layer δ ≥ 0, in the units of s.
        delta: T,
    },
    /// Backward Euler with the set-valued sign, sgn(0) = \[−1, 1\].
    SetValued,
}

impl<T: Scalar> Switching<T> {
    /// ς ∈ \[−1, 1\], an odd function of s that does not decrease, where `reach` = α·h > 0 is the farthest that u_n can move.
    pub fn sign(&self, s: T, reach: T) -> T {
        let size = s.abs();
        let ratio = match *self {
            // s = 0 has no sign; asking first spares every law below the quotient 0/0.
            _ if size.is_zero() => T::zero(),
            Switching::Explicit { delta } => size / (size + delta),
            Switching::Implicit { delta } if delta > T::zero() => implicit(size, reach, delta),
            Switching::Implicit { .. } | Switching::SetValued if size >= reach => T::one(),
            Switching::Implicit { .. } | Switching::SetValued => size / reach,
        };
        ratio.copysign(s)
    }

    /// The boundary layer δ; 0 for the set-valued sign.
    pub fn delta(&self) -> T {
        match *self {
            Switching::Explicit { delta } | Switching::Implicit { delta } => delta,
            Switching::SetValued => T::zero(),
        }
    }

    pub(crate) fn validated(self) -> Result<Self, Error> {
        match self {
            Switching::Explicit { delta } => positive("delta", delta).map(|_| self),
            Switching::Implicit { delta } => not_negative("delta", delta).map(|_| self),
            Switching::SetValued => Ok(self),
        }
    }
}

/// |ς| = z/(z + δ) with z = |s⁺|, the positive root of z² + B·z − δ·|s| = 0 where B = δ + αh − |s|.
///
/// Of the two forms of the root the one without cancellation is taken. Halves, the square root as a hypotenuse, and quotients that
/// may become 0 or infinite keep every intermediate result from overflowing into a NaN.
fn implicit<T: Scalar>(size: T, reach: T, delta: T) -> T {
    let half_b = (delta + reach - size) * constant(0.5);
    let root = hypot(half_b, delta.sqrt() * size.sqrt());
    if half_b > T::zero() {
        let ratio = size / (half_b + root);
        ratio / (T::one() + ratio)
    } else {
        T::one() / (T::one() + delta / (root - half_b))
    }
}
