//! Plants that are given by their equations, and what differentiation finds out about them.

mod flow;

pub use flow::{Along, Flow};

use crate::{Scalar, differentiation::Smooth};

/// A plant with M inputs and as many outputs, by its equations: ẋ = f(x) + g(x)·u, y = h(x).
///
/// The equations are written once, for any number `S` that is [`Smooth`] over the plant's own. They run on plain numbers, and on numbers
/// that carry derivatives of them.
pub trait SmoothPlant<const NX: usize, const M: usize> {
    /// The number type of states, inputs and parameters.
    type Scalar: Scalar;

    /// The drift field f(x): ẋ without input.
    fn drift_field<S: Smooth<Self::Scalar>>(&self, x: [S; NX]) -> [S; NX];

    /// The input fields g₁(x), …, g_M(x): the j-th is ∂ẋ/∂uⱼ.
    fn input_fields<S: Smooth<Self::Scalar>>(&self, x: [S; NX]) -> [[S; NX]; M];

    /// The outputs h₁(x), …, h_M(x): what is to follow a reference.
    fn outputs<S: Smooth<Self::Scalar>>(&self, x: [S; NX]) -> [S; M];
}

impl<P: SmoothPlant<NX, M> + ?Sized, const NX: usize, const M: usize> SmoothPlant<NX, M> for &P {
    type Scalar = P::Scalar;

    #[inline]
    fn drift_field<S: Smooth<P::Scalar>>(&self, x: [S; NX]) -> [S; NX] {
        (**self).drift_field(x)
    }

    #[inline]
    fn input_fields<S: Smooth<P::Scalar>>(&self, x: [S; NX]) -> [[S; NX]; M] {
        (**self).input_fields(x)
    }

    #[inline]
    fn outputs<S: Smooth<P::Scalar>>(&self, x: [S; NX]) -> [S; M] {
        (**self).outputs(x)
    }
}
