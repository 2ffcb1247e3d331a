use super::{Differentiator, chain::Chain};
use crate::{
    Error, Scalar,
    error::{finite, not_negative, positive},
    scalar::constant,
};

/// A linear observer of y and its M − 1 derivatives with all poles at −ω: the high-gain differentiator, and with a known input the extended
/// state observer.
///
/// żᵢ = zᵢ₊₁ + C(M, i+1)·ωⁱ⁺¹·(y − z₀), discretized as a current estimator: Taylor's formula predicts over the period, and the sample corrects
/// with the gains that put all M poles at q = e^(−ω·dt),
///
/// * first order (M = 2): z₀ += (1 − q²)·ε, z₁ += (1 − q)²·ε/dt
/// * second order (M = 3): z₀ += (1 − q³)·ε, z₁ += 3/2·(1 − q)²·(1 + q)·ε/dt, z₂ += (1 − q)³·ε/dt²
///
/// where ε = y − z₀ is what was not predicted. At the first sample z = (y, 0, …).
///
/// * Polynomials of degree M − 1 are followed exactly, whatever the periods are.
/// * Stable for every dt; as dt → ∞ it becomes the difference quotient. In first order V = ε₀² − 2·ε₀·ε₁/ω + 3·(ε₁/ω)² of the estimation errors
///   ε₀, ε₁ decreases over every period, so no sequence of periods can upset it either.
/// * First order: for constant dt a signal with |ÿ| ≤ L under noise |n| ≤ ε is differentiated with an error of at most
///   [`error_bound`](Self::error_bound); neither part of it can be less.
///
/// Behind [`ModelAided`](crate::learning::ModelAided), y = x_n with the known rate a + b·u, and z₁ is the extended state Δ̂.
///
/// # References
/// Z. Gao, "Scaling and bandwidth-parameterization based controller tuning", American Control Conference, 2003. R. Miklosovic, A. Radke, Z. Gao,
/// "Discrete implementation and generalization of the extended state observer", American Control Conference, 2006. The gains are those of
/// N. Morrison's fading-memory polynomial filter, "Introduction to Sequential Smoothing and Prediction", 1969.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HighGain<T, const M: usize> {
    bandwidth: T,
    state: Option<Chain<T, M>>,
}

impl<T: Scalar> HighGain<T, 2> {
    /// Observes y and ẏ with bandwidth ω > 0 in rad/s.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn first_order(bandwidth: T) -> Result<Self, Error> {
        Ok(Self { bandwidth: positive("bandwidth", bandwidth)?, state: None })
    }

    /// First order with ω⁵ = 32/3·L²/(σ²·dt) for white noise of standard deviation `noise` = σ > 0 and |ÿ| ≤ `bound` = L > 0: it makes the
    /// largest mean square error, (2L/ω)² + σ²·dt·ω³/4 for ω·dt ≪ 1, the least.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn for_noise(noise: T, bound: T, dt: T) -> Result<Self, Error> {
        let (noise, bound) = (positive("noise", noise)?, positive("bound on the rate", bound)?);
        let ratio = bound / noise;
        Self::first_order(fraction_of(32.0 / 3.0, ratio, positive("dt", dt)?).powf(constant(0.2)))
    }

    /// How late a slow signal is differentiated, in seconds: dt·(1 + q)/(1 − q) − dt/2.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `dt`.
    pub fn delay(&self, dt: T) -> Result<T, Error> {
        let (fall, keep) = self.fall(positive("dt", dt)?);
        finite("delay", dt * ((T::one() + keep) / fall - constant(0.5)))
    }

    /// The largest error of ẏ, once the start is forgotten, for |ÿ| ≤ `bound` = L and noise of at most `noise` = ε, at constant `dt`:
    /// L·delay + 2ε·(1 − q)²·(m + 1)·qᵐ/dt with m the whole part of q/(1 − q); for ω·dt ≪ 1 that is 2L/ω + 2εω/e.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotPositive`] or [`Error::NonFinite`] for a parameter out of range.
    pub fn error_bound(&self, bound: T, noise: T, dt: T) -> Result<T, Error> {
        let late = not_negative("bound on the rate", bound)? * self.delay(dt)?;
        let (fall, keep) = self.fall(dt);
        // The response of z₁ to one sample is (1 − q)²·qᵏ⁻¹·(q − k·(1 − q))/dt: positive up to m, negative after, and its sum is 0.
        let turn = (keep / fall).floor();
        let gain = fall * fall * (turn + T::one()) * keep.powf(turn) / dt;
        let shaken = not_negative("noise", noise)? * constant(2.0) * gain;
        finite("error bound", late + shaken)
    }
}

