use super::Figure;

impl Figure {
    /// Signals over time, t in seconds.
    ///
    /// ```
    /// use brunovsky::plot::{Draw, Figure, Line};
    ///
    /// let t = (0..=500).map(|k| 0.01 * f64::from(k));
    /// let response = t.clone().map(|t| (t, 1.0 - (1.0 + 2.0 * t) * (-2.0 * t).exp()));
    /// let figure = Figure::over_time("position x₁ in m")
    ///     .line(Line::reference([(0.0, 1.0), (5.0, 1.0)]))
    ///     .line(Line::new("FLC", response))
    ///     .event(2.0, "load");
    /// assert!(figure.svg()?.contains("position x₁ in m"));
    /// # Ok::<(), brunovsky::plot::Error>(())
    /// ```
    pub fn over_time(y_label: impl Into<String>) -> Self {
        let mut figure = Self::new("time t in s", y_label);
        figure.axes[0].margin = 0.0;
        figure
    }
}
