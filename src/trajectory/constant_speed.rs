use nalgebra::SVector;

use super::{
    Trajectory,
    arc_length::{Arc, ORDER},
    minimum_jerk::finite_points,
    spline::{End, Spline, locate},
};
use crate::{
    Error, Scalar,
    error::{finite, positive},
    scalar::constant,
};

/// A smooth curve through M waypoints, traversed with |ṙ| = v: r(t) = x(u(v·t)), u the inverse of the arc length s(u) = ∫|x′| du.
///
/// x is the quintic spline of least ∫|x⃛|² du, u being the length of the polygon through the waypoints; its ends are free. Waypoints
/// on a line give that line. Free ends cost accuracy: with waypoints h apart on a smooth curve, the spline is off that curve by O(h³) within
/// a few waypoints of an end and by O(h⁶) elsewhere, and its length by O(h⁴).
///
/// The arc length is integrated to rounding, and inverted by at most 64 safeguarded Newton steps at every call. Speed is exact to
/// rounding, whatever remains of that.
///
/// Before the first waypoint (t < 0) and after the last, it goes on along the tangent with the same speed. Four continuous derivatives
/// between the ends, of which the fifth is piecewise smooth; one at the ends, where the curvature stops.
///
/// Derivatives are exact up to the fifth. Higher ones are not computed: between the ends they are NaN, which every controller refuses.
///
/// ```
/// use brunovsky::trajectory::{ConstantSpeed, Trajectory};
///
/// let r = ConstantSpeed::new([[0.0, 0.0], [2.0, 0.0], [4.0, 1.0], [4.0, 3.0]], 0.5_f64)?;
/// let [_, velocity] = r.jet(0.5 * r.duration());
/// assert!((velocity.norm() - 0.5).abs() < 1e-12);
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstantSpeed<T, const D: usize, const M: usize> {
    spline: Spline<T, D, M>,
    /// The arc length at each waypoint, and the panels of the quadrature after it.
    lengths: [T; M],
    panels: [u32; M],
    speed: T,
    length: T,
    duration: T,
}

impl<T: Scalar, const D: usize, const M: usize> ConstantSpeed<T, D, M> {
    /// Through `points` with `speed` v > 0, at the first one at t = 0.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], for `points` with the coordinates counted through; [`Error::NotPositive`] for the speed and for equal
    /// consecutive points; [`Error::NonFinite`] and [`Error::NonFiniteEntry`] for what leaves the range of `T`; [`Error::Singular`] if the
    /// curve turns on the spot, as on the way there and back, or so nearly that 128 panels a segment do not resolve it.
    pub fn new(points: [[T; D]; M], speed: T) -> Result<Self, Error> {
        const { assert!(M >= 2, "a curve goes through two points at least") };
        let points = finite_points(&points)?;
        positive("speed", speed)?;
        let mut knots = [T::zero(); M];
        let mut u = T::zero();
        for (knot, pair) in knots.iter_mut().skip(1).zip(points.windows(2)) {
            if let [before, after] = pair {
                u += positive("distance between consecutive points", (after - before).norm())?;
            }
            *knot = u;
        }
        let spline = Spline::new(&points, &knots, [straight(&points, u); 2])?;
        let (mut lengths, mut panels) = ([T::zero(); M], [0; M]);
        let mut length = T::zero();
        for (i, (start, panels)) in lengths.iter_mut().zip(&mut panels).enumerate() {
            *start = length;
            if let Some((_, segment)) = spline.segment(i) {
                let arc = Arc::new(segment)?;
                length += arc.length;
                *panels = arc.panels;
            }
        }
        let duration = finite("duration", length / speed)?;
        Ok(Self { spline, lengths, panels, speed, length, duration })
    }

    /// The length of the curve from the first waypoint to the last.
    pub fn length(&self) -> T {
        self.length
    }

    /// The time from the first waypoint to the last, in seconds.
    pub fn duration(&self) -> T {
        self.duration
    }

    /// Segment `i` and the arc length where it begins.
    fn arc(&self, i: usize) -> Option<(T, Arc<T, D>)> {
        let (start, end) = (*self.lengths.get(i)?, *self.lengths.get(i + 1)?);
        let (_, segment) = self.spline.segment(i)?;
        Some((start, Arc { segment, length: end - start, panels: *self.panels.get(i)? }))
    }
}

impl<T: Scalar, const D: usize, const M: usize> Trajectory<D> for ConstantSpeed<T, D, M> {
    type Scalar = T;

    fn derivatives(&self, t: T, out: &mut [SVector<T, D>]) {
        let Some([first, last]) = self.spline.ends() else { return };
        let beyond = if t < T::zero() {
            Some((first.state, t))
        } else if t > self.duration {
            Some((last.state, t - self.duration))
        } else {
            None
        };
        if let Some((mut end, t)) = beyond {
            end.velocity *= self.speed / end.velocity.norm();
            end.acceleration = SVector::zeros();
            return end.coast(t, out);
        }
        let s = self.speed * t;
        let Some((start, arc)) = self.arc(locate(&self.lengths, s)) else { return };
        let series = arc.series(arc.parameter(s - start), out.len().saturating_sub(1));
        let not_computed = SVector::from_element(constant(f64::NAN));
        let series = series.into_iter().chain(core::iter::repeat(not_computed));
        // dᵏ/dtᵏ = vᵏ·dᵏ/dσᵏ = vᵏ·k!·yₖ.
        let mut factor = T::one();
        for ((k, out), y) in out.iter_mut().enumerate().zip(series) {
            if (1..=ORDER).contains(&k) {
                factor *= self.speed * constant(k as f64);
            }
            *out = y * factor;
        }
    }
}

/// Two points do not determine a curve with free ends, so theirs are held straight.
fn straight<T: Scalar, const D: usize>(points: &[SVector<T, D>], distance: T) -> End<T, D> {
    match points {
        [from, to] => Some([(to - from) / distance, SVector::zeros()]),
        _ => None,
    }
}

#[cfg(feature = "serde")]
impl<T: Scalar, const D: usize, const M: usize> ConstantSpeed<T, D, M> {
    /// The points, and the speed.
    pub(super) fn parameters(&self) -> ([[T; D]; M], T) {
        (self.spline.points(), self.speed)
    }
}
