use super::{BLACK, Dash, Stroke};

/// A line through points, with a name for the legend.
///
/// Where a point is not finite the line has a gap.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    pub(super) label: String,
    pub(super) points: Vec<(f64, f64)>,
    pub(super) stroke: Option<Stroke>,
}

impl Line {
    /// A line in the next free style of its figure. An empty label keeps it out of the legend.
    pub fn new(label: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { label: label.into(), points: points.into_iter().collect(), stroke: None }
    }

    /// What is to be followed: a thin black dashed line named "reference".
    pub fn reference(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new("reference", points).stroke(Stroke::new(BLACK, Dash::Dashed).width(1.2))
    }

    /// The same line in a style of your own.
    pub fn stroke(self, stroke: Stroke) -> Self {
        Self { stroke: Some(stroke), ..self }
    }
}
