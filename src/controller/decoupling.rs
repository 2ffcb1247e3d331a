use nalgebra::{SMatrix, SVector};
use num_traits::One;

use super::{Accept, ChainControllers, Command, Controller, Measurement, Reference};
use crate::{
    Error, Scalar,
    conditioning::{max_condition, norm},
    error::{finite_vector, positive, remembered, value},
    inverse::inverse,
    learning::LearningMode,
    plant::{Decouplable, Linearization},
    scalar::constant,
};

/// Decoupling control: u = B(x)⁻¹·(−a(x) + ν), with one controller for each of the M chains deciding its νᵢ.
///
/// If the plant is the model, the loop falls apart into M loops zᵢ⁽ᴺ⁾ = νᵢ, each as good as its controller. An uncertainty of the plant
/// appears in them as Δ, and chains under [`Clelc`](super::Clelc) learn it.
///
/// Each chain's controller is told what it cannot see: the νᵢ that the applied input really amounted to over the last period,
/// ½·((a + B·u)(k−1) + (a + B·u)(k)), and zᵢ⁽ᴺ⁾ if ẋ is measured.
///
/// The two-link arm (a full B with the inverse mass matrix) and the unicycle with its dynamic extension (B of determinant v) are both of
/// this form; the [unicycle's controller](super::unicycle) adds no more than the integrator from ξ to v.
///
/// Assumes a regular B(x): a condition number above the limit is an `Err`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decoupling<P, C, const NX: usize, const N: usize, const M: usize>
where
    P: Decouplable<NX, N, M>,
{
    model: P,
    chains: C,
    max_condition: P::Scalar,
    input: SVector<P::Scalar, M>,
    last: Option<Linearization<P::Scalar, N, M>>,
}

/// An input of [`Decoupling`] and how it came about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecouplingCommand<T, D, const M: usize> {
    /// The input u, in the plant's units.
    pub u: SVector<T, M>,
    /// The virtual inputs ν, in the units of z⁽ᴺ⁾.
    pub nu: SVector<T, M>,
    /// What each chain's controller decided.
    pub chains: D,
}

impl<T: Scalar, D: Copy, const M: usize> Command<T, M> for DecouplingCommand<T, D, M> {
    fn input(&self) -> SVector<T, M> {
        self.u
    }
}

impl<P, C, const NX: usize, const N: usize, const M: usize> Decoupling<P, C, NX, N, M>
where
    P: Decouplable<NX, N, M>,
    C: ChainControllers<P::Scalar, N, M>,
{
    /// A controller for the plant that `model` describes, with `chains` deciding ν. B(x) may have a condition number of 1/√ε.
    pub fn new(model: P, chains: C) -> Self {
        Self { model, chains, max_condition: max_condition(), input: SVector::zeros(), last: None }
    }

    /// The same controller with another limit on the condition number ‖B‖·‖B⁻¹‖ (maximum norm).
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_max_condition(self, limit: P::Scalar) -> Result<Self, Error> {
        Ok(Self { max_condition: positive("condition number limit", limit)?, ..self })
    }

    /// The model that the law inverts.
    pub fn model(&self) -> &P {
        &self.model
    }

    /// The controllers of the chains.
    pub fn chains(&self) -> &C {
        &self.chains
    }

    /// The controllers of the chains, to be changed.
    pub fn chains_mut(&mut self) -> &mut C {
        &mut self.chains
    }
}

impl<P, C, const NX: usize, const N: usize, const M: usize> Controller<NX, M>
    for Decoupling<P, C, NX, N, M>
where
    P: Decouplable<NX, N, M>,
    C: ChainControllers<P::Scalar, N, M>,
{
    type Scalar = P::Scalar;
    type Reference = [Reference<P::Scalar, N>; M];
    type Command = DecouplingCommand<P::Scalar, C::Commands, M>;

    /// # Errors
    /// [`Error::NotPositive`] for `dt`; [`Error::NonFiniteEntry`] for the measurement, a(x), the chains and u;
    /// [`Error::IllConditioned`] for B(x); [`Error::NonFinite`] for a(x) and u that are too large to be remembered; those of
    /// [`Decouplable::linearization`], and those of the chains' controllers.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, NX, M>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        positive("dt", dt)?;
        measurement.validate()?;
        let x = &measurement.x;
        let now = self.model.linearization(x)?;
        let inverse = inverted(&now.inverted, self.max_condition)?;

        let applied = measurement.applied.unwrap_or(self.input);
        let end = now.drift + now.matrix * applied;
        let start = self.last.map_or(end, |last| last.drift + last.matrix * applied);
        let mean = (start + end) * constant::<P::Scalar>(0.5);
        let states = now.chains;
        // A rate is measured at the end of the period, where the input amounts to `end`; the chain is told `mean`.
        let rates = measurement.x_dot.map(|x_dot| self.model.chain_rates(x, &x_dot) - end + mean);
        let told = core::array::from_fn(|i| {
            let chain = Measurement::new(states[i]).with_applied([mean[i]]);
            match rates {
                None => chain,
                // Of the chain's derivative the entries below the last are its state.
                Some(rates) => chain.with_rate(SVector::from_fn(|j, _| {
                    states[i].get(j + 1).copied().unwrap_or(rates[i])
                })),
            }
        });
        let command =
            |(nu, chains)| DecouplingCommand { u: inverse * (nu - now.drift), nu, chains };
        let decided = self.chains.update_all(&told, reference, dt, &mut |decided| {
            let command = command(*decided);
            finite_vector("u", &command.u)?;
            for (u, drift) in command.u.iter().zip(now.drift.iter()) {
                remembered("u", *u, P::Scalar::one())?;
                remembered("a(x)", *drift, P::Scalar::one())?;
            }
            accept(&command)
        })?;
        let command = command(decided);

        self.input = command.u;
        self.last = Some(now);
        Ok(command)
    }

    fn reset(&mut self) {
        self.chains.reset_all();
        self.input = SVector::zeros();
        self.last = None;
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.chains.set_learning_all(mode);
    }
}

/// B⁻¹, if ‖B‖·‖B⁻¹‖ in the maximum norm is within `limit`.
fn inverted<T: Scalar, const M: usize>(
    matrix: &SMatrix<T, M, M>,
    limit: T,
) -> Result<SMatrix<T, M, M>, Error> {
    let refused =
        |condition| Error::IllConditioned { name: "B(x)", condition, limit: value(limit) };
    // A matrix that is not finite has no inverse either; a maximum norm would pass over its NaNs.
    let finite = matrix.iter().all(|entry| entry.is_finite());
    let inverse = inverse(matrix).filter(|_| finite).ok_or(refused(f64::INFINITY))?;
    let condition = norm(matrix) * norm(&inverse);
    if condition <= limit { Ok(inverse) } else { Err(refused(value(condition))) }
}

checked! {
    [P: Decouplable<NX, N, M>, C, const NX: usize, const N: usize, const M: usize]
    Decoupling<P, C, NX, N, M>, [P, C, P::Scalar]
    {
        model: P,
        chains: C,
        max_condition: P::Scalar,
        input: SVector<P::Scalar, M>,
        last: Option<Linearization<P::Scalar, N, M>>,
    } =>
    positive("condition number limit", max_condition)
        .and_then(|_| known("last u", input.iter().copied()))
        .map(|()| Self { model, chains, max_condition, input, last })
}
