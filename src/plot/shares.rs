use super::{BLUE, Dash, Figure, Line, Stroke, VERMILION, figure::Layer};
use crate::{
    Error,
    error::{below, positive},
};

impl Figure {
    /// Who did the work, as two panels: feedback u_b and learned term u_n over time, and below the part |u_n|/(|u_b| + |u_n|) that is
    /// learned, both means over the last `window` seconds. `samples` are (t, u_b, u_n); `unit` is that of ẋ_n.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for the window, [`Error::NotBelow`] if time does not advance.
    pub fn shares(
        unit: &str,
        samples: impl IntoIterator<Item = (f64, f64, f64)>,
        window: f64,
    ) -> Result<[Self; 2], Error> {
        positive("window", window)?;
        let samples: Vec<_> = samples.into_iter().collect();
        let mut part = Vec::with_capacity(samples.len());
        // Sums of |u_b| and |u_n| over the samples in the window, whose first is number `first`.
        let mut first = 0;
        let mut last = f64::NEG_INFINITY;
        for (i, (t, ..)) in samples.iter().enumerate() {
            below("time of the sample before", last, *t)?;
            last = *t;
            while samples.get(first).is_some_and(|(start, ..)| *start <= t - window) {
                first += 1;
            }
            let within = samples.get(first..=i).unwrap_or_default();
            let (u_b, u_n) = within
                .iter()
                .fold((0.0, 0.0), |(b, n), (_, u_b, u_n)| (b + u_b.abs(), n + u_n.abs()));
            let learned = if u_b + u_n > 0.0 { 100.0 * u_n / (u_b + u_n) } else { 0.0 };
            part.push((*t, learned));
        }
        let of = |f: fn(&(f64, f64, f64)) -> f64| {
            samples.iter().map(move |sample| (sample.0, f(sample)))
        };
        let signals = Self::over_time(format!("u_b, u_n in {unit}"))
            .size(640.0, 260.0)?
            .line(
                Line::new("feedback u_b", of(|s| s.1)).stroke(Stroke::new(VERMILION, Dash::Dashed)),
            )
            .line(Line::new("learned u_n", of(|s| s.2)).stroke(Stroke::new(BLUE, Dash::Solid)));
        let stroke = Stroke::new(BLUE, Dash::Solid);
        let mut learned =
            Self::over_time("learned part in %").size(640.0, 200.0)?.y_range(0.0..100.0);
        let band = part.iter().map(|(t, part)| (*t, 0.0..*part)).collect();
        learned.layers.push(Layer::Band { label: String::new(), points: band, stroke });
        let learned = learned.line(Line::new("", part).stroke(stroke));
        Ok([signals, learned])
    }
}