impl<T: Scalar> HighGain<T, 3> {
    /// Observes y, ẏ and ÿ with bandwidth ω > 0 in rad/s.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn second_order(bandwidth: T) -> Result<Self, Error> {
        Ok(Self { bandwidth: positive("bandwidth", bandwidth)?, state: None })
    }

    /// Second order with ω⁷ = 48/7·L²/(σ²·dt) for white noise of standard deviation `noise` = σ > 0 and |y⃛| ≤ `bound` = L > 0: it makes the
    /// largest mean square error, (3L/ω²)² + 7/4·σ²·dt·ω³ for ω·dt ≪ 1, the least.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn for_noise(noise: T, bound: T, dt: T) -> Result<Self, Error> {
        let (noise, bound) = (positive("noise", noise)?, positive("bound on the rate", bound)?);
        let ratio = bound / noise;
        let power = fraction_of(48.0 / 7.0, ratio, positive("dt", dt)?);
        Self::second_order(power.powf(constant(1.0 / 7.0)))
    }
}

/// `factor`·`ratio`²/`dt`.
fn fraction_of<T: Scalar>(factor: f64, ratio: T, dt: T) -> T {
    constant::<T>(factor) * ratio * ratio / dt
}

impl<T: Scalar, const M: usize> HighGain<T, M> {
    /// The bandwidth ω in rad/s.
    pub fn bandwidth(&self) -> T {
        self.bandwidth
    }

    /// y and its derivatives at the last sample; `None` before the first.
    pub fn estimates(&self) -> Option<[T; M]> {
        self.state.map(|Chain(z)| z)
    }

    /// 1 − q and q, each without cancellation.
    fn fall(&self, dt: T) -> (T, T) {
        let exponent = -self.bandwidth * dt;
        (-exponent.exp_m1(), exponent.exp())
    }

    /// The gains in backward differences: (1 − q)ⁱ⁺¹·Σ_j C(i + j, j)·qʲ over j < M − i.
    fn gains(&self, dt: T) -> [T; M] {
        let (p, q) = self.fall(dt);
        let mut gains = [T::zero(); M];
        match gains.as_mut_slice() {
            [value, rate] => {
                *value = p * (T::one() + q);
                *rate = p * p;
            }
            [value, rate, second] => {
                *value = p * (T::one() + q + q * q);
                *rate = p * p * (T::one() + q + q);
                *second = p * p * p;
            }
            // No other order has a constructor.
            _ => {}
        }
        gains
    }
}

impl<T: Scalar, const M: usize> Differentiator for HighGain<T, M> {
    type Scalar = T;

    fn update_beyond(&mut self, y: T, known: T, dt: T) -> Result<T, Error> {
        let next = Chain::following(self.state, y, known, dt, |surprise| {
            self.gains(dt).map(|gain| gain * surprise)
        })?;
        self.state = Some(next);
        Ok(next.0[1])
    }

    fn reset(&mut self) {
        self.state = None;
    }
}

checked! {
    [T: Scalar, const M: usize] HighGain<T, M>, [T]
    { bandwidth: T, state: Option<Array<T, M>> = state.map(|Chain(z)| Array(z)) } =>
    positive("bandwidth", bandwidth).and_then(|_| match M {
        2 | 3 => {
            let state = state.map(|z| Chain::known(z.0)).transpose()?;
            Ok(Self { bandwidth, state })
        }
        // No other order has a constructor.
        _ => Err(Error::Length { name: "estimate", expected: 3, found: M }),
    })
}
