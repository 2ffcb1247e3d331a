use std::ops::Range;

use super::{
    Figure,
    colours::{ColourBar, ColourMap},
    figure::Layer,
};
use crate::{
    Error,
    error::{below, finite_slice},
};

impl Figure {
    /// A quantity over two parameters, such as the residual over α and h: `value` at every pair of `xs` and `ys`, as a colour. The labels
    /// are those of the axes and of the colour bar.
    ///
    /// Cells reach half-way to their neighbours. Where `value` is not finite they are grey: see [`undefined`](Self::undefined).
    ///
    /// # Errors
    /// [`Error::Missing`] for less than two `xs` or `ys`, [`Error::NonFiniteEntry`] or [`Error::NotBelow`] if they do not increase; and
    /// [`Error::Missing`] if no value is finite.
    pub fn heat_map(
        [x_label, y_label, z_label]: [&str; 3],
        xs: &[f64],
        ys: &[f64],
        mut value: impl FnMut(f64, f64) -> f64,
    ) -> Result<Self, Error> {
        let (x, y) = (edges("x of the map", xs)?, edges("y of the map", ys)?);
        let mut values = Vec::with_capacity(xs.len() * ys.len());
        for y in ys {
            for x in xs {
                let value = value(*x, *y);
                values.push(if value.is_finite() { value } else { f64::NAN });
            }
        }
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low > high {
            return Err(Error::Missing { name: "finite value of the map" });
        }
        let range = if low < high { low..high } else { low - 0.5..high + 0.5 };
        let mut figure = Self::new(x_label, y_label);
        figure.size = [480.0, 360.0];
        for (axis, edges) in figure.axes.iter_mut().zip([&x, &y]) {
            axis.range = edges.first().zip(edges.last()).map(|(start, end)| *start..*end);
        }
        figure.colour_bar =
            Some(ColourBar { label: z_label.into(), range, map: ColourMap::Cividis });
        figure.layers.push(Layer::Cells { x, y, values });
        Ok(figure)
    }

    /// Names the cells of a map where the value is not finite, if there are any: "diverged", say.
    pub fn undefined(mut self, label: impl Into<String>) -> Self {
        let any = self.layers.iter().any(|layer| match layer {
            Layer::Cells { values, .. } => values.iter().any(|value| value.is_nan()),
            _ => false,
        });
        if any {
            self.layers.push(Layer::Key { label: label.into(), colour: ColourBar::NONE });
        }
        self
    }

    /// Other colours for a map.
    pub fn colour_map(mut self, map: ColourMap) -> Self {
        if let Some(bar) = &mut self.colour_bar {
            bar.map = map;
        }
        self
    }

    /// Other values for the ends of the colours; beyond them they do not change.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`], or [`Error::NotBelow`] unless start < end.
    pub fn colour_range(mut self, range: Range<f64>) -> Result<Self, Error> {
        finite_slice("colour range", &[range.start, range.end])?;
        below("start of the colour range", range.start, range.end)?;
        if let Some(bar) = &mut self.colour_bar {
            bar.range = range;
        }
        Ok(self)
    }
}

/// The edges of cells around increasing `centres`.
fn edges(name: &'static str, centres: &[f64]) -> Result<Vec<f64>, Error> {
    finite_slice(name, centres)?;
    let ([first, second, ..], [.., before, last]) = (centres, centres) else {
        return Err(Error::Missing { name });
    };
    let mut edges = vec![first - 0.5 * (second - first)];
    for pair in centres.windows(2) {
        if let [low, high] = pair {
            below(name, *low, *high)?;
            edges.push(low + 0.5 * (high - low));
        }
    }
    edges.push(last + 0.5 * (last - before));
    Ok(edges)
}
