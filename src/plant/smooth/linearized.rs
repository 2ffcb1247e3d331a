use core::array;

use nalgebra::{ComplexField, SMatrix, SVector};

use super::{
    Flow, LieDerivatives, RelativeDegree, SmoothPlant,
    flow::{Along, along_inputs},
};
use crate::{
    Error, Scalar,
    differentiation::Dual,
    error::{finite_slice, finite_vector, not_negative, value},
    plant::{ControlAffine, Decouplable, Linearization},
    scalar::epsilon,
};

/// A plant given by its equations, in chain form: zᵢ = (hᵢ, L_f hᵢ, …, L_f^{N−1} hᵢ), aᵢ = L_f^N hᵢ, Bᵢⱼ = L_{gⱼ} L_f^{N−1} hᵢ.
///
/// It is [`Decouplable`], so [`Decoupling`](crate::controller::Decoupling) controls it with one controller a chain; and it is a plant to simulate. Its
/// state stays x. All derivatives are exact to rounding, and computed anew at every state; see [`Flow`].
///
/// What [`RelativeDegree`] says about zero dynamics holds: where N·M < NX, stabilizing the outputs need not stabilize the plant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linearized<P, const NX: usize, const N: usize, const M: usize>
where
    P: SmoothPlant<NX, M>,
{
    plant: P,
    degrees: [usize; M],
    min_gains: [P::Scalar; M],
}

impl<P, const NX: usize, const N: usize, const M: usize> Linearized<P, NX, N, M>
where
    P: SmoothPlant<NX, M>,
{
    /// `plant`, whose outputs have relative degree N at the operating point `x`.
    ///
    /// # Errors
    /// [`Error::RelativeDegree`] if they have another; [`Error::Unreached`], [`Error::UndefinedRelativeDegree`] and
    /// [`Error::IllConditioned`] if they have none at `x`; [`Error::NonFiniteEntry`] and [`Error::NonFinite`] for `x`, f, g, h and
    /// their derivatives.
    pub fn new(plant: P, x: impl Into<SVector<P::Scalar, NX>>) -> Result<Self, Error> {
        Self::with_degrees(plant, [N; M], x)
    }

    /// `plant`, whose outputs have the relative `degrees` rᵢ ≤ N at the operating point `x`.
    ///
    /// Shorter chains are at the end of the longer ones, as [`Decouplable`] has it.
    ///
    /// # Errors
    /// As [`new`](Self::new), and [`Error::RelativeDegree`] for one above N.
    pub fn with_degrees(
        plant: P,
        degrees: [usize; M],
        x: impl Into<SVector<P::Scalar, NX>>,
    ) -> Result<Self, Error> {
        let at = RelativeDegree::at(&plant, x.into())?;
        for (output, (&expected, &found)) in degrees.iter().zip(&at.degrees).enumerate() {
            if expected != found {
                return Err(Error::RelativeDegree { output, expected, found });
            }
            if found > N {
                return Err(Error::RelativeDegree { output, expected: N, found });
            }
        }
        let min_gains = array::from_fn(|i| {
            let decisive = at.lie_derivatives[i].iter().map(|row| row[degrees[i] - 1].value());
            largest(decisive) * epsilon::<P::Scalar>().sqrt()
        });
        Ok(Self { plant, degrees, min_gains })
    }

    /// The same with other limits on the rows of B(x): where all entries of row i are below `min_gains[i]` ≥ 0, the state is refused. They are √ε
    /// times the largest entry at the operating point by default.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn with_min_gains(self, min_gains: [P::Scalar; M]) -> Result<Self, Error> {
        for limit in min_gains {
            not_negative("min_gains", limit)?;
        }
        Ok(Self { min_gains, ..self })
    }

    /// The plant by its equations.
    pub fn plant(&self) -> &P {
        &self.plant
    }

    /// The order of chain i; N if there is no such chain.
    fn degree(&self, i: usize) -> usize {
        self.degrees.get(i).copied().unwrap_or(N)
    }
}

impl<P, const NX: usize, const N: usize, const M: usize> Linearized<P, NX, N, M>
where
    P: SmoothPlant<NX, M>,
    Along: Flow<N>,
{
    #[inline]
    fn lie(&self, x: &SVector<P::Scalar, NX>) -> LieDerivatives<P::Scalar, N, M, M> {
        Along::lie(&self.plant, &along_inputs(&self.plant, (*x).into()))
    }

    /// The slopes of L_f^{rᵢ−1} hᵢ.
    #[inline]
    fn decisive<const D: usize>(
        &self,
        slopes: &[[[P::Scalar; N]; D]; M],
    ) -> SMatrix<P::Scalar, M, D> {
        SMatrix::from_fn(|i, j| slopes[i][j][self.degree(i) - 1])
    }

    #[inline]
    fn linear(&self, lie: &LieDerivatives<P::Scalar, N, M, M>) -> Linearization<P::Scalar, N, M> {
        let padding = |i: usize| N - self.degree(i);
        let matrix = self.decisive(&lie.slopes);
        Linearization {
            chains: array::from_fn(|i| {
                let entry = |k: usize| k.checked_sub(padding(i)).map(|k| lie.chains[i][k]);
                SVector::from_fn(|k, _| entry(k).unwrap_or(nalgebra::zero()))
            }),
            drift: SVector::from_fn(|i, _| {
                lie.chains[i].get(self.degree(i)).copied().unwrap_or(lie.drift[i])
            }),
            matrix,
            inverted: matrix,
        }
    }
}

