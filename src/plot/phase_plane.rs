use std::ops::Range;

use super::{Figure, GREY, figure::Shape};

impl Figure {
    /// A phase portrait, one state over another. Add trajectories with [`path`](Self::path), and the [`field`](Self::field) of the motion.
    pub fn phase_plane(x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        let mut figure = Self::new(x_label, y_label);
        figure.size = [480.0, 400.0];
        figure
    }

    /// Shows the ranges `x` and `y` and in them the direction of a vector field: `rate` is (ẋ, ẏ) at (x, y).
    pub fn field(
        self,
        x: Range<f64>,
        y: Range<f64>,
        rate: impl Fn(f64, f64) -> (f64, f64),
    ) -> Self {
        const COLUMNS: u32 = 19;
        const ROWS: u32 = 15;
        let mut figure = self.x_range(x.clone()).y_range(y.clone());
        let [wide, tall] = figure.size;
        // As long as leaves a gap to the neighbours in every direction.
        let length = 0.62 * (wide / f64::from(COLUMNS)).min(tall / f64::from(ROWS));
        let place = |range: &Range<f64>, i: u32, of: u32| {
            range.start + (f64::from(i) + 0.5) / f64::from(of) * (range.end - range.start)
        };
        for row in 0..ROWS {
            for column in 0..COLUMNS {
                let at = (place(&x, column, COLUMNS), place(&y, row, ROWS));
                figure.mark(Shape::Arrow { along: rate(at.0, at.1), length }, at, GREY);
            }
        }
        figure
    }
}
