//! A plant of order six with a product and a sine in every equation, and an output of any relative degree.

use brunovsky::{differentiation::Smooth, plant::SmoothPlant};

/// ẋᵢ = (2 + x₁)·xᵢ₊₁ + sin xᵢ for i < 6, ẋ₆ = sin x₆ + u; the output x₇₋ᵣ has the relative degree R.
#[derive(Clone, Copy)]
pub struct Cascade<const R: usize>;

impl<const R: usize> SmoothPlant<6, 1> for Cascade<R> {
    type Scalar = f64;

    #[inline]
    fn drift_field<S: Smooth>(&self, [x1, x2, x3, x4, x5, x6]: [S; 6]) -> [S; 6] {
        let gain = x1 + 2.0;
        [
            gain * x2 + x1.sin(),
            gain * x3 + x2.sin(),
            gain * x4 + x3.sin(),
            gain * x5 + x4.sin(),
            gain * x6 + x5.sin(),
            x6.sin(),
        ]
    }

    #[inline]
    fn input_fields<S: Smooth>(&self, _: [S; 6]) -> [[S; 6]; 1] {
        [[0.0, 0.0, 0.0, 0.0, 0.0, 1.0].map(S::from)]
    }

    #[inline]
    fn outputs<S: Smooth>(&self, x: [S; 6]) -> [S; 1] {
        [x[6 - R]]
    }
}
