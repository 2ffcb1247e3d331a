use std::{format, vec, vec::Vec};

use rand::{RngExt, seq::SliceRandom};

use super::{Axis, Design, Run};
use crate::Error;

impl<const D: usize> Design<D> {
    /// `count` points of a Latin hypercube: each parameter's range is cut into `count` strata of equal share, and each stratum holds exactly
    /// one point, at a random place in it.
    ///
    /// The strata of different parameters are paired at random. The points follow from `seed` alone.
    ///
    /// # Errors
    /// [`Error::Missing`] for 0 points.
    ///
    /// # References
    /// M. D. McKay, R. J. Beckman, W. J. Conover, "A comparison of three methods for selecting values of input variables in the analysis of
    /// output from a computer code", Technometrics 21(2), 1979.
    pub fn latin_hypercube(axes: [Axis; D], count: u32, seed: u64) -> Result<Self, Error> {
        if count == 0 {
            return Err(Error::Missing { name: "point" });
        }
        let mut points = vec![[0.0; D]; count as usize];
        for (k, axis) in axes.iter().enumerate() {
            // A stream of its own for each parameter: the others do not change if one is added.
            let mut random = Run::new(seed, k as u64);
            let mut strata: Vec<u32> = (0..count).collect();
            strata.shuffle(&mut random);
            for (point, stratum) in points.iter_mut().zip(strata) {
                let place: f64 = random.random();
                point[k] = axis.at((f64::from(stratum) + place) / f64::from(count));
            }
        }
        let description = format!("Latin hypercube {axes:?}, {count} points, seed {seed}");
        Ok(Self::new(axes.map(|axis| axis.name()), points, description))
    }
}
