use nalgebra::SVector;

use crate::{
    Error, Scalar,
    error::{finite, finite_vector},
};

/// What a chain of order N is to follow at one instant: r₁ and its first N derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference<T, const N: usize> {
    /// r = (r₁, ṙ₁, …, r₁⁽ᴺ⁻¹⁾), to be compared with x.
    pub r: SVector<T, N>,
    /// ṙ_n = r₁⁽ᴺ⁾, the feedforward.
    pub r_n_dot: T,
}

impl<T: Scalar, const N: usize> Reference<T, N> {
    /// A moving reference: `r` = (r₁, …, r_n) and ṙ_n.
    pub fn new(r: impl Into<SVector<T, N>>, r_n_dot: T) -> Self {
        Self { r: r.into(), r_n_dot }
    }

    /// A resting reference: r₁ = `value`, all derivatives zero.
    pub fn setpoint(value: T) -> Self {
        let r = SVector::from_fn(|i, _| if i == 0 { value } else { T::zero() });
        Self::new(r, T::zero())
    }

    /// The same reference in the last N entries of a longer chain, for a controller that is [`Padded`](super::Padded).
    pub fn padded<const LONGER: usize>(&self) -> Reference<T, LONGER> {
        const { assert!(LONGER >= N, "a longer chain") };
        let entry = |i: usize| (i + N).checked_sub(LONGER).map_or(T::zero(), |i| self.r[i]);
        Reference { r: SVector::from_fn(|i, _| entry(i)), r_n_dot: self.r_n_dot }
    }

    /// Checks that everything is finite.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] or [`Error::NonFinite`], naming `r` or `r_n_dot`.
    pub fn validate(&self) -> Result<(), Error> {
        finite_vector("r", &self.r)?;
        finite("r_n_dot", self.r_n_dot)?;
        Ok(())
    }
}

checked! {
    [T: Scalar, const N: usize] Reference<T, N>, [T] { r: SVector<T, N>, r_n_dot: T } =>
    {
        let reference = Self { r, r_n_dot };
        reference.validate().map(|()| reference)
    }
}
