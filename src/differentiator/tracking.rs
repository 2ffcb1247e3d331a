use super::{Differentiator, HighGain, validated};
use crate::{
    Error, Scalar,
    error::{finite, positive},
    scalar::constant,
};

/// Han's tracking differentiator: a double integrator that follows y in the least time an acceleration of ±r allows, and whose velocity is ẏ̂.
///
/// x₁(k) = x₁(k−1) + h·x₂(k−1), x₂(k) = x₂(k−1) + h·fhan(x₁(k−1) − y(k), x₂(k−1), r, T)
///
/// fhan is the closed-form optimal control of the *sampled* double integrator with period T ≥ h: ±r far from the target, and inside a layer of
/// width r·T² around it linear, −(x₁ − y + 2T·x₂)/T². So nothing chatters. A T shorter than the period counts as the period.
///
/// * A step of height S is reached in 2·√(S/r) seconds and T, without overshoot: it is a filter against outliers and a generator of smooth
///   references too. It needs r > |ÿ|.
/// * In the layer, x₂ is the rate of [`HighGain`] of first order with q = 1 − h/T: its delay is 2T − 3h/2. That x₁ lags behind y by 2T − h seconds
///   shows as an error of x₂ where the period jitters; the others have none on a ramp.
///
/// * Beyond the layer, where |ẏ| > r·T, it lags by |ẏ|/(2r) seconds: it only goes as fast as it can still brake for y.
///
/// At the first sample (x₁, x₂) = (y, 0).
///
/// The linear tracking differentiator is the same without the limit r; take [`HighGain`] for it, whose poles are exact at every dt.
///
/// # References
/// J. Han, "From PID to active disturbance rejection control", IEEE Transactions on Industrial Electronics 56(3), 2009.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tracking<T> {
    acceleration: T,
    horizon: T,
    state: Option<(T, T)>,
}

impl<T: Scalar> Tracking<T> {
    /// Follows with at most `acceleration` = r > 0, in the units of ÿ, over a `horizon` of T > 0 seconds.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(acceleration: T, horizon: T) -> Result<Self, Error> {
        Ok(Self {
            acceleration: positive("acceleration", acceleration)?,
            horizon: positive("horizon", horizon)?,
            state: None,
        })
    }

    /// T = 1/ω with the bandwidth of [`HighGain::for_noise`] for white noise of standard deviation `noise` = σ > 0 and |ÿ| ≤ `bound` = L > 0, and
    /// r = 2L + 3σ/T²: twice what the signal needs, and what keeps noise of three standard deviations in the layer.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn for_noise(noise: T, bound: T, dt: T) -> Result<Self, Error> {
        let bandwidth = HighGain::<T, 2>::for_noise(noise, bound, dt)?.bandwidth();
        let spread = constant::<T>(3.0) * noise * bandwidth * bandwidth;
        Self::new(constant::<T>(2.0) * bound + spread, T::one() / bandwidth)
    }

    /// (x₁, x₂), the signal followed and its rate, at the last sample; `None` before the first.
    pub fn estimates(&self) -> Option<(T, T)> {
        self.state
    }

    /// fhan(x₁, x₂, r, T).
    fn optimal(&self, x1: T, x2: T, horizon: T) -> T {
        let r = self.acceleration;
        let layer = r * horizon * horizon;
        let step = horizon * x2;
        let y = x1 + step;
        let a = if y.abs() <= layer {
            step + y
        } else {
            let reach = (layer * (layer + constant::<T>(8.0) * y.abs())).sqrt();
            step + ((reach - layer) * constant(0.5)).copysign(y)
        };
        -r * (a / layer).clamp(-T::one(), T::one())
    }
}

impl<T: Scalar> Differentiator for Tracking<T> {
    type Scalar = T;

    fn update_beyond(&mut self, y: T, known: T, dt: T) -> Result<T, Error> {
        validated("y/dt", y, known, dt, dt)?;
        let (x1, x2) = match self.state {
            None => (y, T::zero()),
            Some((x1, x2)) => {
                let x1 = x1 + known;
                let acceleration = self.optimal(x1 - y, x2, self.horizon.max(dt));
                (x1 + dt * x2, x2 + dt * acceleration)
            }
        };
        finite("followed y", x1)?;
        self.state = Some((x1, finite("rate of y", x2)?));
        Ok(x2)
    }

    fn reset(&mut self) {
        self.state = None;
    }
}

checked! {
    [T: Scalar] Tracking<T>, [T] { acceleration: T, horizon: T, state: Option<(T, T)> } =>
    Self::new(acceleration, horizon).and_then(|new| {
        known("followed y and its rate", state.into_iter().flat_map(|(y, rate)| [y, rate]))?;
        Ok(Self { state, ..new })
    })
}
