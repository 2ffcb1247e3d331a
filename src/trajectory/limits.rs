use nalgebra::SVector;

use super::Trajectory;
use crate::{
    Error, Scalar,
    error::{below, finite},
    scalar::constant,
};

/// The intervals between samples.
const INTERVALS: u32 = 1000;

/// The most that a trajectory asks for over a span of time: see [`Trajectory::limits`].
///
/// Without a closed form, each quantity is sampled at 1001 times, and every peak among the samples that could be the highest is refined
/// by golden section. A smooth quantity is then found to within rounding, never above; a peak narrower than 1/500 of the span can be
/// missed, so take a long trajectory in parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits<T> {
    /// max |ṙ|, in units of r a second.
    pub speed: T,
    /// max |r̈|, in units of r a second squared.
    pub acceleration: T,
    /// max |ẋ·ÿ − ẏ·ẍ|/|ṙ|², the rate at which the tangent turns, in rad/s. `None` for curves that are not planar, and for those that
    /// stop, where the tangent has no direction: if the least speed is below √ε (ε the resolution of `T`) of the greatest.
    pub yaw_rate: Option<T>,
}

impl<T: Scalar> Limits<T> {
    /// These limits, if the span and they are fit for use.
    pub(super) fn over(self, from: T, to: T) -> Result<Self, Error> {
        span(from, to)?;
        finite("speed", self.speed)?;
        finite("acceleration", self.acceleration)?;
        if let Some(yaw_rate) = self.yaw_rate {
            finite("yaw_rate", yaw_rate)?;
        }
        Ok(self)
    }

    pub(super) fn searched<P: Trajectory<D, Scalar = T> + ?Sized, const D: usize>(
        trajectory: &P,
        from: T,
        to: T,
    ) -> Result<Self, Error> {
        span(from, to)?;
        let at = |t| {
            let mut jet = [SVector::zeros(); 3];
            trajectory.derivatives(t, &mut jet);
            let [_, velocity, acceleration] = jet;
            (velocity, acceleration)
        };
        let maximum = |quantity: fn(&SVector<T, D>, &SVector<T, D>) -> T| {
            let quantity = |t| {
                let (velocity, acceleration) = at(t);
                quantity(&velocity, &acceleration)
            };
            maximum(quantity, from, to)
        };
        let speed = maximum(|v, _| v.norm());
        let acceleration = maximum(|_, a| a.norm());
        let stops = || -maximum(|v, _| -v.norm()) <= speed * T::default_epsilon().sqrt();
        let yaw_rate = if D != 2 || stops() { None } else { Some(maximum(turning)) };
        Self { speed, acceleration, yaw_rate }.over(from, to)
    }
}

fn span<T: Scalar>(from: T, to: T) -> Result<(), Error> {
    below("from", finite("from", from)?, finite("to", to)?)?;
    Ok(())
}

/// |ẋ·ÿ − ẏ·ẍ|/|ṙ|² in the plane; the division comes first, so that the square of a small speed cannot vanish.
fn turning<T: Scalar, const D: usize>(v: &SVector<T, D>, a: &SVector<T, D>) -> T {
    let speed = v.norm();
    match (v.as_slice(), a.as_slice()) {
        ([vx, vy], [ax, ay]) => (*vx / speed * (*ay / speed) - *vy / speed * (*ax / speed)).abs(),
        _ => T::zero(),
    }
}

/// The greatest value of `f` on \[from, to\]; one that is not finite, if there is one among the samples.
fn maximum<T: Scalar>(f: impl Fn(T) -> T, from: T, to: T) -> T {
    let step = (to - from) / constant(f64::from(INTERVALS));
    let time = |i: u32| if i < INTERVALS { from + step * constant(i.into()) } else { to };
    let mut before = f(from);
    let mut here = f(time(1));
    let mut highest = before.max(here).max(f(to));
    if !before.is_finite() {
        return before;
    }
    for i in 1..INTERVALS {
        let after = f(time(i + 1));
        if !here.is_finite() || !after.is_finite() {
            return here + after;
        }
        highest = highest.max(here);
        // Between samples a smooth peak rises by less than it falls to its lower neighbour. What is within rounding of the highest
        // counts as equal, or a constant would be refined everywhere.
        let reach = here - before.min(after);
        let rounding = highest.abs() * T::default_epsilon() * constant(8.0);
        if here >= before && here >= after && here + reach > highest + rounding {
            highest = highest.max(golden_section(&f, time(i - 1), time(i + 1)));
        }
        (before, here) = (here, after);
    }
    highest
}

/// The greatest value met while forty sections narrow a peak in \[low, high\] down by 0.618⁴⁰ ≈ 4·10⁻⁹.
fn golden_section<T: Scalar>(f: impl Fn(T) -> T, mut low: T, mut high: T) -> T {
    let ratio = constant::<T>(0.618_033_988_749_894_9);
    let inner = |low: T, high: T| (high - (high - low) * ratio, low + (high - low) * ratio);
    let (mut left, mut right) = inner(low, high);
    let (mut at_left, mut at_right) = (f(left), f(right));
    let mut highest = at_left.max(at_right);
    for _ in 0..40 {
        if at_left > at_right {
            (high, right, at_right) = (right, left, at_left);
            left = inner(low, high).0;
            at_left = f(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = inner(low, high).1;
            at_right = f(right);
        }
        highest = highest.max(at_left).max(at_right);
    }
    highest
}
