use plotters::style::RGBColor;

use super::{
    BLACK, Figure, Line,
    figure::{Layer, Shape},
};

impl Figure {
    /// Trajectories in the plane, in metres and as long up as across.
    pub fn in_plane() -> Self {
        Self { equal: true, ..Self::new("x in m", "y in m") }
    }

    /// Adds a line that goes somewhere: a ring marks its start and a disc its end.
    pub fn path(mut self, line: Line) -> Self {
        let finite = |point: &&(f64, f64)| point.0.is_finite() && point.1.is_finite();
        let start = line.points.iter().find(finite).copied();
        let end = line.points.iter().rev().find(finite).copied();
        let stroke = line.stroke.unwrap_or_else(|| self.next_stroke());
        self = self.line(line.stroke(stroke));
        let ends = [("start", Shape::Ring, start), ("end", Shape::Disc, end)];
        for (name, shape, at) in ends {
            let Some(at) = at else { continue };
            let known = self.layers.iter().any(|layer| layer.key() == Some(name));
            if !known {
                // The legend says it once, in the colour of none.
                self.layers.push(Layer::Mark {
                    label: name.into(),
                    at: (f64::NAN, f64::NAN),
                    shape,
                    colour: BLACK,
                });
            }
            self.mark(shape, at, stroke.colour);
        }
        self
    }

    /// Adds a vehicle at a point, which looks along `heading` in rad, counter-clockwise from the x axis.
    pub fn vehicle(mut self, at: (f64, f64), heading: f64, colour: RGBColor) -> Self {
        let (sin, cos) = heading.sin_cos();
        self.mark(Shape::Vehicle { along: (cos, sin) }, at, colour);
        self
    }

    /// Shows what lies within `reach` above and below a point, and as much on its sides as there is room for.
    pub fn close_up(self, (x, y): (f64, f64), reach: f64) -> Self {
        let [wide, tall] = self.size;
        let across = reach * (wide / tall).max(1.0);
        self.x_range(x - across..x + across).y_range(y - reach..y + reach)
    }
}
