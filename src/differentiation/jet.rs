use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Arithmetic, Smooth, operators::operators};
use crate::Scalar;

/// A number that moves in time: its value and its first K − 1 derivatives, (y, ẏ, …, y⁽ᴷ⁻¹⁾).
///
/// Sums and multiples act entry by entry; products follow Leibniz' rule (a·b)⁽ᵏ⁾ = Σⱼ C(k, j)·a⁽ʲ⁾·b⁽ᵏ⁻ʲ⁾, and functions y = φ(a) the
/// chain rule ẏ = φ′(a)·ȧ, differentiated k − 1 times by Leibniz. An operation costs K² or less.
///
/// The entries are the coefficients of the Taylor series times k!, so that the flow of ẋ = f(x) needs no divisions: its derivatives are its start
/// followed by those of its rate, see [`starting`](Self::starting).
///
/// # References
/// A. Griewank, A. Walther, *Evaluating Derivatives*, table 13.1 and 13.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet<S, const K: usize>([S; K]);

impl<S, const K: usize> Jet<S, K> {
    /// A number with the derivatives (y, ẏ, …, y⁽ᴷ⁻¹⁾).
    #[inline]
    pub const fn new(derivatives: [S; K]) -> Self {
        const { assert!(K > 0, "a jet has a value") };
        Self(derivatives)
    }

    /// (y, ẏ, …, y⁽ᴷ⁻¹⁾).
    #[inline]
    pub const fn derivatives(&self) -> &[S; K] {
        &self.0
    }
}

impl<S: Arithmetic, const K: usize> Jet<S, K> {
    /// A number at rest.
    #[inline]
    pub fn constant(value: S) -> Self {
        let mut jet = Self::new([S::zero(); K]);
        jet.0[0] = value;
        jet
    }

    /// The number that starts at `value` and has the rate ẏ = `rate`: derivatives that `rate` does not have are taken as zero.
    #[inline]
    pub fn starting<const J: usize>(value: S, rate: &Jet<S, J>) -> Self {
        let mut jet = Self::constant(value);
        // One move of memory instead of a loop: the compiler sees through it at any size.
        if let Some(places) = jet.0.get_mut(1..K.min(J + 1)) {
            places.copy_from_slice(&rate.0[..places.len()]);
        }
        jet
    }

    /// Entry by entry, in a plain loop: the compiler does not always see through `array::map`.
    #[inline]
    fn map(mut self, mut f: impl FnMut(S) -> S) -> Self {
        for entry in &mut self.0 {
            *entry = f(*entry);
        }
        self
    }

    /// Entry by entry, of two.
    #[inline]
    fn zip(mut self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        for (entry, other) in self.0.iter_mut().zip(other.0) {
            *entry = f(*entry, other);
        }
        self
    }

    /// The first entry by `first`, the others by `others`.
    #[inline]
    fn map_apart(mut self, first: impl Fn(S) -> S, others: impl Fn(S) -> S) -> Self {
        if let [value, derivatives @ ..] = &mut self.0[..] {
            *value = first(*value);
            for entry in derivatives {
                *entry = others(*entry);
            }
        }
        self
    }

    /// The entries from the first one, `value`, and a law for entry k that knows those below it.
    #[inline]
    fn recursive(value: S, mut next: impl FnMut(usize, &Self) -> S) -> Self {
        let mut jet = Self::constant(value);
        for k in 1..K {
            let entry = next(k, &jet);
            jet.set(k, entry);
        }
        jet
    }

    /// Two of them that know each other.
    #[inline]
    fn recursive_pair(
        value: (S, S),
        mut next: impl FnMut(usize, &Self, &Self) -> (S, S),
    ) -> (Self, Self) {
        let (mut first, mut second) = (Self::constant(value.0), Self::constant(value.1));
        for k in 1..K {
            let entries = next(k, &first, &second);
            first.set(k, entries.0);
            second.set(k, entries.1);
        }
        (first, second)
    }

    #[inline]
    fn set(&mut self, k: usize, entry: S) {
        if let Some(place) = self.0.get_mut(k) {
            *place = entry;
        }
    }

    /// φ(a) from its value and the jet of the slope φ′(a).
    #[inline]
    fn along(self, value: S, slope: &Self) -> Self {
        Self::recursive(value, |k, _| rate(k, slope, &self))
    }
}

/// The sum of C(n, j)·term(j) over `range`.
#[inline]
fn binomial_sum<S: Arithmetic>(
    n: usize,
    range: core::ops::Range<usize>,
    mut term: impl FnMut(usize) -> S,
) -> S {
    let (mut sum, mut weight) = (S::zero(), 1.0);
    let mut started = false;
    for j in 0..range.end {
        if j >= range.start {
            let summand = term(j).times(weight);
            sum = if started { sum + summand } else { summand };
            started = true;
        }
        weight = weight * (n - j) as f64 / (j + 1) as f64;
    }
    sum
}

/// (w·ȧ)⁽ᵏ⁻¹⁾, k > 0: the k-th derivative of a y with ẏ = w·ȧ.
#[inline]
fn rate<S: Arithmetic, const K: usize>(k: usize, w: &Jet<S, K>, a: &Jet<S, K>) -> S {
    binomial_sum(k - 1, 0..k, |j| w.0[j] * a.0[k - j])
}

