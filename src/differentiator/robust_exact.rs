use super::{Differentiator, chain::Chain};
use crate::{Error, Scalar, error::positive, scalar::constant};

/// Levant's robust exact differentiator of order n = M − 1, for signals with |y⁽ᴹ⁾| ≤ L, discretized implicitly.
///
/// żᵢ = zᵢ₊₁ − λᵢ·L^((i+1)/M)·|e|^((n−i)/M)·sgn(e), e = z₀ − y, with the set-valued sgn(0) = \[−1, 1\], and
///
/// | order | λ₀, λ₁, … |
/// |---|---|
/// | 1, the super-twisting differentiator | 1.5, 1.1 |
/// | 2 | 2, 2.12, 1.1 |
/// | 3 | 3, 4.16, 3.06, 1.1 |
///
/// Without noise and in continuous time z becomes the derivatives themselves, after a finite time; noise |n| ≤ ε leaves errors of the order of
/// Lⁱᐟᴹ·ε⁽ᴹ⁻ⁱ⁾ᐟᴹ in the i-th derivative, which no other law can undercut by more than a factor.
///
/// # Discretization
/// Backward Euler, with e taken at the end of the period. With |e| = L·(h·w)ᴹ its equation for e loses L and h:
///
/// wᴹ + λ₀·wⁿ + … + λ_{n−1}·w + λ_n·\[0, 1\] ∋ |ε|/(L·hᴹ), ε = y − (z₀ predicted),
///
/// whose one solution is w = 0 if |ε| ≤ λ_n·L·hᴹ. Otherwise the left side is convex and grows, and Newton's iteration falls to the root from above.
///
/// In that first case, the sliding mode, e = 0, and at a constant period z is the polynomial through the last M samples: neither L nor λ appears,
/// so gains however far too large change nothing, and nothing chatters. The outputs are derivatives rather than backward differences, by
/// dt·D = −ln(1 − ∇), and prediction is by Taylor's formula: a polynomial of degree n that was caught stays exact, also when the period varies. What
/// an error in the sliding mode becomes under varying periods: in first order 0 after two samples; in second order it shrinks by ½·|ρ − 1| a
/// sample, where ρ is the ratio of the period to the one before, so periods may at most triple.
///
/// At the first sample z = (y, 0, …).
///
/// # References
/// A. Levant, "Robust exact differentiation via sliding mode technique", Automatica 34(3), 1998; "Higher-order sliding modes, differentiation and
/// output-feedback control", International Journal of Control 76(9–10), 2003. M. R. Mojallizadeh, B. Brogliato, V. Acary, "Discrete-time
/// differentiators: design and comparative analysis", International Journal of Robust and Nonlinear Control 31(16), 2021. Outputs that are combinations
/// of the states of the implicit scheme: R. Seeber, "Proper implicit discretization of arbitrary-order robust exact differentiators", 2024.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobustExact<T, const M: usize> {
    bound: T,
    lambda: [T; M],
    state: Option<Chain<T, M>>,
}

impl<T: Scalar> RobustExact<T, 2> {
    /// Estimates y and ẏ, for |ÿ| ≤ `bound` = L > 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn first_order(bound: T) -> Result<Self, Error> {
        Self::new(bound)
    }
}

impl<T: Scalar> RobustExact<T, 3> {
    /// Estimates y, ẏ and ÿ, for |y⃛| ≤ `bound` = L > 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn second_order(bound: T) -> Result<Self, Error> {
        Self::new(bound)
    }
}

impl<T: Scalar> RobustExact<T, 4> {
    /// Estimates y, ẏ, ÿ and y⃛, for |y⁽⁴⁾| ≤ `bound` = L > 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn third_order(bound: T) -> Result<Self, Error> {
        Self::new(bound)
    }
}

impl<T: Scalar, const M: usize> RobustExact<T, M> {
    fn new(bound: T) -> Result<Self, Error> {
        let bound = positive("bound on the rate", bound)?;
        let lambda: &[f64] = match M {
            2 => &[1.5, 1.1],
            3 => &[2.0, 2.12, 1.1],
            _ => &[3.0, 4.16, 3.06, 1.1],
        };
        // No other order has a constructor.
        let other = |_| Error::Length { name: "estimate", expected: lambda.len(), found: M };
        let lambda = <[f64; M]>::try_from(lambda).map_err(other)?;
        Ok(Self { bound, lambda: lambda.map(constant), state: None })
    }

    /// y and its derivatives at the last sample; `None` before the first.
    pub fn estimates(&self) -> Option<[T; M]> {
        self.state.map(|Chain(z)| z)
    }

    /// What a sample that lies `surprise` beside its prediction adds to the backward differences.
    fn correction(&self, surprise: T, dt: T) -> [T; M] {
        let scale = self.bound * dt.powi(M as i32);
        if surprise.abs() <= self.lambda[M - 1] * scale {
            return [surprise; M];
        }
        let w = self.root(surprise.abs() / scale);
        let (mut power, mut sum) = (T::one(), T::zero());
        // λ_n·1, λ_{n−1}·w, …: the i-th state moves the differences up to the i-th.
        let mut moves = self.lambda;
        for entry in moves.iter_mut().rev() {
            sum += *entry * power;
            power *= w;
            *entry = (sum * scale).copysign(surprise);
        }
        moves
    }

    /// The root of wᴹ + λ₀·wⁿ + … + λ_n = `level` > λ_n.
    fn root(&self, level: T) -> T {
        // Every term is positive, so each alone bounds w from above.
        let linear = (level - self.lambda[M - 1]) / self.lambda[M - 2];
        let mut w = linear.min((level.ln() / constant(M as f64)).exp());
        // From above every step is down, until rounding ends it: quadratic convergence takes six or so.
        for _ in 0..64 {
            let (mut value, mut derivative) = (T::one(), T::zero());
            for lambda in self.lambda {
                derivative = derivative * w + value;
                value = value * w + lambda;
            }
            let next = w - (value - level) / derivative;
            // A quotient of infinities ends it too.
            let falls = next < w;
            if !falls {
                break;
            }
            w = next;
        }
        w
    }
}

impl<T: Scalar, const M: usize> Differentiator for RobustExact<T, M> {
    type Scalar = T;

    fn update_beyond(&mut self, y: T, known: T, dt: T) -> Result<T, Error> {
        let next =
            Chain::following(self.state, y, known, dt, |surprise| self.correction(surprise, dt))?;
        self.state = Some(next);
        Ok(next.0[1])
    }

    fn reset(&mut self) {
        self.state = None;
    }
}

checked! {
    [T: Scalar, const M: usize] RobustExact<T, M>, [T]
    { bound: T, state: Option<Array<T, M>> = state.map(|Chain(z)| Array(z)); lambda } =>
    Self::new(bound).and_then(|new| {
        let state = state.map(|z| Chain::known(z.0)).transpose()?;
        Ok(Self { state, ..new })
    })
}
