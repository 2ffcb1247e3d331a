//! Plants made up to have every function in them, or to be bad in one respect.

use brunovsky::{
    Scalar,
    differentiation::{Dual, Smooth},
    plant::SmoothPlant,
};

use crate::support::num;

/// A plant of order 4 without structure: every state in every equation, through every kind of function.
#[derive(Debug, Clone, Copy)]
pub struct Tangle<T>(pub core::marker::PhantomData<T>);

impl<T> Tangle<T> {
    pub const fn new() -> Self {
        Self(core::marker::PhantomData)
    }
}

impl<T: Scalar> SmoothPlant<4, 2> for Tangle<T> {
    type Scalar = T;

    fn drift_field<S: Smooth<T>>(&self, [a, b, c, d]: [S; 4]) -> [S; 4] {
        let radius = (a * a + b * b + T::one()).sqrt();
        [
            b * c.sin() - d.tanh() * num::<T>(0.5),
            (a - d).exp() * num::<T>(0.3) - c,
            d / radius + a.cos() * b,
            (b * c).atan() - radius.ln() * a,
        ]
    }

    fn input_fields<S: Smooth<T>>(&self, [a, b, c, d]: [S; 4]) -> [[S; 4]; 2] {
        [[b, S::one(), a * c, d.sin()], [c.cos(), a - d, S::zero(), b * b + T::one()]]
    }

    fn outputs<S: Smooth<T>>(&self, [a, b, c, d]: [S; 4]) -> [S; 2] {
        [a * b + c.sin(), d * d - a.exp() * c]
    }
}

/// A plant in the coordinates ξ = (x₁ + x₂², x₂ − sin x₃, x₃ + x₄·x₄, x₄).
#[derive(Debug, Clone, Copy)]
pub struct Transformed<P>(pub P);

impl<P> Transformed<P> {
    pub fn forth<T: Scalar, S: Smooth<T>>([a, b, c, d]: [S; 4]) -> [S; 4] {
        [a + b * b, b - c.sin(), c + d * d, d]
    }

    pub fn back<T: Scalar, S: Smooth<T>>([a, b, c, d]: [S; 4]) -> [S; 4] {
        let c = c - d * d;
        let b = b + c.sin();
        [a - b * b, b, c, d]
    }

    /// The vector `v` at `x`, in the new coordinates.
    fn pushed<T: Scalar, S: Smooth<T>>(x: [S; 4], v: [S; 4]) -> [S; 4] {
        let moving = core::array::from_fn(|i| Dual { value: x[i], slopes: [v[i]] });
        Self::forth::<T, Dual<S, 1>>(moving).map(|entry| entry.slopes[0])
    }
}

impl<P: SmoothPlant<4, M>, const M: usize> SmoothPlant<4, M> for Transformed<P> {
    type Scalar = P::Scalar;

    fn drift_field<S: Smooth<P::Scalar>>(&self, xi: [S; 4]) -> [S; 4] {
        let x = Self::back(xi);
        Self::pushed(x, self.0.drift_field(x))
    }

    fn input_fields<S: Smooth<P::Scalar>>(&self, xi: [S; 4]) -> [[S; 4]; M] {
        let x = Self::back(xi);
        self.0.input_fields(x).map(|field| Self::pushed(x, field))
    }

    fn outputs<S: Smooth<P::Scalar>>(&self, xi: [S; 4]) -> [S; M] {
        self.0.outputs(Self::back(xi))
    }
}

/// The fields of `Tangle` with the outputs h₁·h₂ and h₁.
#[derive(Debug, Clone, Copy)]
pub struct Product<T>(pub Tangle<T>);

impl<T: Scalar> SmoothPlant<4, 2> for Product<T> {
    type Scalar = T;

    fn drift_field<S: Smooth<T>>(&self, x: [S; 4]) -> [S; 4] {
        self.0.drift_field(x)
    }

    fn input_fields<S: Smooth<T>>(&self, x: [S; 4]) -> [[S; 4]; 2] {
        self.0.input_fields(x)
    }

    fn outputs<S: Smooth<T>>(&self, x: [S; 4]) -> [S; 2] {
        let [first, second] = self.0.outputs(x);
        [first * second, first]
    }
}