/// (a·b)⁽ᵏ⁾.
#[inline]
fn product<S: Arithmetic, const K: usize>(k: usize, a: &Jet<S, K>, b: &Jet<S, K>) -> S {
    binomial_sum(k, 0..k + 1, |j| a.0[j] * b.0[k - j])
}

impl<S: Arithmetic, const K: usize> Neg for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.map(S::neg)
    }
}

impl<S: Arithmetic, const K: usize> Add for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<S: Arithmetic, const K: usize> Sub for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<S: Arithmetic, const K: usize> Mul for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::recursive(self.0[0] * other.0[0], |k, _| product(k, &self, &other))
    }
}

/// q = a/b from a = q·b: q⁽ᵏ⁾·b = a⁽ᵏ⁾ − Σ C(k, j)·q⁽ʲ⁾·b⁽ᵏ⁻ʲ⁾ over j < k.
impl<S: Arithmetic, const K: usize> Div for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = S::one() / other.0[0];
        Self::recursive(self.0[0] / other.0[0], |k, q| {
            (self.0[k] - binomial_sum(k, 0..k, |j| q.0[j] * other.0[k - j])) * inverse
        })
    }
}

operators!([S: Arithmetic, const K: usize] Jet<S, K>, zero: Self::constant(S::zero()), one: Self::constant(S::one()));

impl<S: Arithmetic, const K: usize> Arithmetic for Jet<S, K> {
    #[inline]
    fn times(self, n: f64) -> Self {
        self.map(|entry| entry.times(n))
    }
}

impl<T: Scalar, S: Smooth<T>, const K: usize> From<T> for Jet<S, K> {
    #[inline]
    fn from(value: T) -> Self {
        Self::constant(S::from(value))
    }
}

impl<T: Scalar, S: Smooth<T>, const K: usize> Add<T> for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn add(self, other: T) -> Self {
        self.map_apart(|value| value + other, |derivative| derivative)
    }
}

impl<T: Scalar, S: Smooth<T>, const K: usize> Sub<T> for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn sub(self, other: T) -> Self {
        self.map_apart(|value| value - other, |derivative| derivative)
    }
}

impl<T: Scalar, S: Smooth<T>, const K: usize> Mul<T> for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn mul(self, other: T) -> Self {
        self.map(|entry| entry * other)
    }
}

impl<T: Scalar, S: Smooth<T>, const K: usize> Div<T> for Jet<S, K> {
    type Output = Self;

    #[inline]
    fn div(self, other: T) -> Self {
        let inverse = other.recip();
        self.map_apart(|value| value / other, |derivative| derivative * inverse)
    }
}

impl<T: Scalar, S: Smooth<T>, const K: usize> Smooth<T> for Jet<S, K> {
    #[inline]
    fn value(self) -> T {
        self.0[0].value()
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        Self::recursive_pair(self.0[0].sin_cos(), |k, sin, cos| {
            (rate(k, cos, &self), -rate(k, sin, &self))
        })
    }

    #[inline]
    fn exp(self) -> Self {
        Self::recursive(self.0[0].exp(), |k, exp| rate(k, exp, &self))
    }

    #[inline]
    fn ln(self) -> Self {
        self.along(self.0[0].ln(), &self.recip())
    }

    /// From y·y = a: 2·y·y⁽ᵏ⁾ = a⁽ᵏ⁾ − Σ C(k, j)·y⁽ʲ⁾·y⁽ᵏ⁻ʲ⁾ over 0 < j < k.
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.0[0].sqrt();
        let inverse = S::one() / root.times(2.0);
        Self::recursive(root, |k, y| {
            (self.0[k] - binomial_sum(k, 1..k, |j| y.0[j] * y.0[k - j])) * inverse
        })
    }

    /// ẏ = w·ȧ with w = p·y/a.
    #[inline]
    fn powf(self, p: T) -> Self {
        let scaled = Self::from(p) / self;
        let value = self.0[0].powf(p);
        let slope = value * scaled.0[0];
        Self::recursive_pair((value, slope), |k, y, w| {
            let entry = rate(k, w, &self);
            let mut y = *y;
            y.set(k, entry);
            (entry, product(k, &y, &scaled))
        })
        .0
    }

    #[inline]
    fn asin(self) -> Self {
        let slope = (-(self * self) + T::one()).sqrt().recip();
        self.along(self.0[0].asin(), &slope)
    }

    #[inline]
    fn atan(self) -> Self {
        let slope = (self * self + T::one()).recip();
        self.along(self.0[0].atan(), &slope)
    }

    /// θ̇ = (x·ẏ − y·ẋ)/(x² + y²).
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let square = self * self + x * x;
        let (along_y, along_x) = (x / square, -self / square);
        Self::recursive(self.0[0].atan2(x.0[0]), |k, _| {
            rate(k, &along_y, &self) + rate(k, &along_x, &x)
        })
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        Self::recursive_pair(self.0[0].sinh_cosh(), |k, sinh, cosh| {
            (rate(k, cosh, &self), rate(k, sinh, &self))
        })
    }

    /// ẏ = w·ȧ with w = 1 − y².
    #[inline]
    fn tanh(self) -> Self {
        let value = self.0[0].tanh();
        let slope = -(value * value) + T::one();
        Self::recursive_pair((value, slope), |k, y, w| {
            let entry = rate(k, w, &self);
            let mut y = *y;
            y.set(k, entry);
            (entry, -product(k, &y, &y))
        })
        .0
    }
}
