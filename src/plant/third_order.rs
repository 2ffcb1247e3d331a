use core::marker::PhantomData;

use nalgebra::SVector;

use super::FeedbackLinearizable;
use crate::{Scalar, elementary::sin, scalar::constant};

/// The third-order system of the simulation study: a(x) = −2x₁ − x₂ − sin x₃ + e^{x₁}, b(x) = 1 (eq_3rdsystems). Dimensionless.
///
/// # References
/// E. Kayacan, "Closed-loop error learning control for uncertain nonlinear systems with experimental validation on a
/// mobile robot", IEEE/ASME Transactions on Mechatronics 24(5), 2019.
#[derive(Debug, Clone, Copy, PartialEq)]
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
        constant::<T>(-2.0) * x[0] - x[1] - sin(x[2]) + x[0].exp()
    }

    fn input_gain(&self, _x: &SVector<T, 3>) -> T {
        T::one()
    }
}
