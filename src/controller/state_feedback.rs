use nalgebra::{SMatrix, SVector};

use super::{
    Accept, Controller, Measurement,
    lqr::{self, Weights},
};
use crate::{
    Error, Scalar,
    error::{finite_slice, finite_vector, positive},
    plant::Jacobians,
};

/// Linear state feedback about an operating point: u = u₀ + K·(r − x).
///
/// The reference r is the state to be held or followed, in the plant's own coordinates, u₀ the input that holds the operating point. For a plant
/// that is linearized there, δẋ = A·δx + B·δu, the error e = r − x of a resting r obeys ė = (A − B·K)·e, as far as the linearization goes; an r
/// that the input u₀ does not hold leaves an error. Linear-quadratic gains have one input for any number of states and stabilize what feedback
/// linearization cannot: zero dynamics that are not stable.
///
/// ```
/// use brunovsky::{
///     controller::{StateFeedback, lqr::Weights},
///     plant::{CartPole, CartPoleOutput, SmoothPlant},
///     prelude::*,
/// };
///
/// let plant = CartPole::new(1.0, 0.2, 0.5, [0.1, 0.0], 9.81, CartPoleOutput::Position)?;
/// let upright = plant.jacobians([0.0; 4], [0.0])?;
/// let weights = Weights::diagonal([1.0, 1.0, 0.1, 0.1], [0.1])?;
/// let balance = StateFeedback::sampled_lqr(&upright, &weights, 0.02, [0.0])?;
/// let goal = |_| SVector::from([1.0, 0.0, 0.0, 0.0]);
/// let run = Simulation::new(&plant, balance, goal, [0.0, 0.3, 0.0, 0.0], 0.02)?;
/// let last = run.until(15.0)?.last().ok_or(Error::Missing { name: "sample" })??;
/// assert!((last.x - goal(0.0)).norm() < 1e-4);
/// # Ok::<(), Error>(())
/// ```
///
/// It has no memory. The input is an `SVector`, the share K·(r − x) is what it has beyond u₀.
///
/// # References
/// K. J. Åström, R. M. Murray, *Feedback Systems*, chapter 7; H. Kwakernaak, R. Sivan, *Linear Optimal Control Systems*, 1972, chapters 3 and 6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StateFeedback<T, const NX: usize, const NU: usize> {
    gain: SMatrix<T, NU, NX>,
    u0: SVector<T, NU>,
}

impl<T: Scalar, const NX: usize, const NU: usize> StateFeedback<T, NX, NU> {
    /// The law with the gain K and the input `u0` of the operating point.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn new(gain: SMatrix<T, NU, NX>, u0: impl Into<SVector<T, NU>>) -> Result<Self, Error> {
        let u0 = u0.into();
        finite_slice("K", gain.as_slice())?;
        finite_vector("u0", &u0)?;
        Ok(Self { gain, u0 })
    }

    /// The law with the gain of [`lqr::continuous`] at an operating point.
    ///
    /// # Errors
    /// Those of [`lqr::continuous`] and of [`new`](Self::new).
    pub fn lqr(
        at: &Jacobians<T, NX, NU>,
        weights: &Weights<T, NX, NU>,
        u0: impl Into<SVector<T, NU>>,
    ) -> Result<Self, Error> {
        Self::new(lqr::continuous(&at.a, &at.b, weights)?.gain, u0)
    }

    /// The law with the gain of [`lqr::sampled`] at an operating point, to be run at the period `dt` in seconds.
    ///
    /// # Errors
    /// Those of [`lqr::sampled`] and of [`new`](Self::new).
    pub fn sampled_lqr(
        at: &Jacobians<T, NX, NU>,
        weights: &Weights<T, NX, NU>,
        dt: T,
        u0: impl Into<SVector<T, NU>>,
    ) -> Result<Self, Error> {
        Self::new(lqr::sampled(&at.a, &at.b, weights, dt)?.gain, u0)
    }

    /// The gain K.
    pub fn gain(&self) -> &SMatrix<T, NU, NX> {
        &self.gain
    }
}

impl<T: Scalar, const NX: usize, const NU: usize> Controller<NX, NU> for StateFeedback<T, NX, NU> {
    type Scalar = T;
    type Reference = SVector<T, NX>;
    type Command = SVector<T, NU>;

    /// # Errors
    /// [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] and [`Error::NonFiniteEntry`] for `dt`, the measurement, the reference and u.
    fn update_if(
        &mut self,
        measurement: &Measurement<T, NX, NU>,
        reference: &SVector<T, NX>,
        dt: T,
        accept: Accept<SVector<T, NU>>,
    ) -> Result<SVector<T, NU>, Error> {
        positive("dt", dt)?;
        measurement.validate()?;
        finite_vector("r", reference)?;
        let u = self.u0 + self.gain * (reference - measurement.x);
        finite_vector("u", &u)?;
        accept(&u)?;
        Ok(u)
    }

    fn reset(&mut self) {}
}

checked! {
    [T: Scalar, const NX: usize, const NU: usize] StateFeedback<T, NX, NU>, [T]
    { gain: SMatrix<T, NU, NX>, u0: SVector<T, NU> } =>
    Self::new(gain, u0)
}
