use nalgebra::SVector;

use super::{Accept, Command, Controller, Gains, Measurement, Reference};
use crate::{
    Error, Scalar,
    error::{finite, finite_vector, not_negative, positive, remembered, value},
    scalar::constant,
};

/// Linear active disturbance rejection control: u = b₀⁻¹·(u_f + u_b − f̂) with u_f = ṙ_n, u_b = k·(r − z), z and f̂ from an extended state observer.
///
/// For a plant y⁽ᴺ⁾ = f(t, …) + b₀·u of which the order and b₀ are known, and nothing else: all the rest is f, the total disturbance. The
/// observer has all N + 1 poles at −ω_o and sees y = x₁ alone,
///
/// ż_i = z_{i+1} + β_i·(y − z₁), ż_N = f̂ + b₀·u + β_N·(y − z₁), d/dt f̂ = β_{N+1}·(y − z₁), β_i = C(N+1, i)·ω_oⁱ,
///
/// and the loop becomes ė_n + k·e = k·(z − x) + f̂ − f. With [`Gains::from_lambda`] of ω_c the two bandwidths are all there is to tune: ω_o three
/// to ten times ω_c, as the noise of y allows.
///
/// # In samples
/// A current estimator: over the period z moves as the chain does under the held f̂ + b₀·u, which is exact, and the sample corrects it by gains
/// that put all poles at q = e^(−ω_o·dt). Stable at every dt, a different one at every sample too if N = 1. At the first sample z = (y, 0, …), f̂
/// = 0.
///
/// The observer is fed with the input that arrived, if that is reported: a saturated actuator is no disturbance, and there is no other integral
/// that could wind up.
///
/// Assumes that the sign of b₀ is that of b. What b differs from b₀ is in f as (b − b₀)·u. Of the state only x₁ is used; the other entries have to be
/// finite, zeros will do.
///
/// # References
/// J. Han, "From PID to active disturbance rejection control", IEEE Transactions on Industrial Electronics 56(3), 2009. Z. Gao, "Scaling and
/// bandwidth-parameterization based controller tuning", American Control Conference, 2003. R. Miklosovic, A. Radke, Z. Gao, "Discrete
/// implementation and generalization of the extended state observer", American Control Conference, 2006. Q. Zheng, L. Gao, Z. Gao, "On stability
/// analysis of active disturbance rejection control for nonlinear time-varying plants with unknown dynamics", Conference on Decision and Control,
/// 2007.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActiveDisturbanceRejection<T, const N: usize> {
    gains: Gains<T, N>,
    bandwidth: T,
    input_gain: T,
    last: Option<Estimated<T, N>>,
}

/// What is known at a sample: z, f̂, and the input that was asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Estimated<T, const N: usize> {
    z: SVector<T, N>,
    f: T,
    u: T,
}

/// An input of [`ActiveDisturbanceRejection`] and its shares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActiveDisturbanceRejectionCommand<T, const N: usize> {
    /// The input u, in the plant's units.
    pub u: T,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// The feedback u_b = k·(r − z), in the units of ẋ_n.
    pub u_b: T,
    /// The estimated total disturbance f̂, in the units of ẋ_n.
    pub f: T,
    /// The estimated state z.
    pub z: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Command<T, 1> for ActiveDisturbanceRejectionCommand<T, N> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

impl<T: Scalar, const N: usize> ActiveDisturbanceRejection<T, N> {
    /// Feedback with `gains`, an observer of bandwidth ω_o > 0 in rad/s, and the input gain b₀ ≠ 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `bandwidth`; [`Error::NonFinite`] or [`Error::Singular`] for `input_gain`.
    pub fn new(gains: Gains<T, N>, bandwidth: T, input_gain: T) -> Result<Self, Error> {
        positive("bandwidth", bandwidth)?;
        if finite("b0", input_gain)?.is_zero() {
            return Err(Error::Singular { name: "b0", value: value(input_gain) });
        }
        Ok(Self { gains, bandwidth, input_gain, last: None })
    }

    /// The feedback gains.
    pub fn gains(&self) -> &Gains<T, N> {
        &self.gains
    }

    /// The bandwidth ω_o of the observer in rad/s.
    pub fn bandwidth(&self) -> T {
        self.bandwidth
    }

    /// The largest error of f̂ at the samples of period `dt`, once the start is forgotten, while |ḟ| ≤ `bound` = L:
    /// L·dt·((N + 1)·q/(1 − q) + N/2), for ω_o·dt ≪ 1 that is (N + 1)·L/ω_o.
    ///
    /// f̂ is a mean of the past f with positive weights, so the error is at most L times their mean age, and that for a steady ḟ.
    ///
    /// # Errors
    /// [`Error::Negative`] for the bound, [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] for them, or an error beyond the range of `T`.
    pub fn disturbance_error(&self, bound: T, dt: T) -> Result<T, Error> {
        let order = constant::<T>(N as f64);
        let age = (order + T::one()) * self.kept(positive("dt", dt)?) + order * constant(0.5);
        let bound = not_negative("bound on the rate of the disturbance", bound)?;
        finite("error of the disturbance", bound * (dt * age))
    }

    /// The largest error of z₁ at the samples in the same sense: L·(dt·q/(1 − q))ᴺ⁺¹, for ω_o·dt ≪ 1 that is L/ω_oᴺ⁺¹.
    ///
    /// # Errors
    /// As [`disturbance_error`](Self::disturbance_error).
    pub fn output_error(&self, bound: T, dt: T) -> Result<T, Error> {
        let scale = dt * self.kept(positive("dt", dt)?);
        let bound = not_negative("bound on the rate of the disturbance", bound)?;
        finite("error of the output", bound * scale.powi(N as i32 + 1))
    }

