use core::{
    fmt::Debug,
    ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign},
};

use num_traits::{One, Zero};

use crate::{
    Scalar,
    elementary::{self, hypot},
    scalar::constant,
};

/// Numbers with the four operations among each other.
pub trait Arithmetic:
    Copy
    + Debug
    + PartialEq
    + 'static
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// n·x for a whole number n: a binomial coefficient, say.
    fn times(self, n: f64) -> Self;
}

/// Numbers that a smooth formula runs on: plain ones, and those that carry derivatives of it.
///
/// T is the plain number, and the type of every parameter that is not differentiated. A parameter stands to the right of the operator, as in
/// `x * self.stiffness` or `-x + self.offset`; `S::from(self.offset)` makes a number of it that may stand anywhere.
///
/// Every [`Scalar`] is `Smooth` over itself, also num_dual's numbers.
///
/// ```
/// use brunovsky::differentiation::{Jet, Smooth};
///
/// fn swing<S: Smooth>(angle: S, gain: f64) -> S {
///     angle.sin() * gain + 1.0
/// }
///
/// assert_eq!(swing(0.0, 3.0), 1.0);
/// // With the angle moving at 2 rad/s: the value and its rate.
/// assert_eq!(swing(Jet::new([0.0, 2.0]), 3.0), Jet::new([1.0, 6.0]));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number that smooth formulas over `{T}` run on",
    note = "every `Scalar` is one over itself; `Jet`, `Dual` and `RunningError` are over the plain number inside them"
)]
pub trait Smooth<T: Scalar = f64>:
    Arithmetic
    + From<T>
    + Add<T, Output = Self>
    + Sub<T, Output = Self>
    + Mul<T, Output = Self>
    + Div<T, Output = Self>
{
    /// The plain number, without derivatives: for a formula that consists of pieces.
    fn value(self) -> T;

    /// sin x and cos x, x in rad.
    fn sin_cos(self) -> (Self, Self);

    /// eˣ.
    fn exp(self) -> Self;

    /// ln x.
    fn ln(self) -> Self;

    /// √x; its derivatives are not finite at 0.
    fn sqrt(self) -> Self;

    /// xᵖ for x > 0; see [`powi`](Self::powi) for whole exponents.
    fn powf(self, p: T) -> Self;

    /// arcsin x in rad.
    fn asin(self) -> Self;

    /// arctan x in rad.
    fn atan(self) -> Self;

    /// The angle of the point (x, y) in rad, y being `self`.
    fn atan2(self, x: Self) -> Self;

    /// sinh x and cosh x.
    fn sinh_cosh(self) -> (Self, Self);

    /// tanh x.
    fn tanh(self) -> Self;

    /// sin x, x in rad.
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// cos x, x in rad.
    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// tan x, x in rad.
    #[inline]
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    /// arccos x in rad.
    #[inline]
    fn acos(self) -> Self {
        -self.asin() + T::frac_pi_2()
    }

    /// sinh x.
    #[inline]
    fn sinh(self) -> Self {
        self.sinh_cosh().0
    }

    /// cosh x.
    #[inline]
    fn cosh(self) -> Self {
        self.sinh_cosh().1
    }

    /// 1/x.
    #[inline]
    fn recip(self) -> Self {
        Self::one() / self
    }

    /// xⁿ.
    #[inline]
    fn powi(self, n: i32) -> Self {
        let (mut power, mut base, mut left) = (Self::one(), self, n.unsigned_abs());
        while left > 0 {
            if left % 2 == 1 {
                power *= base;
            }
            left /= 2;
            if left > 0 {
                base *= base;
            }
        }
        if n < 0 { power.recip() } else { power }
    }

    /// √(x² + y²).
    #[inline]
    fn hypot(self, y: Self) -> Self {
        (self * self + y * y).sqrt()
    }

    /// |x|, smooth on either side of 0; at 0 its slope is taken to be 1.
    #[inline]
    fn abs(self) -> Self {
        if self.value() < T::zero() { -self } else { self }
    }
}

impl<T: Scalar> Arithmetic for T {
    #[inline]
    fn times(self, n: f64) -> Self {
        self * constant(n)
    }
}

impl<T: Scalar> Smooth<T> for T {
    #[inline]
    fn value(self) -> T {
        self
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        elementary::sin_cos(self)
    }

    #[inline]
    fn sin(self) -> Self {
        elementary::sin(self)
    }

    #[inline]
    fn cos(self) -> Self {
        elementary::cos(self)
    }

    #[inline]
    fn exp(self) -> Self {
        self.exp()
    }

    #[inline]
    fn ln(self) -> Self {
        self.ln()
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn powf(self, p: T) -> Self {
        self.powf(p)
    }

    #[inline]
    fn asin(self) -> Self {
        self.asin()
    }

    #[inline]
    fn atan(self) -> Self {
        self.atan()
    }

    #[inline]
    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        self.sinh_cosh()
    }

    #[inline]
    fn tanh(self) -> Self {
        self.tanh()
    }

    #[inline]
    fn hypot(self, y: Self) -> Self {
        hypot(self, y)
    }
}
