use crate::{
    Error, Scalar,
    error::{at_most, not_negative},
};

/// How the interval of firing strengths [w̲_r, w̄_r] of each rule becomes one output. Both are closed forms; the iterations of Karnik and Mendel are not
/// needed.
///
/// | variant | u_n |
/// |---|---|
/// | `NieTan` | Σ (w̲_r + w̄_r)·f_r / Σ (w̲_r + w̄_r) |
/// | `Bmm { m }` | m·Σ w̄_r·f_r/Σ w̄_r + (1 − m)·Σ w̲_r·f_r/Σ w̲_r |
///
/// # References
/// M. Nie, W. W. Tan, "Towards an efficient type-reduction method for interval type-2 fuzzy logic systems", FUZZ-IEEE, 2008.
/// M. Biglarbegian, W. W. Melek, J. M. Mendel, "On the stability of interval type-2 TSK fuzzy logic control systems", IEEE Transactions on Systems, Man,
/// and Cybernetics B 40(3), 2010.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub enum TypeReduction<T> {
    /// The middle of each interval.
    #[default]
    NieTan,
    /// A mean of the upper and the lower network.
    Bmm {
        /// The weight of the upper one, between 0 and 1.
        m: T,
    },
}

impl<T: Scalar> TypeReduction<T> {
    pub(super) fn validated(self) -> Result<Self, Error> {
        if let TypeReduction::Bmm { m } = self {
            at_most("m", not_negative("m", m)?, T::one())?;
        }
        Ok(self)
    }

    /// The weight of the lower network in the output, where the lower firing strengths are `ratio` of the upper ones in sum.
    pub(super) fn lower(&self, ratio: T) -> T {
        match *self {
            TypeReduction::NieTan => ratio / (T::one() + ratio),
            TypeReduction::Bmm { m } => T::one() - m,
        }
    }
}
