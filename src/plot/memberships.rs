use super::{BLACK, Dash, Figure, Line, Stroke};
use crate::{
    Error, Scalar,
    error::value,
    fuzzy::{FuzzyNetwork, Gaussian, Grid, Inputs},
};

impl Figure {
    /// The membership functions of one input of a network, counted from 0: dashed as they were `before`, solid as they are `after`
    /// learning.
    ///
    /// # Errors
    /// [`Error::NotBelow`] for an `input` that the network does not have.
    pub fn memberships<T: Scalar, const I: usize, const K: usize>(
        label: impl Into<String>,
        before: &FuzzyNetwork<T, I, K>,
        after: &FuzzyNetwork<T, I, K>,
        input: usize,
    ) -> Result<Self, Error>
    where
        Inputs<I>: Grid,
    {
        let (rows, learned) = (before.memberships(), after.memberships());
        let (Some(before), Some(after)) = (rows.get(input), learned.get(input)) else {
            let (value, limit) = (input as f64, I as f64);
            return Err(Error::NotBelow { name: "input", value, limit });
        };
        let ends =
            |side: f64| before.iter().chain(after).map(move |gaussian| reach(gaussian, side));
        let low = ends(-1.0).fold(f64::INFINITY, f64::min);
        let high = ends(1.0).fold(f64::NEG_INFINITY, f64::max);
        let mut figure = Self::new(label, "membership grade μ").y_range(0.0..1.04);
        figure.axes[0].margin = 0.0;
        // Two points beside the figure bring the dashes into the legend without a colour.
        let nowhere = [(f64::NAN, f64::NAN)];
        figure = figure
            .line(Line::new("before", nowhere).stroke(Stroke::new(BLACK, Dash::Dashed).width(1.1)))
            .line(Line::new("after learning", nowhere).stroke(Stroke::new(BLACK, Dash::Solid)));
        for (k, (before, after)) in before.iter().zip(after).enumerate() {
            let Stroke { colour, .. } = Stroke::nth(k);
            let dashed = Stroke::new(colour, Dash::Dashed).width(1.1);
            let solid = Stroke::new(colour, Dash::Solid);
            figure = figure
                .line(Line::new("", curve(before, low, high)).stroke(dashed))
                .line(Line::new("", curve(after, low, high)).stroke(solid));
        }
        Ok(figure)
    }
}

/// Three widths to one side of the centre, where hardly anything is left.
fn reach<T: Scalar>(gaussian: &Gaussian<T>, side: f64) -> f64 {
    value(gaussian.centre()) + side * 3.0 * value(gaussian.width())
}

/// μ(e) at 401 places of the figure and at its own centre and flanks, so that a narrow one is not missed.
fn curve<T: Scalar>(gaussian: &Gaussian<T>, low: f64, high: f64) -> Vec<(f64, f64)> {
    let (centre, width) = (value(gaussian.centre()), value(gaussian.width()));
    let over = (0..=400).map(|i| low + f64::from(i) / 400.0 * (high - low));
    let own = (-30..=30).map(|i| centre + f64::from(i) / 10.0 * width);
    let mut places: Vec<_> = over.chain(own).filter(|e| (low..=high).contains(e)).collect();
    places.sort_by(f64::total_cmp);
    places.into_iter().map(|e| (e, (-0.5 * ((e - centre) / width).powi(2)).exp())).collect()
}
