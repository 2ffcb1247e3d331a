use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Arithmetic, Smooth, operators::operators};
use crate::{
    Scalar, elementary,
    scalar::{constant, epsilon},
};

/// A number that knows how much of it may be rounding: |computed − exact| ≤ ε·error, to first order in ε.
///
/// Every operation adds what it rounds itself to what it hands on of the errors of its operands, (a·b: |a|·e_b + |b|·e_a + |a·b|), so that
/// cancellation shows: sin² x + cos² x − 1 is some 10⁻¹⁷, with an error bound of several ε. Given numbers count as rounded once, 0 and 1
/// as exact.
///
/// # References
/// N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 3.3 (running error analysis).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunningError<T> {
    value: T,
    error: T,
}

impl<T: Scalar> RunningError<T> {
    /// The computed number.
    pub fn value(&self) -> T {
        self.value
    }

    /// The bound on its rounding error.
    pub fn rounding(&self) -> T {
        self.error * epsilon()
    }

    /// Whether it is zero as far as the computation can tell: |value| ≤ rounding.
    pub fn vanishes(&self) -> bool {
        self.value.abs() <= self.rounding()
    }

    #[inline]
    fn exact(value: T) -> Self {
        Self { value, error: T::zero() }
    }

    /// A result, rounded once, with the errors handed on to it.
    #[inline]
    fn rounded(value: T, inherited: T) -> Self {
        Self { value, error: inherited + value.abs() }
    }

    /// φ(y) from its value and its slope φ′(y); elementary functions round up to twice.
    #[inline]
    fn along(self, value: T, slope: T) -> Self {
        let own = value.abs() * constant(2.0);
        Self { value, error: slope.abs() * self.error + own }
    }
}

impl<T: Scalar> Neg for RunningError<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl<T: Scalar> Add for RunningError<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.error + other.error)
    }
}

impl<T: Scalar> Sub for RunningError<T> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Scalar> Mul for RunningError<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let inherited = self.value.abs() * other.error + other.value.abs() * self.error;
        Self::rounded(self.value * other.value, inherited)
    }
}

impl<T: Scalar> Div for RunningError<T> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let inherited = (self.error + quotient.abs() * other.error) / other.value.abs();
        Self::rounded(quotient, inherited)
    }
}

operators!([T: Scalar] RunningError<T>, zero: Self::exact(T::zero()), one: Self::exact(T::one()));

impl<T: Scalar> Arithmetic for RunningError<T> {
    fn times(self, n: f64) -> Self {
        self * Self::exact(constant(n))
    }
}

impl<T: Scalar> From<T> for RunningError<T> {
    fn from(value: T) -> Self {
        Self::rounded(value, T::zero())
    }
}

impl<T: Scalar> Add<T> for RunningError<T> {
    type Output = Self;

    fn add(self, other: T) -> Self {
        self + Self::from(other)
    }
}

impl<T: Scalar> Sub<T> for RunningError<T> {
    type Output = Self;

    fn sub(self, other: T) -> Self {
        self - Self::from(other)
    }
}

impl<T: Scalar> Mul<T> for RunningError<T> {
    type Output = Self;

    fn mul(self, other: T) -> Self {
        self * Self::from(other)
    }
}

impl<T: Scalar> Div<T> for RunningError<T> {
    type Output = Self;

    fn div(self, other: T) -> Self {
        self / Self::from(other)
    }
}

impl<T: Scalar> Smooth<T> for RunningError<T> {
    fn value(self) -> T {
        self.value
    }

    /// Their own error is ε in absolute terms, that of a number in the range of both.
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = elementary::sin_cos(self.value);
        let error = |slope: T| slope.abs() * self.error + T::one();
        (Self { value: sin, error: error(cos) }, Self { value: cos, error: error(sin) })
    }

    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.along(exp, exp)
    }

    fn ln(self) -> Self {
        self.along(self.value.ln(), self.value.recip())
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.along(root, (root + root).recip())
    }

    fn powf(self, p: T) -> Self {
        let power = self.value.powf(p);
        self.along(power, p * power / self.value)
    }

    fn asin(self) -> Self {
        let slope = (T::one() - self.value * self.value).sqrt().recip();
        self.along(self.value.asin(), slope)
    }

    fn atan(self) -> Self {
        self.along(self.value.atan(), (T::one() + self.value * self.value).recip())
    }

    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let inherited = (x.value.abs() * self.error + self.value.abs() * x.error) / square;
        Self::rounded(self.value.atan2(x.value), inherited)
    }

    fn sinh_cosh(self) -> (Self, Self) {
        let (sinh, cosh) = self.value.sinh_cosh();
        (self.along(sinh, cosh), self.along(cosh, sinh))
    }

    fn tanh(self) -> Self {
        let tanh = self.value.tanh();
        self.along(tanh, T::one() - tanh * tanh)
    }
}
