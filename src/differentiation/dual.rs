use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Arithmetic, Smooth, operators::operators};
use crate::Scalar;

/// A number and its slopes in M directions: y + ε₁·y₁ + … + ε_M·y_M with εᵢ·εⱼ = 0, so that φ(y + ε·ẏ) = φ(y) + ε·φ′(y)·ẏ.
///
/// With the inputs of a formula seeded by their own slopes, its result has the derivatives in those directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<S, const M: usize> {
    /// The number.
    pub value: S,
    /// Its slopes, one for each direction.
    pub slopes: [S; M],
}

impl<S: Arithmetic, const M: usize> Dual<S, M> {
    /// A number that is the same in all directions.
    #[inline]
    pub fn constant(value: S) -> Self {
        Self { value, slopes: [S::zero(); M] }
    }

    /// The j-th of M independent variables: its slope is 1 in direction j, and 0 in the others.
    #[inline]
    pub fn variable(value: S, j: usize) -> Self {
        let mut variable = Self::constant(value);
        if let Some(slope) = variable.slopes.get_mut(j) {
            *slope = S::one();
        }
        variable
    }

    /// φ(y) from its value and its slope φ′(y).
    #[inline]
    fn along(self, value: S, slope: S) -> Self {
        self.map(value, |along| slope * along)
    }

    /// `value` with each slope by `slope`, in a plain loop: the compiler does not always see through `array::map`.
    #[inline]
    fn map(mut self, value: S, slope: impl Fn(S) -> S) -> Self {
        self.value = value;
        for entry in &mut self.slopes {
            *entry = slope(*entry);
        }
        self
    }

    /// `value` with each slope by `slope`, from both.
    #[inline]
    fn zip(mut self, other: Self, value: S, slope: impl Fn(S, S) -> S) -> Self {
        self.value = value;
        for (entry, other) in self.slopes.iter_mut().zip(other.slopes) {
            *entry = slope(*entry, other);
        }
        self
    }
}

impl<S: Arithmetic, const M: usize> Neg for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.map(-self.value, S::neg)
    }
}

impl<S: Arithmetic, const M: usize> Add for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        self.zip(other, self.value + other.value, |a, b| a + b)
    }
}

impl<S: Arithmetic, const M: usize> Sub for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self.zip(other, self.value - other.value, |a, b| a - b)
    }
}

/// (a·b)′ = a′·b + a·b′.
#[allow(clippy::suspicious_arithmetic_impl)]
impl<S: Arithmetic, const M: usize> Mul for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        self.zip(other, self.value * other.value, |a, b| a * other.value + self.value * b)
    }
}

/// (a/b)′ = (a′ − a/b·b′)/b.
#[allow(clippy::suspicious_arithmetic_impl)]
impl<S: Arithmetic, const M: usize> Div for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        self.zip(other, quotient, |a, b| (a - quotient * b) / other.value)
    }
}

operators!([S: Arithmetic, const M: usize] Dual<S, M>, zero: Self::constant(S::zero()), one: Self::constant(S::one()));

impl<S: Arithmetic, const M: usize> Arithmetic for Dual<S, M> {
    #[inline]
    fn times(self, n: f64) -> Self {
        self.map(self.value.times(n), |slope| slope.times(n))
    }
}

impl<T: Scalar, S: Smooth<T>, const M: usize> From<T> for Dual<S, M> {
    #[inline]
    fn from(value: T) -> Self {
        Self::constant(S::from(value))
    }
}

impl<T: Scalar, S: Smooth<T>, const M: usize> Add<T> for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn add(self, other: T) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl<T: Scalar, S: Smooth<T>, const M: usize> Sub<T> for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn sub(self, other: T) -> Self {
        Self { value: self.value - other, ..self }
    }
}

impl<T: Scalar, S: Smooth<T>, const M: usize> Mul<T> for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn mul(self, other: T) -> Self {
        self.map(self.value * other, |slope| slope * other)
    }
}

impl<T: Scalar, S: Smooth<T>, const M: usize> Div<T> for Dual<S, M> {
    type Output = Self;

    #[inline]
    fn div(self, other: T) -> Self {
        self.map(self.value / other, |slope| slope / other)
    }
}

impl<T: Scalar, S: Smooth<T>, const M: usize> Smooth<T> for Dual<S, M> {
    #[inline]
    fn value(self) -> T {
        self.value.value()
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.along(sin, cos), self.along(cos, -sin))
    }

    #[inline]
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.along(exp, exp)
    }

    #[inline]
    fn ln(self) -> Self {
        self.along(self.value.ln(), self.value.recip())
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.along(root, root.times(2.0).recip())
    }

    #[inline]
    fn powf(self, p: T) -> Self {
        self.along(self.value.powf(p), self.value.powf(p - T::one()) * p)
    }

    #[inline]
    fn asin(self) -> Self {
        let slope = (-(self.value * self.value) + T::one()).sqrt().recip();
        self.along(self.value.asin(), slope)
    }

    #[inline]
    fn atan(self) -> Self {
        let slope = (self.value * self.value + T::one()).recip();
        self.along(self.value.atan(), slope)
    }

    /// θ̇ = (x·ẏ − y·ẋ)/(x² + y²).
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let (along_y, along_x) = (x.value / square, self.value / square);
        self.zip(x, self.value.atan2(x.value), |y, x| along_y * y - along_x * x)
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        let (sinh, cosh) = self.value.sinh_cosh();
        (self.along(sinh, cosh), self.along(cosh, sinh))
    }

    #[inline]
    fn tanh(self) -> Self {
        let tanh = self.value.tanh();
        self.along(tanh, -(tanh * tanh) + T::one())
    }
}