impl<P, const NX: usize, const N: usize, const M: usize> ControlAffine<NX, M>
    for Linearized<P, NX, N, M>
where
    P: SmoothPlant<NX, M>,
{
    type Scalar = P::Scalar;

    fn drift_field(&self, x: &SVector<P::Scalar, NX>) -> SVector<P::Scalar, NX> {
        self.plant.drift_field::<P::Scalar>((*x).into()).into()
    }

    fn input_fields(&self, x: &SVector<P::Scalar, NX>) -> SMatrix<P::Scalar, NX, M> {
        self.plant.input_fields::<P::Scalar>((*x).into()).into()
    }
}

impl<P, const NX: usize, const N: usize, const M: usize> Decouplable<NX, N, M>
    for Linearized<P, NX, N, M>
where
    P: SmoothPlant<NX, M>,
    Along: Flow<N>,
{
    type Scalar = P::Scalar;

    fn chains(&self, x: &SVector<P::Scalar, NX>) -> [SVector<P::Scalar, N>; M] {
        self.linear(&self.lie(x)).chains
    }

    fn chain_drift(&self, x: &SVector<P::Scalar, NX>) -> SVector<P::Scalar, M> {
        self.linear(&self.lie(x)).drift
    }

    fn decoupling_matrix(&self, x: &SVector<P::Scalar, NX>) -> SMatrix<P::Scalar, M, M> {
        self.linear(&self.lie(x)).matrix
    }

    fn chain_rates(
        &self,
        x: &SVector<P::Scalar, NX>,
        x_dot: &SVector<P::Scalar, NX>,
    ) -> SVector<P::Scalar, M> {
        let start = array::from_fn(|i| Dual { value: x[i], slopes: [x_dot[i]] });
        self.decisive(&<Along as Flow<N>>::lie(&self.plant, &start).slopes)
    }

    /// # Errors
    /// [`Error::NonFiniteEntry`], naming the first of f(x), g(x), h(x), z, a(x) and B(x) that is not finite; [`Error::TooSmall`] for a row
    /// of B(x).
    fn linearization(
        &self,
        x: &SVector<P::Scalar, NX>,
    ) -> Result<Linearization<P::Scalar, N, M>, Error> {
        let at = self.linear(&self.lie(x));
        if let Err(derived) = finite_linearization(&at) {
            finite_equations(&self.plant, x)?;
            return Err(derived);
        }
        for (index, (row, limit)) in at.matrix.row_iter().zip(self.min_gains).enumerate() {
            let gain = largest(row.iter().copied());
            if gain < limit {
                let (value, limit) = (value(gain), value(limit));
                return Err(Error::TooSmall { name: "B(x)", index, value, limit });
            }
        }
        Ok(at)
    }
}

fn largest<T: Scalar>(values: impl Iterator<Item = T>) -> T {
    values.fold(T::zero(), |largest, value| largest.max(value.abs()))
}

fn finite_linearization<T: Scalar, const N: usize, const M: usize>(
    at: &Linearization<T, N, M>,
) -> Result<(), Error> {
    at.chains.iter().try_for_each(|chain| finite_vector("z", chain))?;
    finite_vector("a(x)", &at.drift)?;
    finite_slice("B(x)", at.matrix.as_slice())
}

/// Checks x, f(x), the columns of g(x) one after another, and h(x).
pub(super) fn finite_equations<P, const NX: usize, const M: usize>(
    plant: &P,
    x: &SVector<P::Scalar, NX>,
) -> Result<(), Error>
where
    P: SmoothPlant<NX, M>,
{
    finite_vector("x", x)?;
    let x: [P::Scalar; NX] = (*x).into();
    finite_slice("f(x)", &plant.drift_field(x))?;
    finite_slice("g(x)", plant.input_fields(x).as_flattened())?;
    finite_slice("h(x)", &plant.outputs(x))
}

checked! {
    [P, const NX: usize, const N: usize, const M: usize] Linearized<P, NX, N, M>,
    [P, P::Scalar; P: SmoothPlant<NX, M>]
    {
        plant: P,
        degrees: Array<usize, M> = Array(*degrees),
        min_gains: Array<P::Scalar, M> = Array(*min_gains),
    } =>
    {
        let refused = |&(_, degree): &(usize, usize)| !(1..=N).contains(&degree);
        match degrees.0.into_iter().enumerate().find(refused) {
            Some((output, found)) => Err(Error::RelativeDegree { output, expected: N, found }),
            None => Self { plant, degrees: degrees.0, min_gains: min_gains.0 }.with_min_gains(min_gains.0),
        }
    }
}
