use core::array;

use nalgebra::{SMatrix, SVector};

use super::{
    BoxSamples, SmoothPlant,
    flow::{all_slopes, along_inputs},
    linearized::finite_equations,
};
use crate::{
    Error, Scalar,
    conditioning::{max_condition, norm},
    differentiation::RunningError,
    error::{finite, finite_vector, value},
    inverse::inverse,
    scalar::{constant, epsilon},
};

/// The vector relative degree of a plant at a state or over many: rᵢ is the lowest derivative of output i that an input acts on, the first with an
/// L_{gⱼ} L_f^{rᵢ−1} hᵢ ≠ 0.
///
/// "Zero" means zero up to rounding: every Lie derivative is computed with a [`RunningError`], and counts as zero if that may be all there
/// is to it. A Lie derivative below rᵢ − 1 vanished at every state that was looked at.
///
/// If rᵢ add up to less than NX, [`zero_dynamics`](Self::zero_dynamics) of that order remain, which no controller of these outputs sees
/// or stabilizes: where they are unstable (a plant that is not of minimum phase), the states grow while the outputs follow their references
/// exactly. This struct counts them, and does not judge them.
///
/// # References
/// A. Isidori, *Nonlinear Control Systems*, 4.1 and 5.1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeDegree<T, const NX: usize, const M: usize> {
    /// r, one entry for each output.
    pub degrees: [usize; M],
    /// L_{gⱼ} L_f^k hᵢ at `[i][j][k]`: of all states, the one that is largest in units of its rounding error.
    pub lie_derivatives: [[[RunningError<T>; NX]; M]; M],
    /// How many states were looked at.
    pub states: usize,
    /// At how many of them the relative degree is not defined: a row of the decoupling matrix vanishes, or its condition number is above 1/√ε.
    pub singular: usize,
    /// The smallest distance of the decoupling matrix from a singular one, 1/‖B⁻¹‖ in the maximum norm; |b(x)| for M = 1.
    pub smallest_gain: T,
    /// The state where that was.
    pub weakest: SVector<T, NX>,
    /// The largest condition number ‖B‖·‖B⁻¹‖ in the maximum norm; infinite where B is singular.
    pub condition: T,
}

type Table<T, const NX: usize, const M: usize> = [[[RunningError<T>; NX]; M]; M];

impl<T: Scalar, const NX: usize, const M: usize> RelativeDegree<T, NX, M> {
    /// Whether the relative degree is defined at all the states.
    pub fn is_uniform(&self) -> bool {
        self.singular == 0
    }

    /// The order NX − Σ rᵢ of the zero dynamics.
    pub fn zero_dynamics(&self) -> usize {
        NX.saturating_sub(self.degrees.iter().sum())
    }

    /// The relative degree at `x`: also the states close by have a say in what vanishes.
    pub(super) fn at<P>(plant: &P, x: SVector<T, NX>) -> Result<Self, Error>
    where
        P: SmoothPlant<NX, M, Scalar = T>,
    {
        finite_vector("x", &x)?;
        // Far enough for a slope to show above rounding, and close enough for everything else to stay as it is.
        let distance = x.map(|x| (T::one() + x.abs()) * epsilon::<T>().sqrt().sqrt());
        let near = BoxSamples::new(x - distance, x + distance)?.skip(1).take(NX + 1);
        let (degrees, _) = found(plant, core::iter::once(x).chain(near))?;
        let lie_derivatives = table(plant, &x)?;
        for (output, (rows, degree)) in lie_derivatives.iter().zip(degrees).enumerate() {
            let order = degree - 1;
            let largest = rows.iter().map(|row| row[order]).fold(rows[0][order], more_significant);
            if largest.vanishes() {
                return Err(Error::UndefinedRelativeDegree {
                    output,
                    order,
                    value: value(largest.value()),
                    rounding: value(largest.rounding()),
                });
            }
        }
        let judged = Self::judged(plant, degrees, lie_derivatives, core::iter::once(x))?;
        if judged.is_uniform() {
            Ok(judged)
        } else {
            let (condition, limit) = (value(judged.condition), value(max_condition::<T>()));
            Err(Error::IllConditioned { name: "B(x)", condition, limit })
        }
    }

    /// The relative degree over `states`.
    pub(super) fn over<P, I>(plant: &P, states: I) -> Result<Self, Error>
    where
        P: SmoothPlant<NX, M, Scalar = T>,
        I: Iterator<Item = SVector<T, NX>> + Clone,
    {
        let (degrees, lie_derivatives) = found(plant, states.clone())?;
        Self::judged(plant, degrees, lie_derivatives, states)
    }

