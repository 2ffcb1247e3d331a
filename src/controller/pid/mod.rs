//! Proportional, integral and derivative feedback, as process control has it.
//!
//! | part | what it is |
//! |---|---|
//! | [`Pid`] | the law, sampled |
//! | [`PidGains`] | its gains, times and weights |
//! | [`AntiWindup`] | what happens to the integral while something else than asked for arrives |

mod anti_windup;
mod gains;

pub use anti_windup::AntiWindup;
pub use gains::PidGains;

use nalgebra::SVector;

use super::{Accept, Command, Controller, Measurement, Reference};
use crate::{
    Error, Scalar,
    error::{finite, positive, remembered},
};

/// PID control with two degrees of freedom: u = K·(b·r − y) + I + D, İ = k_i·(r − y), T_f·Ḋ + D = k_d·d/dt(c·r − y).
///
/// It needs no model and looks at y = x₁ and r = r₁ alone, whatever the order N. u is in the plant's units. Sampled with period h:
///
/// ```text
/// I(k) = I(k−1) + h·k_i·e(k−1) + what anti-windup adds
/// D(k) = (T_f·D(k−1) + k_d·(w(k) − w(k−1)))/(T_f + h),   w = c·r − y
/// ```
///
/// The difference quotient of D is the backward one: it is stable for every h. At the first sample I = D = 0, so nothing kicks.
///
/// # Without a bump
/// * **Start**: [`start_at`](Self::start_at) makes the next output a given one, and the integral what is left of it.
/// * **Somebody else drives**, and reports it as the applied input ([`Supervised`](super::Supervised) does): with
///   [`AntiWindup::BackCalculation`] the output follows within T_t, with T_t = 0 from sample to sample.
/// * **New gains**: [`set_gains`](Self::set_gains) moves into the integral what would jump.
///
/// Without integral action (k_i = 0) I is a constant bias, 0 unless one of these made it another.
///
/// Assumes a loop that such feedback stabilizes. It promises nothing about that; a constant Δ leaves no error if it does and k_i ≠ 0.
///
/// ```
/// use brunovsky::{channel::Saturation, controller::{AntiWindup, Pid, PidGains}, plant::IntegratorChain, prelude::*};
///
/// // A mass of 1 kg: the force, within ±1 N, has to hold it against 0.5 N that nobody told the controller of.
/// let pushed = Uncertain::matched(IntegratorChain::<f64, 2>::new(), |_: f64, _: &_, _: &_| 0.5);
/// let gains = PidGains::new(4.0)?.with_integral_time(2.0)?.with_derivative_time(0.8, 0.05)?;
/// let pid = Pid::new(gains, AntiWindup::BackCalculation { tracking_time: 1.0 })?;
/// let limited = Limited::new(pid, Saturation::symmetric([1.0])?);
/// let run = Simulation::new(&pushed, limited, |_| Reference::setpoint(3.0), [0.0, 0.0], 0.01)?;
/// let last = run.until(30.0)?.last().ok_or(Error::Missing { name: "sample" })??;
/// assert!((last.x[0] - 3.0).abs() < 1e-4 && (last.u[0] + 0.5).abs() < 1e-3);
/// # Ok::<(), Error>(())
/// ```
///
/// # References
/// K. J. Åström, T. Hägglund, *PID Controllers: Theory, Design, and Tuning*, 2nd ed. 1995, chapter 3: eq. 3.19 (set-point weights), 3.5
/// (windup), 3.6 (discretization; bumpless changes).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pid<T, const N: usize> {
    gains: PidGains<T>,
    anti_windup: AntiWindup<T>,
    start: Option<T>,
    last: Option<Past<T>>,
}

/// What the law remembers of a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Past<T> {
    i: T,
    d: T,
    r: T,
    y: T,
    /// What was asked for.
    u: T,
}

/// An input of [`Pid`] and its shares, all in the plant's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PidCommand<T> {
    /// The input u.
    pub u: T,
    /// The proportional share K·(b·r − y).
    pub u_p: T,
    /// The integral share I.
    pub u_i: T,
    /// The derivative share D.
    pub u_d: T,
}

impl<T: Scalar> Command<T, 1> for PidCommand<T> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

impl<T: Scalar, const N: usize> Pid<T, N> {
    /// A controller with `gains`, and with an integral that `anti_windup` looks after.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`] for the number in `anti_windup`.
    pub fn new(gains: PidGains<T>, anti_windup: AntiWindup<T>) -> Result<Self, Error> {
        const { assert!(N > 0, "a chain has at least one integrator") };
        Ok(Self { gains, anti_windup: anti_windup.validated()?, start: None, last: None })
    }

    /// The gains.
    pub fn gains(&self) -> &PidGains<T> {
        &self.gains
    }

