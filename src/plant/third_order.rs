use core::marker::PhantomData;

use nalgebra::SVector;

use super::{FeedbackLinearizable, SmoothPlant};
use crate::{Scalar, differentiation::Smooth, scalar::constant};

/// The third-order system of the simulation study: a(x) = −2x₁ − x₂ − sin x₃ + e^{x₁}, b(x) = 1 (eq_3rdsystems). Dimensionless.
///
/// # References
/// E. Kayacan, "Closed-loop error learning control for uncertain nonlinear systems with experimental validation on a
/// mobile robot", IEEE/ASME Transactions on Mechatronics 24(5), 2019.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ThirdOrder<T>(PhantomData<T>);

impl<T> ThirdOrder<T> {
    /// The system; it has no parameters.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T> Default for ThirdOrder<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Scalar> FeedbackLinearizable<3> for ThirdOrder<T> {
    type Scalar = T;

    fn drift(&self, x: &SVector<T, 3>) -> T {
        jerk::<T, T>((*x).into())
    }

    fn input_gain(&self, _x: &SVector<T, 3>) -> T {
        T::one()
    }
}

#[inline]
fn jerk<T: Scalar, S: Smooth<T>>([x1, x2, x3]: [S; 3]) -> S {
    x1 * constant::<T>(-2.0) - x2 - x3.sin() + x1.exp()
}

impl<T: Scalar> SmoothPlant<3, 1> for ThirdOrder<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, x: [S; 3]) -> [S; 3] {
        [x[1], x[2], jerk(x)]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 3]) -> [[S; 3]; 1] {
        [[S::zero(), S::zero(), S::one()]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [x1, ..]: [S; 3]) -> [S; 1] {
        [x1]
    }
}
