use std::{format, string::String, vec::Vec};

use super::Levels;
use crate::{
    Error,
    error::{below, finite, positive},
};

/// A parameter that is varied: its name, its range, and whether it varies in steps or in factors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    name: &'static str,
    low: f64,
    high: f64,
    logarithmic: bool,
}

impl Axis {
    /// From `low` to `high` in equal steps.
    ///
    /// # Errors
    /// [`Error::NonFinite`], [`Error::NotBelow`] unless low < high; both name the axis.
    pub fn linear(name: &'static str, low: f64, high: f64) -> Result<Self, Error> {
        below(name, finite(name, low)?, finite(name, high)?)?;
        Ok(Self { name, low, high, logarithmic: false })
    }

    /// From `low` > 0 to `high` by equal factors.
    ///
    /// # Errors
    /// As [`linear`](Self::linear), and [`Error::NotPositive`].
    pub fn logarithmic(name: &'static str, low: f64, high: f64) -> Result<Self, Error> {
        positive(name, low)?;
        Ok(Self { logarithmic: true, ..Self::linear(name, low, high)? })
    }

    /// `count` levels from one end to the other, both included; one level is the lower end.
    ///
    /// # Errors
    /// [`Error::Missing`] for 0 levels.
    pub fn levels(&self, count: u32) -> Result<Levels, Error> {
        let intervals = f64::from(count.saturating_sub(1).max(1));
        Levels::new(self.name, (0..count).map(|k| self.at(f64::from(k) / intervals)).collect())
    }

    /// The value at `share` ∈ \[0, 1\] of the way, exact at both ends.
    pub(super) fn at(&self, share: f64) -> f64 {
        let rest = 1.0 - share;
        if self.logarithmic {
            self.low.powf(rest) * self.high.powf(share)
        } else {
            self.low * rest + self.high * share
        }
    }

    pub(super) fn name(&self) -> &'static str {
        self.name
    }
}

/// Points in the space of D parameters, at which a [`Sweep`](super::Sweep) runs its experiment.
///
/// [`grid`](Self::grid) takes every combination, for maps of two parameters; [`latin_hypercube`](Self::latin_hypercube) scatters a given
/// number of points over any number of parameters; [`listed`](Self::listed) takes points from elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Design<const D: usize> {
    names: [&'static str; D],
    points: Vec<[f64; D]>,
    description: String,
}

impl<const D: usize> Design<D> {
    pub(super) fn new(
        names: [&'static str; D],
        points: Vec<[f64; D]>,
        description: String,
    ) -> Self {
        Self { names, points, description }
    }

    /// The `points`, whose parameters have the `names`.
    ///
    /// # Errors
    /// [`Error::Missing`] without points, [`Error::NonFinite`] for one that is not finite, by the name of the parameter.
    pub fn listed(names: [&'static str; D], points: Vec<[f64; D]>) -> Result<Self, Error> {
        if points.is_empty() {
            return Err(Error::Missing { name: "point" });
        }
        for point in &points {
            for (name, value) in names.iter().zip(point) {
                finite(name, *value)?;
            }
        }
        let description = format!("points {names:?} {points:?}");
        Ok(Self::new(names, points, description))
    }

    /// The names of the parameters.
    pub fn names(&self) -> &[&'static str; D] {
        &self.names
    }

    /// The points, in order.
    pub fn points(&self) -> &[[f64; D]] {
        &self.points
    }

    /// All that the points follow from.
    pub(super) fn description(&self) -> &str {
        &self.description
    }
}
