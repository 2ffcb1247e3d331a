use super::{Figure, Line, figure::Layer};
use crate::{
    Error,
    error::{below, finite_slice, not_negative},
};

impl Figure {
    /// Adds many runs as their median, and the band between two quantiles, `[0.05, 0.95]` say. Each run has one value for each of
    /// `times`.
    ///
    /// Quantiles between two runs are interpolated linearly.
    ///
    /// # Errors
    /// [`Error::Missing`] without runs, [`Error::Length`] for a run that is not as long as `times`, [`Error::NonFiniteEntry`] for a value
    /// that is not finite, [`Error::Negative`] or [`Error::NotBelow`] unless 0 ≤ low < high ≤ 1.
    pub fn spread(
        mut self,
        label: &str,
        times: &[f64],
        runs: &[Vec<f64>],
        [low, high]: [f64; 2],
    ) -> Result<Self, Error> {
        below("low quantile", not_negative("low quantile", low)?, high)?;
        not_negative("1 - high quantile", 1.0 - high)?;
        if runs.is_empty() {
            return Err(Error::Missing { name: "runs" });
        }
        for run in runs {
            finite_slice("run", run)?;
            if run.len() != times.len() {
                return Err(Error::Length { name: "run", expected: times.len(), found: run.len() });
            }
        }
        let (mut median, mut band) = (Vec::new(), Vec::new());
        for (i, t) in times.iter().enumerate() {
            let mut values: Vec<_> = runs.iter().filter_map(|run| run.get(i).copied()).collect();
            values.sort_by(f64::total_cmp);
            median.push((*t, quantile(&values, 0.5)));
            band.push((*t, quantile(&values, low)..quantile(&values, high)));
        }
        let stroke = self.next_stroke();
        let percent = |part: f64| (1000.0 * part).round() / 10.0;
        let label = format!("{label}: median, {} to {} %", percent(low), percent(high));
        self.layers.push(Layer::Band { label, points: band, stroke });
        Ok(self.line(Line::new("", median).stroke(stroke)))
    }
}

/// The quantile of sorted values.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let place = part * sorted.len().saturating_sub(1) as f64;
    let at = |i: f64| sorted.get(i as usize).copied().unwrap_or(f64::NAN);
    let (low, high) = (at(place.floor()), at(place.ceil()));
    low + (place - place.floor()) * (high - low)
}