    /// Other gains, from the next sample on, without a jump of u: I takes over what the change of K, of b or of a derivative that is switched
    /// off would add, K·(b·r − y) before less after.
    ///
    /// # Errors
    /// [`Error::NonFinite`] if the integral would leave the range of `T`; the gains are then as before.
    pub fn set_gains(&mut self, gains: PidGains<T>) -> Result<(), Error> {
        let last = self.last.map(|last| {
            let Past { r, y, .. } = last;
            let (i, d) =
                if gains.k_d.is_zero() { (last.i + last.d, T::zero()) } else { (last.i, last.d) };
            let i = i + (self.gains.proportional(r, y) - gains.proportional(r, y));
            Past { i, d, ..last }.lasting(&gains, T::one())
        });
        self.last = last.transpose()?;
        self.gains = gains;
        Ok(())
    }

    /// Makes the output of the next sample `u`, by the choice of I: where another controller or an operator left off.
    ///
    /// # Errors
    /// [`Error::NonFinite`]; nothing has changed then.
    pub fn start_at(&mut self, u: T) -> Result<(), Error> {
        self.start = Some(finite("u", u)?);
        Ok(())
    }

    /// I at this sample, before a choice of [`start_at`](Self::start_at).
    fn integral(&self, applied: Option<T>, dt: T) -> T {
        let Some(Past { i, r, y, u, .. }) = self.last else { return T::zero() };
        let excess = applied.map_or(T::zero(), |applied| u - applied);
        self.anti_windup.integral(i, self.gains.k_i * (r - y) * dt, excess, dt)
    }

    /// D at this sample.
    fn derivative(&self, r: T, y: T, dt: T) -> T {
        let Some(last) = self.last else { return T::zero() };
        let PidGains { k_d, t_f, .. } = self.gains;
        let moved = self.gains.differentiated(r, y) - self.gains.differentiated(last.r, last.y);
        last.d * (t_f / (t_f + dt)) + k_d / (t_f + dt) * moved
    }
}

impl<T: Scalar> Past<T> {
    /// The same, if the next samples can be computed from it within the range of `T`, over periods like `dt`.
    fn lasting(self, gains: &PidGains<T>, dt: T) -> Result<Self, Error> {
        let Self { i, d, r, y, u } = self;
        remembered("integral", i, T::one())?;
        remembered("derivative", d, T::one())?;
        remembered("u", u, T::one())?;
        remembered("integrated error", gains.k_i * (r - y) * dt, T::one())?;
        remembered("x", gains.differentiated(r, y), T::one())?;
        remembered("derivative", gains.k_d * gains.differentiated(r, y), gains.t_f)?;
        Ok(self)
    }
}

impl<T: Scalar, const N: usize> Controller<N, 1> for Pid<T, N> {
    type Scalar = T;
    type Reference = Reference<T, N>;
    type Command = PidCommand<T>;

    /// # Errors
    /// [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] and [`Error::NonFiniteEntry`] for `dt`, the measurement, the reference, u, and for
    /// shares of u that are too large to be remembered.
    fn update_if(
        &mut self,
        measurement: &Measurement<T, N, 1>,
        reference: &Reference<T, N>,
        dt: T,
        accept: Accept<PidCommand<T>>,
    ) -> Result<PidCommand<T>, Error> {
        positive("dt", dt)?;
        measurement.validate()?;
        reference.validate()?;
        let (r, y) = (reference.r[0], measurement.x[0]);
        let u_p = finite("proportional share", self.gains.proportional(r, y))?;
        let u_d = self.derivative(r, y, dt);
        let u_i = match self.start {
            Some(u) => u - u_p - u_d,
            None => self.integral(measurement.applied.map(|applied| applied[0]), dt),
        };
        let u = self.start.unwrap_or(u_p + u_i + u_d);
        let now = Past { i: u_i, d: u_d, r, y, u }.lasting(&self.gains, dt)?;
        let command = PidCommand { u, u_p, u_i, u_d };
        accept(&command)?;
        (self.start, self.last) = (None, Some(now));
        Ok(command)
    }

    fn reset(&mut self) {
        (self.start, self.last) = (None, None);
    }
}

checked! {
    [T: Scalar] Past<T>, [T] { i: T, d: T, r: T, y: T, u: T } =>
    known("last sample", [i, d, r, y, u]).map(|()| Self { i, d, r, y, u })
}

checked! {
    [T: Scalar, const N: usize] Pid<T, N>, [T]
    { gains: PidGains<T>, anti_windup: AntiWindup<T>, start: Option<T>, last: Option<Past<T>> } =>
    Self::new(gains, anti_windup).and_then(|new| {
        known("u", start)?;
        // The shortest of all periods refuses nothing that any other accepts.
        let last = last.map(|last| last.lasting(&gains, T::zero())).transpose()?;
        Ok(Self { start, last, ..new })
    })
}
