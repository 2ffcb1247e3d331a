use nalgebra::SVector;

use super::{
    Boundary, Trajectory,
    spline::{Spline, locate},
};
use crate::{
    Error, Scalar,
    error::{below, finite_slice},
};

/// The curve of least ∫|r⃛|² dt through M points at given times: a quintic spline with four continuous derivatives.
///
/// Velocity and acceleration at both ends are zero or given. Before and after, it goes on with the acceleration of its end (from rest
/// to rest, it rests), so all over ℝ it has two continuous derivatives.
///
/// ```
/// use brunovsky::trajectory::{MinimumJerk, Trajectory};
/// use nalgebra::SVector;
///
/// let r = MinimumJerk::new([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]], [0.0, 1.0, 3.0])?;
/// let [position, velocity] = r.jet(1.0);
/// assert_eq!(position, SVector::from([1.0, 2.0]));
/// assert!(velocity[0] > 0.0);
/// assert_eq!(r.position(5.0), SVector::from([3.0, 2.0]));
/// # Ok::<(), brunovsky::Error>(())
/// ```
///
/// # References
/// T. Flash and N. Hogan, "The coordination of arm movements: an experimentally confirmed mathematical model", Journal of
/// Neuroscience 5(7), 1985.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MinimumJerk<T, const D: usize, const M: usize> {
    times: [T; M],
    /// \[velocity, acceleration\] at the start and at the end.
    ends: Ends<T, D>,
    spline: Spline<T, D, M>,
}

type Ends<T, const D: usize> = [[SVector<T, D>; 2]; 2];

impl<T: Scalar, const D: usize, const M: usize> MinimumJerk<T, D, M> {
    /// From rest in the first of `points` to rest in the last, through each at its time.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], for `points` with the coordinates counted through; [`Error::NotBelow`] for times that do not increase;
    /// [`Error::NonFinite`] or [`Error::NonFiniteEntry`] for what then leaves the range of `T`.
    pub fn new(points: [[T; D]; M], times: [T; M]) -> Result<Self, Error> {
        Self::with_ends(points, times, [[T::zero(); D]; 2], [[T::zero(); D]; 2])
    }

    /// The same with \[velocity, acceleration\] given at the `start` and at the `end`.
    ///
    /// # Errors
    /// As [`new`](Self::new), and [`Error::NonFiniteEntry`] for `velocity` and `acceleration`.
    pub fn with_ends(
        points: [[T; D]; M],
        times: [T; M],
        start: [[T; D]; 2],
        end: [[T; D]; 2],
    ) -> Result<Self, Error> {
        const { assert!(M >= 2, "a curve goes through two points at least") };
        let vectors = finite_points(&points)?;
        finite_slice("times", &times)?;
        for pair in times.windows(2) {
            if let [before, after] = pair {
                below("time of the point before", *before, *after)?;
            }
        }
        for [velocity, acceleration] in [start, end] {
            Boundary::new([T::zero(); D], velocity, acceleration).validate()?;
        }
        let ends = [start, end].map(|end| end.map(SVector::from));
        Ok(Self { times, ends, spline: Spline::new(&vectors, &times, ends.map(Some))? })
    }
}

impl<T: Scalar, const D: usize, const M: usize> Trajectory<D> for MinimumJerk<T, D, M> {
    type Scalar = T;

    fn derivatives(&self, t: T, out: &mut [SVector<T, D>]) {
        let Some([first, last]) = self.spline.ends() else { return };
        if t < first.u {
            first.state.coast(t - first.u, out);
        } else if t > last.u {
            last.state.coast(t - last.u, out);
        } else if let Some((from, segment)) = self.spline.segment(locate(&self.times, t)) {
            segment.polynomial(t - from, out);
        }
    }
}

/// The points as vectors, every coordinate checked.
pub(super) fn finite_points<T: Scalar, const D: usize, const M: usize>(
    points: &[[T; D]; M],
) -> Result<[SVector<T, D>; M], Error> {
    finite_slice("points", points.as_flattened())?;
    Ok(points.map(SVector::from))
}

#[cfg(feature = "serde")]
impl<T: Scalar, const D: usize, const M: usize> MinimumJerk<T, D, M> {
    /// The points, their times, and \[velocity, acceleration\] at the start and at the end.
    pub(super) fn parameters(&self) -> ([[T; D]; M], [T; M], Ends<T, D>) {
        (self.spline.points(), self.times, self.ends)
    }
}