    /// q/(1 − q).
    fn kept(&self, dt: T) -> T {
        (self.bandwidth * dt).exp_m1().recip()
    }

    /// z and f̂ after `dt` under the input `u`, by Taylor's formula.
    fn predicted(&self, last: &Estimated<T, N>, u: T, dt: T) -> SVector<T, N> {
        let driven = last.f + self.input_gain * u;
        SVector::from_fn(|i, _| {
            // Horner's scheme, from the input of the chain down.
            let mut tail = driven * dt / constant((N - i) as f64);
            for j in (i + 1..N).rev() {
                tail = (last.z[j] + tail) * dt / constant((j - i) as f64);
            }
            last.z[i] + tail
        })
    }

    /// What a sample `surprise` above its prediction adds to z and f̂.
    ///
    /// It is the polynomial with the backward differences ∇ᵐ = g_m·surprise, g_m = (1 − q)ᵐ⁺¹·Σ_j C(m + j, j)·qʲ over j ≤ N − m, which put all
    /// poles at q; its derivatives are those of (dt·D)ⁱ = (−ln(1 − ∇))ⁱ = Σ_m c(m, i)·∇ᵐ.
    fn correction(&self, surprise: T, dt: T) -> (SVector<T, N>, T) {
        let exponent = -self.bandwidth * dt;
        let (p, q) = (-exponent.exp_m1(), exponent.exp());
        // The row c(m, ·), without c(N, N) = 1.
        let mut row = SVector::from_fn(|i, _| if i == 0 { T::one() } else { T::zero() });
        let mut scaled = SVector::<T, N>::zeros();
        let mut power = p;
        for m in 0..N {
            let gain = power * partial_sum(q, m, N - m) * surprise;
            scaled += row * gain;
            power *= p;
            // m·c(m, i) = (m − 1)·c(m − 1, i) + i·c(m − 1, i − 1)
            let next = constant::<T>((m + 1) as f64);
            for i in (1..N).rev() {
                row[i] = (constant::<T>(m as f64) * row[i] + constant::<T>(i as f64) * row[i - 1])
                    / next;
            }
            row[0] = T::zero();
        }
        let last = power * surprise;
        scaled += row * last;
        let mut scale = T::one();
        for entry in scaled.iter_mut() {
            *entry /= scale;
            scale *= dt;
        }
        (scaled, last / scale)
    }

    /// z and f̂ at a sample y under which the input `u` arrived.
    fn estimated(&self, y: T, arrived: Option<T>, dt: T) -> Result<(SVector<T, N>, T), Error> {
        // What a difference of y is divided by at most.
        remembered("y/dt^n", y, dt.powi(N as i32).min(dt))?;
        let Some(last) = &self.last else {
            return Ok((SVector::from_fn(|i, _| if i == 0 { y } else { T::zero() }), T::zero()));
        };
        let predicted = self.predicted(last, arrived.unwrap_or(last.u), dt);
        let (z, f) = self.correction(y - predicted[0], dt);
        let (z, f) = (predicted + z, last.f + f);
        finite_vector("z", &z)?;
        Ok((z, finite("f", f)?))
    }
}

/// Σ C(m + j, j)·qʲ over j ≤ `count`.
fn partial_sum<T: Scalar>(q: T, m: usize, count: usize) -> T {
    let (mut sum, mut term) = (T::one(), T::one());
    for j in 1..=count {
        term *= q * constant((m + j) as f64) / constant(j as f64);
        sum += term;
    }
    sum
}

impl<T: Scalar, const N: usize> Controller<N, 1> for ActiveDisturbanceRejection<T, N> {
    type Scalar = T;
    type Reference = Reference<T, N>;
    type Command = ActiveDisturbanceRejectionCommand<T, N>;

    /// # Errors
    /// [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] and [`Error::NonFiniteEntry`] for the measurement, the reference, the estimates and
    /// u, also where they are too large to be remembered.
    fn update_if(
        &mut self,
        measurement: &Measurement<T, N, 1>,
        reference: &Self::Reference,
        dt: T,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        positive("dt", dt)?;
        measurement.validate()?;
        reference.validate()?;
        let arrived = measurement.applied.map(|applied| applied[0]);
        let (z, f) = self.estimated(measurement.x[0], arrived, dt)?;
        let (u_f, u_b) =
            (reference.r_n_dot, finite("u_b", self.gains.feedback(&(reference.r - z)))?);
        let nu = finite("u_f + u_b - f", u_f + u_b - f)?;
        let u = remembered("u", nu / self.input_gain, T::one())?;
        let command = ActiveDisturbanceRejectionCommand { u, u_f, u_b, f, z };
        accept(&command)?;
        self.last = Some(Estimated { z, f, u });
        Ok(command)
    }

    fn reset(&mut self) {
        self.last = None;
    }
}

checked! {
    [T: Scalar, const N: usize] Estimated<T, N>, [T] { z: SVector<T, N>, f: T, u: T } =>
    known("z", z.iter().copied()).and_then(|()| {
        known("f and last u", [f, u])?;
        Ok(Self { z, f, u })
    })
}

checked! {
    [T: Scalar, const N: usize] ActiveDisturbanceRejection<T, N>, [T]
    {
        gains: Gains<T, N>,
        bandwidth: T,
        input_gain: T,
        last: Option<Estimated<T, N>>,
    } =>
    Self::new(gains, bandwidth, input_gain).map(|new| Self { last, ..new })
}
