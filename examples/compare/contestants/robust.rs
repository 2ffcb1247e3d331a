//! Sliding modes: their gain is chosen above a bound on Δ or Δ̇.

use brunovsky::{
    controller::sliding_mode::{
        IntegralSlidingMode, SlidingModeControl, SlidingSurface, Stepping, SuperTwisting,
        SuperTwistingGains,
    },
    prelude::*,
};

use super::{Contestant, Facts, around};

/// First order with the set-valued sign and with a boundary layer, super-twisting, integral sliding mode.
pub fn of<P, const N: usize>(model: P, facts: Facts<N>) -> Vec<Contestant<N>>
where
    P: FeedbackLinearizable<N, Scalar = f64> + Copy + Send + Sync + 'static,
{
    let Facts { rate, delta, period, .. } = facts;
    let lambda = facts.lambda();
    let gain = ("k", around(delta, 10.0));
    // In the units of σ, of what Δ moves in a period.
    let layer = ("δ", [0.1 * delta * period, 1000.0 * delta * period]);
    let rate_bound = ("L", around(delta * rate, 100.0));
    vec![
        Contestant::new(
            "sliding mode, set-valued",
            "x, model, bound on Δ",
            &[lambda, gain],
            move |p| SlidingModeControl::new(model, SlidingSurface::from_lambda(p[0])?, p[1]),
        ),
        Contestant::new(
            "sliding mode, boundary layer",
            "x, model, bound on Δ",
            &[lambda, gain, layer],
            move |p| {
                SlidingModeControl::new(model, SlidingSurface::from_lambda(p[0])?, p[1])?
                    .with_switching(Switching::Implicit { delta: p[2] })
            },
        ),
        Contestant::new(
            "super-twisting",
            "x, model, bound on Δ̇",
            &[lambda, rate_bound],
            move |p| {
                let gains = SuperTwistingGains::for_rate(p[1])?;
                Ok(SuperTwisting::new(model, SlidingSurface::from_lambda(p[0])?, gains))
            },
        ),
        Contestant::new(
            "super-twisting, explicit",
            "x, model, bound on Δ̇",
            &[lambda, rate_bound],
            move |p| {
                let gains = SuperTwistingGains::for_rate(p[1])?;
                let law = SuperTwisting::new(model, SlidingSurface::from_lambda(p[0])?, gains);
                Ok(law.with_stepping(Stepping::Explicit))
            },
        ),
        Contestant::new(
            "integral sliding mode",
            "x, model, bound on Δ",
            &[lambda, gain, layer],
            move |p| {
                let flc = FeedbackLinearization::new(model, Gains::from_lambda(p[0])?);
                let mode = IntegralSlidingMode::new(p[1])?
                    .with_switching(Switching::Implicit { delta: p[2] })?;
                Ok(Clelc::new(flc, mode))
            },
        ),
    ]
}
