//! Reference trajectories: curves r(t) in D dimensions with their derivatives, for any plant.
//!
//! | trajectory | r(t) | continuous derivatives | outside of its time |
//! |---|---|---|---|
//! | [`Line`] | p₀ + v·t | all | – |
//! | [`Circle`] | c + R·(cos θ, sin θ), θ = ω·t + φ | all | – |
//! | [`FigureEight`] | (a·sin ωt, b·sin 2ωt) | all | – |
//! | [`Quintic`] | one polynomial between two [`Boundary`] states | all inside, 2 at the ends | keeps the acceleration of its end |
//! | [`MinimumJerk`] | least ∫\|r⃛\|² dt through points at given times | 4 inside, 2 at the ends | keeps the acceleration of its end |
//! | [`ConstantSpeed`] | through waypoints with \|ṙ\| = v | 4 inside, 1 at the ends | goes on straight with speed v |
//!
//! A chain of order N needs r and N derivatives, of which the last may jump: [`Trajectory::references`] gives one
//! [`Reference`] a dimension. [`Limits`] tells whether a vehicle can follow.
//!
//! # Conventions
//! t is in seconds, r in any unit of length. Constructors take points as arrays `[T; D]`, so that D and the number of waypoints are
//! inferred. They check their parameters; after that every finite t has its derivatives, and a t that is not finite gives a position that
//! is not finite either, which a controller refuses.
//!
//! This module depends on [`controller`](crate::controller) for [`Reference`] alone.

mod arc_length;
mod boundary;
mod circle;
mod constant_speed;
mod figure_eight;
mod gauss_legendre;
mod limits;
mod line;
mod minimum_jerk;
mod quintic;
#[cfg(feature = "serde")]
mod saved;
mod spline;

pub use boundary::Boundary;
pub use circle::Circle;
pub use constant_speed::ConstantSpeed;
pub use figure_eight::FigureEight;
pub use limits::Limits;
pub use line::Line;
pub use minimum_jerk::MinimumJerk;
pub use quintic::Quintic;

use nalgebra::SVector;

use crate::{Error, Scalar, controller::Reference};

/// A curve r(t) in D dimensions with its derivatives.
///
/// All derivatives at one t are asked for at once: what is expensive (a sine, the inversion of an arc length) is done once.
///
/// ```
/// use brunovsky::trajectory::{Circle, Trajectory};
///
/// let circle = Circle::new([0.0, 0.0], 2.0, 0.5, 0.0)?;
/// let [r, v, a] = circle.jet(0.0);
/// assert_eq!((r[0], v[1], a[0]), (2.0, 1.0, -0.5));
/// let [x, y] = circle.references::<2>(0.0);
/// assert_eq!((x.r[0], y.r[1], x.r_n_dot), (2.0, 1.0, -0.5));
/// # Ok::<(), brunovsky::Error>(())
/// ```
pub trait Trajectory<const D: usize> {
    /// The number type of time and position.
    type Scalar: Scalar;

    /// Writes r⁽ᵏ⁾(t) to `out[k]`: the position, the velocity, … as far as there is room.
    fn derivatives(&self, t: Self::Scalar, out: &mut [SVector<Self::Scalar, D>]);

    /// The position r(t) and its first K − 1 derivatives: `let [r, v, a] = trajectory.jet(t)`.
    fn jet<const K: usize>(&self, t: Self::Scalar) -> [SVector<Self::Scalar, D>; K]
    where
        Self: Sized,
    {
        let mut jet = [SVector::zeros(); K];
        self.derivatives(t, &mut jet);
        jet
    }

    /// The position r(t).
    fn position(&self, t: Self::Scalar) -> SVector<Self::Scalar, D> {
        let mut r = SVector::zeros();
        self.derivatives(t, core::slice::from_mut(&mut r));
        r
    }

    /// For each dimension the reference of a chain of order N: (r, ṙ, …, r⁽ᴺ⁻¹⁾) and r⁽ᴺ⁾.
    fn references<const N: usize>(&self, t: Self::Scalar) -> [Reference<Self::Scalar, N>; D]
    where
        Self: Sized,
    {
        const { assert!(N > 0, "a chain has at least one integrator") };
        // N + 1 vectors are needed and N + 1 is not a length, so the room is for 2·N.
        let mut room = [[SVector::<Self::Scalar, D>::zeros(); 2]; N];
        let jet = room.as_flattened_mut().get_mut(..=N).unwrap_or_default();
        self.derivatives(t, jet);
        core::array::from_fn(|dimension| {
            let entry = |k: usize| jet.get(k).and_then(|r| r.get(dimension)).copied();
            let entry = |k: usize| entry(k).unwrap_or(nalgebra::zero());
            Reference::new(SVector::from_fn(|k, _| entry(k)), entry(N))
        })
    }

    /// The greatest speed, acceleration and yaw rate for t in \[`from`, `to`\].
    ///
    /// In closed form where the trajectory has one, otherwise searched for as [`Limits`] describes.
    ///
    /// # Errors
    /// [`Error::NonFinite`] for either time or for what is found, [`Error::NotBelow`] unless `from` < `to`.
    fn limits(&self, from: Self::Scalar, to: Self::Scalar) -> Result<Limits<Self::Scalar>, Error> {
        Limits::searched(self, from, to)
    }
}

impl<P: Trajectory<D> + ?Sized, const D: usize> Trajectory<D> for &P {
    type Scalar = P::Scalar;

    fn derivatives(&self, t: P::Scalar, out: &mut [SVector<P::Scalar, D>]) {
        (**self).derivatives(t, out);
    }

    fn limits(&self, from: P::Scalar, to: P::Scalar) -> Result<Limits<P::Scalar>, Error> {
        (**self).limits(from, to)
    }
}
