//! What can be wrong with an input, and the checks that find it.

use nalgebra::SVector;

use crate::{Scalar, scalar::constant};

/// Why a value was refused. Every variant names the quantity and carries its value.
///
/// Constructors validate parameters once. Afterwards `update` fails only for reasons that depend on the measurement, the
/// reference or the state, and leaves the controller as it was.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// NaN or infinite: given by the caller, returned by a plant, or grown beyond the range of the scalar.
    #[error("{name} = {value} is not finite")]
    NonFinite {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A vector with a NaN or infinite entry.
    #[error("{name}[{index}] = {value} is not finite")]
    NonFiniteEntry {
        /// The vector.
        name: &'static str,
        /// The entry, counted from 0.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A right-hand side that is NaN or infinite where an adaptive method stands.
    #[error("f[{index}] = {value} at t = {time} is not finite")]
    NonFiniteRate {
        /// The time.
        time: f64,
        /// The entry, counted from 0.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// An adaptive method that finds no step within its tolerance: at a pole or a jump of the right-hand side, or where rounding alone is more.
    #[error("no step from t = {time} is within the tolerance, down to {step}")]
    StepTooSmall {
        /// The time.
        time: f64,
        /// The step that is too small to change it.
        step: f64,
    },
    /// An adaptive method that needs more steps than it was given.
    #[error("more than {limit} steps, at t = {time}")]
    TooManySteps {
        /// The time reached.
        time: f64,
        /// The number of steps allowed.
        limit: u64,
    },
    /// A quantity that has to be greater than zero: a period, a width, a learning rate.
    #[error("{name} = {value} must be greater than 0")]
    NotPositive {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A quantity that has to be zero or greater.
    #[error("{name} = {value} must not be negative")]
    Negative {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A quantity that has to lie below another: the lower end of a range, say.
    #[error("{name} = {value} must be less than {limit}")]
    NotBelow {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it has to lie below.
        limit: f64,
    },
    /// A quantity that has to be another at the most.
    #[error("{name} = {value} must not be above {limit}")]
    Above {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it may be at the most.
        limit: f64,
    },
    /// A quantity that has to keep a distance from zero.
    #[error("{name}[{index}] = {value} is closer to 0 than {limit}")]
    TooSmall {
        /// The vector, or the rows of the matrix.
        name: &'static str,
        /// The entry or row, counted from 0.
        index: usize,
        /// Its largest absolute value.
        value: f64,
        /// The smallest absolute value allowed.
        limit: f64,
    },
    /// No input acts on the first derivatives of an output, up to the order of the plant.
    #[error(
        "no input acts on derivatives 1 to {derivatives} of output {output}: the largest |L_g L_f^k h| is {value}, \
         with a rounding error of up to {rounding}"
    )]
    Unreached {
        /// The output, counted from 0.
        output: usize,
        /// The highest derivative that was looked at.
        derivatives: usize,
        /// The largest Lie derivative by an input, in units of its rounding error.
        value: f64,
        /// The bound on its rounding error.
        rounding: f64,
    },
    /// The relative degree of an output is not defined: its decisive Lie derivative vanishes at a state and not beside it.
    #[error(
        "output {output} has no relative degree at x: L_g L_f^{order} h = {value} there, with a rounding error of up to \
         {rounding}, and does not vanish beside x"
    )]
    UndefinedRelativeDegree {
        /// The output, counted from 0.
        output: usize,
        /// How many times f comes before g.
        order: usize,
        /// The largest |L_g L_f^order h| at the state.
        value: f64,
        /// The bound on its rounding error.
        rounding: f64,
    },
    /// An output with another relative degree than its controller is for.
    #[error("output {output} has relative degree {found}, not {expected}")]
    RelativeDegree {
        /// The output, counted from 0.
        output: usize,
        /// The relative degree asked for.
        expected: usize,
        /// The relative degree found.
        found: usize,
    },
    /// A quantity that the law divides by has vanished, so no input produces the commanded motion.
    #[error("{name} = {value} is singular")]
    Singular {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A matrix that the law inverts is so ill-conditioned that the input would be noise.
    #[error("{name} has condition number {condition}, above {limit}")]
    IllConditioned {
        /// The matrix.
        name: &'static str,
        /// Its condition number in the maximum norm, ‖B‖·‖B⁻¹‖; infinite if it is singular.
        condition: f64,
        /// The largest condition number allowed.
        limit: f64,
    },
    /// A complex number that has to come with its conjugate and does not.
    #[error("{name} = {value} has no conjugate beside it")]
    Unpaired {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A characteristic polynomial with a root in the closed right half plane.
    #[error(
        "{name} are not Hurwitz: entry {row} in the first column of the Routh array is {value}, not positive"
    )]
    NotHurwitz {
        /// The gains.
        name: &'static str,
        /// The row of the Routh array, counted from 0 (the leading coefficient 1).
        row: usize,
        /// The entry found there.
        value: f64,
    },
    /// A matrix that has to be symmetric and differs from its transpose by more than rounding.
    #[error(
        "{name} is not symmetric: {below} at ({row}, {column}) and {above} at ({column}, {row})"
    )]
    Asymmetric {
        /// The matrix.
        name: &'static str,
        /// The row of the entry below the diagonal, counted from 0.
        row: usize,
        /// Its column.
        column: usize,
        /// Its value.
        below: f64,
        /// That of the entry opposite.
        above: f64,
    },
    /// A Riccati or Lyapunov equation without a stabilizing solution.
    #[error(
        "the {name} has no stabilizing solution: a mode that is not stable is out of reach of the input or of the cost, and {left} of it is left"
    )]
    NotStabilizable {
        /// The equation.
        name: &'static str,
        /// The largest entry of what is left of the state after the longest time looked at.
        left: f64,
    },
    /// An equation whose solution does not fulfil it.
    #[error("the {name} is solved with a residual of {residual} only, above {limit}")]
    Unsolved {
        /// The equation.
        name: &'static str,
        /// What is left of it, as a share of its terms.
        residual: f64,
        /// The largest share allowed.
        limit: f64,
    },
    /// A slice of the wrong length.
    #[error("{name} has {found} entries, not {expected}")]
    Length {
        /// The slice.
        name: &'static str,
        /// The length that fits.
        expected: usize,
        /// The length given.
        found: usize,
    },
    /// Something that this configuration needs was not given.
    #[error("{name} is missing")]
    Missing {
        /// What is missing.
        name: &'static str,
    },
}