    /// How far the decoupling matrix is from singular, at the worst of the states.
    fn judged<P>(
        plant: &P,
        degrees: [usize; M],
        lie_derivatives: Table<T, NX, M>,
        states: impl Iterator<Item = SVector<T, NX>>,
    ) -> Result<Self, Error>
    where
        P: SmoothPlant<NX, M, Scalar = T>,
    {
        let mut judged = Self {
            degrees,
            lie_derivatives,
            states: 0,
            singular: 0,
            smallest_gain: constant(f64::INFINITY),
            weakest: SVector::zeros(),
            condition: T::zero(),
        };
        for x in states {
            let table = table(plant, &x)?;
            let decisive = |i: usize, j: usize| table[i][j][degrees[i] - 1];
            let vanishes = (0..M).any(|i| (0..M).all(|j| decisive(i, j).vanishes()));
            let matrix = SMatrix::<T, M, M>::from_fn(|i, j| decisive(i, j).value());
            let (gain, condition) = conditioning(&matrix);
            judged.states += 1;
            if vanishes || condition > max_condition() {
                judged.singular += 1;
            }
            judged.condition = judged.condition.max(condition);
            if gain < judged.smallest_gain {
                (judged.smallest_gain, judged.weakest) = (gain, x);
            }
        }
        Ok(judged)
    }
}

/// The lowest orders at which an input acts anywhere, plus one; and the most significant of all Lie derivatives.
fn found<P, const NX: usize, const M: usize>(
    plant: &P,
    states: impl Iterator<Item = SVector<P::Scalar, NX>>,
) -> Result<([usize; M], Table<P::Scalar, NX, M>), Error>
where
    P: SmoothPlant<NX, M>,
{
    let mut most: Option<Table<P::Scalar, NX, M>> = None;
    for x in states {
        let here = table(plant, &x)?;
        most = Some(match most {
            None => here,
            Some(most) => array::from_fn(|i| {
                array::from_fn(|j| {
                    array::from_fn(|k| more_significant(most[i][j][k], here[i][j][k]))
                })
            }),
        });
    }
    let most = most.ok_or(Error::Missing { name: "state" })?;
    let mut degrees = [0; M];
    for (output, (degree, rows)) in degrees.iter_mut().zip(&most).enumerate() {
        let acts = |k: &usize| rows.iter().any(|row| !row[*k].vanishes());
        *degree = 1
            + (0..NX).find(acts).ok_or_else(|| {
                let all = rows.iter().flatten().copied();
                let largest = all.fold(rows[0][0], more_significant);
                Error::Unreached {
                    output,
                    derivatives: NX,
                    value: value(largest.value()),
                    rounding: value(largest.rounding()),
                }
            })?;
    }
    Ok((degrees, most))
}

/// L_{gⱼ} L_f^k hᵢ at `[i][j][k]`.
fn table<P, const NX: usize, const M: usize>(
    plant: &P,
    x: &SVector<P::Scalar, NX>,
) -> Result<Table<P::Scalar, NX, M>, Error>
where
    P: SmoothPlant<NX, M>,
{
    finite_equations(plant, x)?;
    let start = along_inputs(plant, array::from_fn(|i| RunningError::from(x[i])));
    let table: Table<P::Scalar, NX, M> = all_slopes(plant, &start);
    for entry in table.iter().flatten().flatten() {
        finite("L_g L_f^k h", entry.value() + entry.rounding())?;
    }
    Ok(table)
}

/// The one that is larger in units of its rounding error.
fn more_significant<T: Scalar>(a: RunningError<T>, b: RunningError<T>) -> RunningError<T> {
    // Products instead of quotients: the rounding error of an exact zero is zero.
    if b.value().abs() * a.rounding() > a.value().abs() * b.rounding()
        || (a.value().is_zero() && !b.value().is_zero())
    {
        b
    } else {
        a
    }
}

/// 1/‖B⁻¹‖ and ‖B‖·‖B⁻¹‖ in the maximum norm.
fn conditioning<T: Scalar, const M: usize>(matrix: &SMatrix<T, M, M>) -> (T, T) {
    match inverse(matrix) {
        None => (T::zero(), constant(f64::INFINITY)),
        Some(inverse) => {
            let inverse = norm(&inverse);
            (inverse.recip(), norm(matrix) * inverse)
        }
    }
}
