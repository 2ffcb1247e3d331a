//! The controllers, each with the parameters that a search may choose.

mod feedback;
mod learning;
mod robust;

use brunovsky::{
    controller::InputOnly,
    fuzzy::{Grid, Inputs},
    prelude::*,
};

/// Any controller of a chain of order N.
pub type Any<const N: usize> = Box<
    dyn Controller<N, 1, Scalar = f64, Reference = Reference<f64, N>, Command = SVector<f64, 1>>,
>;

/// No controller has more parameters.
pub const MOST: usize = 6;

/// A point of the ranges of the parameters, 0 at their low and 1 at their high ends, with equal factors in between.
pub type Point = [f64; MOST];

/// A parameter and the range that it is searched in.
pub type Parameter = (&'static str, [f64; 2]);

/// A law that is to be compared with others.
pub struct Contestant<const N: usize> {
    pub name: &'static str,
    /// What it has to know: the output y or the state x, and more.
    pub knows: &'static str,
    /// Whether it sees the output alone, and works on the plant as it is.
    pub sees_output: bool,
    parameters: Vec<Parameter>,
    make: Make<N>,
}

type Make<const N: usize> = Box<dyn Fn(&[f64]) -> Result<Any<N>, Error> + Send + Sync>;

impl<const N: usize> Contestant<N> {
    /// The law that `make` makes of the values of its `parameters`.
    fn new<C>(
        name: &'static str,
        knows: &'static str,
        parameters: &[Parameter],
        make: impl Fn(&[f64]) -> Result<C, Error> + Send + Sync + 'static,
    ) -> Self
    where
        C: Controller<N, 1, Scalar = f64, Reference = Reference<f64, N>> + 'static,
    {
        let make: Make<N> = Box::new(move |values| Ok(Box::new(InputOnly(make(values)?))));
        Self { name, knows, sees_output: false, parameters: parameters.to_vec(), make }
    }

    /// The same law, which sees nothing but the output.
    fn on_output(self) -> Self {
        Self { sees_output: true, ..self }
    }

    /// The names of the parameters and their values at a `point`.
    pub fn parameters(&self, point: &Point) -> Vec<(&'static str, f64)> {
        let value = |(&(name, [low, high]), share): (&Parameter, &f64)| {
            (name, low * (high / low).powf(*share))
        };
        self.parameters.iter().zip(point).map(value).collect()
    }

    /// A new controller with the parameters of a `point`.
    pub fn at(&self, point: &Point) -> Result<Any<N>, Error> {
        let values: Vec<f64> = self.parameters(point).into_iter().map(|(_, value)| value).collect();
        (self.make)(&values)
    }
}

/// What is said about a plant before the search: orders of magnitude.
#[derive(Clone, Copy)]
pub struct Facts<const N: usize> {
    /// A usual rate λ of the closed loop, in 1/s.
    pub rate: f64,
    /// The size of an uncertainty that has to be expected, in the units of ẋ_n.
    pub delta: f64,
    /// How large the errors are that the memberships have to cover.
    pub errors: [f64; N],
    /// b₀ of y⁽ᴺ⁾ = … + b₀·u, for those who see the output alone.
    pub input_gain: f64,
    /// A gain K that a PID controller may have.
    pub pid_gain: f64,
    /// The period in s.
    pub period: f64,
}

impl<const N: usize> Facts<N> {
    /// The parameter λ.
    fn lambda(&self) -> Parameter {
        ("λ", around(self.rate, 3.0))
    }
}

/// From `middle` by a `factor` down and up.
fn around(middle: f64, factor: f64) -> [f64; 2] {
    [middle / factor, middle * factor]
}

/// Every law for the plant that `model` describes, with networks of K memberships an input.
pub fn all<P, const N: usize, const K: usize>(model: P, facts: Facts<N>) -> Vec<Contestant<N>>
where
    P: FeedbackLinearizable<N, Scalar = f64> + Copy + Send + Sync + 'static,
    Inputs<N>: Grid,
{
    let mut all = feedback::of(model, facts);
    all.extend(robust::of(model, facts));
    all.extend(learning::of::<P, N, K>(model, facts));
    all
}
