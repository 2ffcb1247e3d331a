use super::validated;
use crate::{Error, Scalar, error::finite_slice, scalar::constant};

/// Estimates zᵢ of the derivatives y⁽ⁱ⁾, i < M, at a sample: predicted by Taylor's formula, and corrected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Chain<T, const M: usize>(pub [T; M]);

impl<T: Scalar, const M: usize> Chain<T, M> {
    /// At the first sample nothing is known to move.
    fn at_rest(y: T) -> Self {
        let mut z = [T::zero(); M];
        if let [value, ..] = z.as_mut_slice() {
            *value = y;
        }
        Self(z)
    }

    /// The estimates at a sample y, from those at the sample before, if there was one: predicted, and corrected by the `correction` that a law
    /// makes of y less the prediction.
    ///
    /// # Errors
    /// Those of [`validated`] and [`corrected`](Self::corrected).
    pub fn following(
        last: Option<Self>,
        y: T,
        known: T,
        dt: T,
        correction: impl FnOnce(T) -> [T; M],
    ) -> Result<Self, Error> {
        validated("y/dt^n", y, known, dt, Self::span(dt))?;
        let Some(last) = last else { return Ok(Self::at_rest(y)) };
        let predicted = last.predicted(known, dt);
        let surprise = y - predicted.0[0];
        predicted.corrected(correction(surprise), dt)
    }

    /// What a difference in y is divided by at most: dtⁿ for the last derivative, or dt if that is less.
    fn span(dt: T) -> T {
        dt.powi(M as i32 - 1).min(dt)
    }

    /// What the estimates become over `dt` if the last derivative stays as it is: zᵢ ← Σ_j zᵢ₊ⱼ·dtʲ/j!, and z₀ moves by `known` besides.
    fn predicted(self, known: T, dt: T) -> Self {
        let Self(mut z) = self;
        for i in 0..M {
            // Horner's scheme, from the last derivative down.
            let mut tail = T::zero();
            for j in (i + 1..M).rev() {
                tail = (tail + z[j]) * dt / constant((j - i) as f64);
            }
            z[i] += tail;
        }
        if let [value, ..] = z.as_mut_slice() {
            *value += known;
        }
        Self(z)
    }

    /// Adds a polynomial that is given by its backward differences ∇ᵐ at this sample, at a spacing of `dt`.
    ///
    /// Its derivatives D follow from dt·D = −ln(1 − ∇) = ∇ + ∇²/2 + ∇³/3 + …
    fn corrected(self, differences: [T; M], dt: T) -> Result<Self, Error> {
        let (Self(mut z), mut d) = (self, differences);
        match d.as_mut_slice() {
            [_, first, second] => *first += *second * constant(0.5),
            [_, first, second, third] => {
                *first += *second * constant(0.5) + *third * constant(1.0 / 3.0);
                *second += *third;
            }
            // With one difference there is nothing to convert, and more than three nobody has.
            _ => {}
        }
        let mut power = T::one();
        for (z, d) in z.iter_mut().zip(d) {
            *z += d / power;
            power *= dt;
        }
        finite_slice("estimate of y and its derivatives", &z)?;
        Ok(Self(z))
    }
}

#[cfg(feature = "serde")]
impl<T: Scalar, const M: usize> Chain<T, M> {
    /// Estimates as they were saved.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn known(z: [T; M]) -> Result<Self, Error> {
        finite_slice("estimate of y and its derivatives", &z).map(|()| Self(z))
    }
}
