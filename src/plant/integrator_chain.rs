use core::marker::PhantomData;

use nalgebra::SVector;

use super::FeedbackLinearizable;
use crate::Scalar;

/// The Brunovský form: x₁⁽ᴺ⁾ = u, so a(x) = 0 and b(x) = 1.
///
/// This is what every feedback-linearizable plant looks like under exact linearization. As a controller's model it makes
/// the controller's output the virtual input ν itself.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct IntegratorChain<T, const N: usize>(PhantomData<T>);

impl<T, const N: usize> IntegratorChain<T, N> {
    /// A chain of `N` integrators.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T, const N: usize> Default for IntegratorChain<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Scalar, const N: usize> FeedbackLinearizable<N> for IntegratorChain<T, N> {
    type Scalar = T;

    fn drift(&self, _x: &SVector<T, N>) -> T {
        T::zero()
    }

    fn input_gain(&self, _x: &SVector<T, N>) -> T {
        T::one()
    }
}
