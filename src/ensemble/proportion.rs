use super::{Estimate, mean::normal};
use crate::Error;

/// k/n and the p for which |k − n·p| ≤ z·√(n·p·(1 − p)), Wilson's interval; n ≥ 1.
pub(super) fn proportion(hits: usize, count: usize, level: f64) -> Result<Estimate, Error> {
    let (k, n) = (hits as f64, count as f64);
    let z = normal(level)?;
    let (value, weight) = (k / n, z * z / n);
    let centre = (value + 0.5 * weight) / (1.0 + weight);
    let half = z * (value * (1.0 - value) / n + 0.25 * weight / n).sqrt() / (1.0 + weight);
    // Without hits and without misses an end is 0 or 1, but for its rounding.
    let low = if hits == 0 { 0.0 } else { centre - half };
    let high = if hits == count { 1.0 } else { centre + half };
    Ok(Estimate { value, low, high })
}
