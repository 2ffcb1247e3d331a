use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use super::Estimate;
use crate::{Error, error::finite};

/// From here on the expansion in 1/ν is exact to rounding, and statrs, which ends the continued fraction behind its distribution after 140
/// terms, is not: at ν = 10⁶ it is off by 6·10⁻⁵.
const LARGE: f64 = 1000.0;

/// The mean of `count` ≥ 1 values and its interval, mean ± t·s/√n.
///
/// Exact for normal values, and asymptotically for all others with a variance.
pub(super) fn interval(
    mean: f64,
    deviation: f64,
    count: usize,
    level: f64,
) -> Result<Estimate, Error> {
    let value = finite("mean", mean)?;
    let half = match count.checked_sub(1) {
        None | Some(0) => f64::INFINITY,
        Some(freedom) => {
            let error = finite("standard deviation", deviation)? / (count as f64).sqrt();
            student(freedom as f64, level)? * error
        }
    };
    Ok(Estimate { value, low: value - half, high: value + half })
}

/// z with P(|Z| ≤ z) = `level` for a standard normal Z.
pub(super) fn normal(level: f64) -> Result<f64, Error> {
    finite("normal quantile", Normal::standard().inverse_cdf(0.5 + 0.5 * level))
}

/// t with P(|T| ≤ t) = `level` for Student's T with ν = `freedom` ≥ 1.
///
/// # References
/// For large ν, M. Abramowitz, I. A. Stegun, "Handbook of Mathematical Functions", 26.7.5.
fn student(freedom: f64, level: f64) -> Result<f64, Error> {
    if freedom < LARGE {
        let unknown = Error::Missing { name: "Student's distribution" };
        let t = StudentsT::new(0.0, 1.0, freedom).map_err(|_| unknown)?;
        return finite("quantile of Student's distribution", t.inverse_cdf(0.5 + 0.5 * level));
    }
    let z = normal(level)?;
    let z2 = z * z;
    let g1 = z * (z2 + 1.0) / 4.0;
    let g2 = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
    let g3 = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
    Ok(z + (g1 + (g2 + g3 / freedom) / freedom) / freedom)
}