/// `value` as an `f64`, for the message.
pub(crate) fn value<T: Scalar>(value: T) -> f64 {
    value.to_subset_unchecked()
}

pub(crate) fn finite<T: Scalar>(name: &'static str, x: T) -> Result<T, Error> {
    if x.is_finite() { Ok(x) } else { Err(Error::NonFinite { name, value: value(x) }) }
}

pub(crate) fn finite_vector<T: Scalar, const N: usize>(
    name: &'static str,
    x: &SVector<T, N>,
) -> Result<(), Error> {
    finite_slice(name, x.as_slice())
}

pub(crate) fn finite_slice<T: Scalar>(name: &'static str, x: &[T]) -> Result<(), Error> {
    match x.iter().enumerate().find(|(_, entry)| !entry.is_finite()) {
        None => Ok(()),
        Some((index, entry)) => Err(Error::NonFiniteEntry { name, index, value: value(*entry) }),
    }
}

pub(crate) fn positive<T: Scalar>(name: &'static str, x: T) -> Result<T, Error> {
    if finite(name, x)? > T::zero() {
        Ok(x)
    } else {
        Err(Error::NotPositive { name, value: value(x) })
    }
}

pub(crate) fn not_negative<T: Scalar>(name: &'static str, x: T) -> Result<T, Error> {
    if finite(name, x)? >= T::zero() {
        Ok(x)
    } else {
        Err(Error::Negative { name, value: value(x) })
    }
}

pub(crate) fn positive_vector<T: Scalar, const N: usize>(
    name: &'static str,
    x: &SVector<T, N>,
) -> Result<(), Error> {
    x.iter().try_for_each(|entry| positive(name, *entry).map(|_| ()))
}

pub(crate) fn not_negative_vector<T: Scalar, const N: usize>(
    name: &'static str,
    x: &SVector<T, N>,
) -> Result<(), Error> {
    x.iter().try_for_each(|entry| not_negative(name, *entry).map(|_| ()))
}

/// `x`, which is to be remembered, if differences with it over periods like `dt` are within the range of `T`: or else every sample after this
/// one would be refused in its place. The factor is room for shorter periods, and for sums.
pub(crate) fn remembered<T: Scalar>(name: &'static str, x: T, dt: T) -> Result<T, Error> {
    finite(name, x / dt * constant(1024.0))?;
    Ok(x)
}

/// `x`, if it lies below `limit`; both are finite already.
pub(crate) fn below<T: Scalar>(name: &'static str, x: T, limit: T) -> Result<T, Error> {
    if x < limit {
        Ok(x)
    } else {
        Err(Error::NotBelow { name, value: value(x), limit: value(limit) })
    }
}

/// `x`, if it is `limit` at the most; both are finite already.
pub(crate) fn at_most<T: Scalar>(name: &'static str, x: T, limit: T) -> Result<T, Error> {
    if x <= limit {
        Ok(x)
    } else {
        Err(Error::Above { name, value: value(x), limit: value(limit) })
    }
}
