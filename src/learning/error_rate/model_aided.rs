use super::ErrorRate;
use crate::{
    Error, Scalar,
    differentiator::{BackwardDifference, Differentiator},
    learning::ClosedLoop,
    scalar::constant,
};

/// ė_n from the nominal model and the applied input, corrected by what x_n shows of the uncertainty: a disturbance observer.
///
/// Over the last period, under the input u that the plant really received, the model explains a change of x_n by
/// ½·dt·((a + b·u)(k−1) + (a + b·u)(k)). A [`Differentiator`] finds the rate Δ̂ of the rest, and
///
/// ė_n = −u_b − u_n − Δ̂, hence s = −(u_n + Δ̂).
///
/// By default it is the [`BackwardDifference`], and Δ̂ the mean uncertainty of the last period up to O(dt²). Behind noise, take one that
/// filters: with [`HighGain`](crate::differentiator::HighGain) it is the extended state observer. Its delay makes u_n late, but is not in the loop
/// that learns, because Δ̂ does not depend on u_n.
///
/// Without Δ̂ the model alone would give s = −u_n, which forgets and learns nothing. At the first sample Δ̂ = 0.
///
/// Neither a transient of the feedback nor a saturated actuator appears in s, provided that the applied input is reported.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ModelAided<T, D = BackwardDifference<T>> {
    differentiator: D,
    last: Option<Model<T>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Model<T> {
    drift: T,
    gain: T,
}

impl<T> ModelAided<T> {
    /// A source that has seen no sample yet.
    pub const fn new() -> Self {
        Self::through(BackwardDifference::new())
    }
}

impl<T, D> ModelAided<T, D> {
    /// The same with Δ̂ through another `differentiator`.
    pub const fn through(differentiator: D) -> Self {
        Self { differentiator, last: None }
    }
}

impl<T: Scalar, D: Differentiator<Scalar = T>, const N: usize> ErrorRate<T, N>
    for ModelAided<T, D>
{
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error> {
        let now = Model { drift: at.drift, gain: at.gain };
        let last = self.last.unwrap_or(now);
        // Halves first: a sum of two may leave the range where their mean does not.
        let mean = |a: T, b: T| a * constant(0.5) + b * constant(0.5);
        let predicted = mean(last.drift, now.drift) + mean(last.gain, now.gain) * at.u;
        let uncertainty = self.differentiator.update_beyond(at.x[N - 1], predicted * dt, dt)?;
        self.last = Some(now);
        Ok(-at.u_b - u_n - uncertainty)
    }
}

checked! {
    [T: Scalar] Model<T>, [T] { drift: T, gain: T } =>
    known("last a(x) and b(x)", [drift, gain]).map(|()| Self { drift, gain })
}

checked! {
    [T: Scalar, D] ModelAided<T, D>, [T, D] { differentiator: D, last: Option<Model<T>> } =>
    Ok(Self { differentiator, last })
}
