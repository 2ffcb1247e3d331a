use nalgebra::{Complex, SVector};
use num_traits::One;

use crate::{
    Error, Scalar,
    error::{below, finite, finite_vector, positive, value},
    scalar::constant,
};

/// Feedback gains k = (k₁, …, k_n) for which ė_n + k_n·e_n + … + k₁·e₁ = 0 is asymptotically stable.
///
/// Positive gains are enough for N ≤ 2 and not beyond: every constructor checks the Routh array of
/// pᴺ + k_N·pᴺ⁻¹ + … + k₁. k_i has the unit s^−(N+1−i).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains<T, const N: usize> {
    k: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Gains<T, N> {
    /// The gains (k₁, …, k_n), in the order of the errors they multiply.
    ///
    /// # Errors
    /// [`Error::NotHurwitz`], or [`Error::NonFiniteEntry`].
    pub fn new(k: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        const { assert!(N > 0, "a chain has at least one integrator") };
        let k = k.into();
        finite_vector("gains", &k)?;
        let mut descending = k;
        descending.as_mut_slice().reverse();
        routh(descending.as_mut_slice())?;
        Ok(Self { k })
    }

    /// All poles at −λ: (p + λ)ᴺ, so k_i = C(N, i−1)·λ^(N+1−i) (eq_ks). λ > 0 in 1/s.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `lambda`; [`Error::NonFiniteEntry`] or [`Error::NotHurwitz`] if its
    /// powers leave the range of `T`.
    pub fn from_lambda(lambda: T) -> Result<Self, Error> {
        positive("lambda", lambda)?;
        let mut k = SVector::<T, N>::zeros();
        let mut binomial = T::one();
        let mut power = lambda;
        for (j, k) in k.iter_mut().rev().enumerate() {
            // k_n first: C(N, 1)·λ, then C(N, 2)·λ², …
            binomial *= constant::<T>((N - j) as f64) / constant((j + 1) as f64);
            *k = binomial * power;
            power *= lambda;
        }
        Self::new(k)
    }

    /// The gains that place the poles of the error dynamics, given as reals or as complex numbers in conjugate pairs.
    ///
    /// # Errors
    /// [`Error::NonFinite`]; [`Error::NotBelow`] for a pole whose real part is not negative; [`Error::Unpaired`] for a complex
    /// pole without its conjugate; [`Error::NonFiniteEntry`] or [`Error::NotHurwitz`] if products of poles leave the range of `T`.
    pub fn from_poles<P: Into<Complex<T>> + Copy>(poles: [P; N]) -> Result<Self, Error> {
        let poles = poles.map(Into::into);
        // Coefficients of Π(p − pole) below the leading 1, one factor at a time: c_j becomes c_j − pole·c_{j−1}, c₀ = 1. They are k_n, …,
        // k₁, so k is gone through from its end.
        let mut k = SVector::<Complex<T>, N>::zeros();
        for pole in &poles {
            checked(pole)?;
            paired(pole, &poles)?;
            let mut before = Complex::one();
            for c in k.iter_mut().rev() {
                before = core::mem::replace(c, *c - *pole * before);
            }
        }
        Self::new(k.map(|k| k.re))
    }

    /// The gains (k₁, …, k_n).
    pub fn as_vector(&self) -> &SVector<T, N> {
        &self.k
    }

    /// The feedback u_b = k·e (eq_fb).
    pub fn feedback(&self, e: &SVector<T, N>) -> T {
        self.k.dot(e)
    }
}

fn checked<T: Scalar>(pole: &Complex<T>) -> Result<(), Error> {
    finite("pole", pole.re)?;
    finite("pole", pole.im)?;
    below("real part of pole", pole.re, T::zero())?;
    Ok(())
}

/// A real polynomial has each complex root as often as its conjugate.
fn paired<T: Scalar>(pole: &Complex<T>, poles: &[Complex<T>]) -> Result<(), Error> {
    let times = |wanted: Complex<T>| poles.iter().filter(|other| **other == wanted).count();
    if times(*pole) == times(pole.conj()) {
        Ok(())
    } else {
        Err(Error::Unpaired { name: "imaginary part of pole", value: value(pole.im) })
    }
}

/// Routh's criterion: the first column of the array of pᴺ + k_N·pᴺ⁻¹ + … + k₁ is positive.
///
/// Eliminating the leading coefficient with the row below it leaves a polynomial of one degree less with the same property, so
/// one row is enough memory: `lead` and the entries after it.
///
/// `rest` holds k_N, …, k₁, and is overwritten.
pub(super) fn routh<T: Scalar>(mut rest: &mut [T]) -> Result<(), Error> {
    let mut lead = T::one();
    let mut row = 0;
    while let Some((next, lower)) = rest.split_first_mut() {
        row += 1;
        if !(*next > T::zero() && next.is_finite()) {
            return Err(Error::NotHurwitz { name: "gains", row, value: value(*next) });
        }
        let ratio = lead / *next;
        lead = *next;
        // lower holds (a₂, a₃, a₄, …); a₂ −= ratio·a₃, a₄ −= ratio·a₅, …
        for pair in lower.chunks_exact_mut(2) {
            if let [even, odd] = pair {
                *even -= ratio * *odd;
            }
        }
        rest = lower;
    }
    Ok(())
}

checked! { [T: Scalar, const N: usize] Gains<T, N>, [T] { k: SVector<T, N> } => Self::new(k) }
