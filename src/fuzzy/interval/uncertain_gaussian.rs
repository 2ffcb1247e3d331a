use super::{IntervalMembership, Shares};
use crate::{
    Error, Scalar,
    error::{at_most, finite, positive},
    fuzzy::{Gaussian, grades::Relative},
    scalar::constant,
};

/// A Gaussian membership function of which the width is uncertain: μ = exp(−½·((e − c)/σ)²) with σ between σ̲ and σ̄.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UncertainGaussian<T> {
    centre: T,
    widths: [T; 2],
}

impl<T: Scalar> UncertainGaussian<T> {
    /// A membership function with its centre c and the least and the greatest width, 0 < σ̲ ≤ σ̄, all in the units of e.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for a width, [`Error::NonFinite`] for the centre, [`Error::Above`] for a σ̲ above σ̄.
    pub fn new(centre: T, widths: [T; 2]) -> Result<Self, Error> {
        finite("centre", centre)?;
        let [lower, upper] = widths;
        at_most("lower width", positive("lower width", lower)?, positive("upper width", upper)?)?;
        Ok(Self { centre, widths })
    }

    /// The centre c.
    pub fn centre(&self) -> T {
        self.centre
    }

    /// The widths σ̲ and σ̄.
    pub fn widths(&self) -> [T; 2] {
        self.widths
    }

    /// The distance from the centre in each of the widths.
    fn distances(&self, e: T) -> [T; 2] {
        self.widths.map(|width| ((e - self.centre) / width).abs())
    }
}

/// What is certain.
impl<T: Scalar> From<Gaussian<T>> for UncertainGaussian<T> {
    fn from(gaussian: Gaussian<T>) -> Self {
        Self { centre: gaussian.centre(), widths: [gaussian.width(); 2] }
    }
}

impl<T: Scalar> IntervalMembership<T> for UncertainGaussian<T> {
    fn grades(&self, e: T) -> [T; 2] {
        self.distances(e).map(|m| (m * m * constant(-0.5)).exp())
    }

    fn shares<const K: usize>(row: &[Self; K], e: T) -> Shares<T, K> {
        let distances = row.map(|membership| membership.distances(e));
        let lower = Relative::at(distances.map(|[lower, _]| lower));
        let upper = Relative::at(distances.map(|[_, upper]| upper));
        let (far, near) = (lower.nearest, upper.nearest);
        // Distances that have both overflowed count as equal, like those that are.
        let peaks = if far == near {
            T::one()
        } else {
            ((near - far) * (near + far) * constant(0.5)).exp()
        };
        Shares {
            lower: lower.shares(),
            upper: upper.shares(),
            ratio: peaks * (lower.sum / upper.sum),
        }
    }
}

checked! {
    [T: Scalar] UncertainGaussian<T>, [T] { centre: T, widths: [T; 2] } => Self::new(centre, widths)
}
