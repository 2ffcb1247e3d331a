use std::{format, vec::Vec};

use super::Design;
use crate::{Error, error::finite};

/// A parameter and the values that it takes.
#[derive(Debug, Clone, PartialEq)]
pub struct Levels {
    name: &'static str,
    values: Vec<f64>,
}

impl Levels {
    /// The parameter `name` with the given `values`; see [`Axis::levels`](super::Axis::levels) for evenly spaced ones.
    ///
    /// # Errors
    /// [`Error::Missing`] without values, [`Error::NonFinite`], which names the parameter.
    pub fn new(name: &'static str, values: Vec<f64>) -> Result<Self, Error> {
        if values.is_empty() {
            return Err(Error::Missing { name: "level" });
        }
        for value in &values {
            finite(name, *value)?;
        }
        Ok(Self { name, values })
    }

    /// The values.
    pub fn values(&self) -> &[f64] {
        &self.values
    }
}

impl<const D: usize> Design<D> {
    /// Every combination of the levels of D parameters, the last parameter varying fastest: for two of them, row by row.
    pub fn grid(axes: [Levels; D]) -> Self {
        let mut points = Vec::from([[0.0; D]]);
        for (k, axis) in axes.iter().enumerate() {
            let with = |point: &[f64; D], value: f64| {
                let mut point = *point;
                point[k] = value;
                point
            };
            let extended = |point| axis.values.iter().map(move |value| with(point, *value));
            points = points.iter().flat_map(extended).collect();
        }
        let description = format!("grid {axes:?}");
        Self::new(axes.map(|axis| axis.name), points, description)
    }
}
