//! What the modules of this room share.

use brunovsky::{
    Scalar,
    controller::{Clelc, Controller, FeedbackLinearization, Gains},
    fuzzy::{FuzzyNetwork, Grid, Inputs},
    learning::{Antecedents, Flow, NeuroFuzzy, SlidingMode},
    plant::{FeedbackLinearizable, Plant},
    simulation::{Sample, Simulation},
};
use nalgebra::{DMatrix, DVector, SVector};

/// `value` in the scalar type of the check.
pub fn num<T: Scalar>(value: f64) -> T {
    nalgebra::convert(value)
}

/// `value` as f64, to be compared with a tolerance.
pub fn real<T: Scalar>(value: T) -> f64 {
    nalgebra::try_convert(value).unwrap()
}

/// Feedback linearization with all poles at −λ.
pub fn flc<P: FeedbackLinearizable<N>, const N: usize>(
    model: P,
    lambda: f64,
) -> FeedbackLinearization<P, N> {
    FeedbackLinearization::new(model, Gains::from_lambda(num(lambda)).unwrap())
}

/// CLELC as most tests use it: three memberships over ±1 an input.
pub type Learning<P, E, T, const N: usize, A = Flow<T>> =
    Clelc<P, NeuroFuzzy<FuzzyNetwork<T, N, 3>, E, SlidingMode<T, A>>, N>;

/// CLELC with all poles at −λ and `rule`, with ė_n from `error_rate`.
pub fn learning<P, E, T: Scalar, A, const N: usize>(
    model: P,
    lambda: f64,
    error_rate: E,
    rule: SlidingMode<T, A>,
) -> Learning<P, E, T, N, A>
where
    P: FeedbackLinearizable<N, Scalar = T>,
    E: brunovsky::learning::ErrorRate<T, N> + Clone,
    A: Antecedents<FuzzyNetwork<T, N, 3>> + Clone,
    Inputs<N>: Grid,
{
    let network = FuzzyNetwork::evenly_spaced([T::one(); N]).unwrap();
    Clelc::new(flc(model, lambda), NeuroFuzzy::new(network, error_rate, rule))
}

/// All samples of a closed loop from `x0` up to `t_end`.
pub fn run<P, C, T, const N: usize>(
    plant: &P,
    controller: C,
    reference: impl FnMut(T) -> C::Reference,
    x0: impl Into<SVector<T, N>>,
    dt: f64,
    t_end: f64,
) -> Vec<Sample<T, C::Reference, C::Command, N, 1>>
where
    T: Scalar,
    P: Plant<N, 1, Scalar = T>,
    C: Controller<N, 1, Scalar = T>,
{
    let simulation = Simulation::new(plant, controller, reference, x0, num(dt)).unwrap();
    let samples = simulation.until(num(t_end)).unwrap();
    samples.collect::<Result<_, _>>().unwrap()
}

/// e(t) = exp(A·t)·e(0) for the error dynamics ė_n + k_n·e_n + … + k₁·e₁ = 0, A their companion matrix.
pub fn error_dynamics<const N: usize>(
    k: &SVector<f64, N>,
    e: &SVector<f64, N>,
    t: f64,
) -> SVector<f64, N> {
    let a =
        DMatrix::from_fn(
            N,
            N,
            |i, j| {
                if i + 1 == N { -k[j] } else { f64::from(u8::from(i + 1 == j)) }
            },
        );
    let end = (a * t).exp() * DVector::from_column_slice(e.as_slice());
    SVector::from_column_slice(end.as_slice())
}
