use nalgebra::SVector;

use super::{Plant, last_axis};
use crate::Scalar;

/// What the model leaves out: Δ(t, x, u), added to the derivative of a plant.
///
/// Closures `|t, x, u| -> SVector<T, NX>` are uncertainties; [`Matched`] makes one of a closure with a scalar result.
pub trait Uncertainty<T, const NX: usize, const NU: usize> {
    /// Δ(t, x, u), in the units of ẋ.
    fn delta(&self, t: T, x: &SVector<T, NX>, u: &SVector<T, NU>) -> SVector<T, NX>;
}

impl<F, T, const NX: usize, const NU: usize> Uncertainty<T, NX, NU> for F
where
    F: Fn(T, &SVector<T, NX>, &SVector<T, NU>) -> SVector<T, NX>,
{
    fn delta(&self, t: T, x: &SVector<T, NX>, u: &SVector<T, NU>) -> SVector<T, NX> {
        self(t, x, u)
    }
}

/// A scalar uncertainty δ(t, x, u) in the last state equation alone, where the input of a chain enters too (eq_nonlinearsystem).
#[derive(Debug, Clone, Copy)]
pub struct Matched<F>(pub F);

impl<F, T, const NX: usize, const NU: usize> Uncertainty<T, NX, NU> for Matched<F>
where
    T: Scalar,
    F: Fn(T, &SVector<T, NX>, &SVector<T, NU>) -> T,
{
    fn delta(&self, t: T, x: &SVector<T, NX>, u: &SVector<T, NU>) -> SVector<T, NX> {
        last_axis((self.0)(t, x, u))
    }
}

/// Any plant with an uncertainty on top: ẋ = F(t, x, u) + Δ(t, x, u).
///
/// It is a [`Plant`] and nothing more, so it can be simulated, and cannot be mistaken for a model that a controller knows.
///
/// ```
/// use brunovsky::plant::{Plant, ThirdOrder, Uncertain};
/// use nalgebra::SVector;
///
/// let plant = Uncertain::matched(ThirdOrder::<f64>::new(), |t: f64, _x: &_, _u: &_| 5.0 * t.sin());
/// let rate = plant.derivative(1.0, &SVector::zeros(), &SVector::zeros());
/// assert_eq!(rate, SVector::from([0.0, 0.0, 1.0 + 5.0 * 1.0_f64.sin()]));
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Uncertain<P, D> {
    plant: P,
    uncertainty: D,
}

impl<P, D> Uncertain<P, D> {
    /// `plant` with a vector uncertainty Δ in every state equation.
    pub fn new<T, const NX: usize, const NU: usize>(plant: P, uncertainty: D) -> Self
    where
        P: Plant<NX, NU, Scalar = T>,
        D: Uncertainty<T, NX, NU>,
    {
        Self { plant, uncertainty }
    }
}

impl<P, F> Uncertain<P, Matched<F>> {
    /// `plant` with a scalar uncertainty in its last state equation.
    pub fn matched<T, const NX: usize, const NU: usize>(plant: P, uncertainty: F) -> Self
    where
        P: Plant<NX, NU, Scalar = T>,
        F: Fn(T, &SVector<T, NX>, &SVector<T, NU>) -> T,
    {
        Self { plant, uncertainty: Matched(uncertainty) }
    }
}

impl<P, D, const NX: usize, const NU: usize> Plant<NX, NU> for Uncertain<P, D>
where
    P: Plant<NX, NU>,
    D: Uncertainty<P::Scalar, NX, NU>,
{
    type Scalar = P::Scalar;

    fn derivative(
        &self,
        t: P::Scalar,
        x: &SVector<P::Scalar, NX>,
        u: &SVector<P::Scalar, NU>,
    ) -> SVector<P::Scalar, NX> {
        self.plant.derivative(t, x, u) + self.uncertainty.delta(t, x, u)
    }
}
