use nalgebra::SVector;

use crate::{
    Error, Scalar,
    controller::Gains,
    error::{finite_vector, positive},
    scalar::constant,
};

/// A sliding surface σ = e_n + c_{n−1}·e_{n−1} + … + c₁·e₁ = 0 on which the error decays by itself.
///
/// On it e₁ obeys the polynomial pᴺ⁻¹ + c_{N−1}·pᴺ⁻² + … + c₁, one order less than the plant's, which every constructor makes Hurwitz. σ has the
/// units of x_n, c_i those of s^−(N−i). For N = 1 the surface is e₁ = 0.
///
/// Where |σ| ≤ φ remains and all poles are real, |e₁| ≤ φ/c₁ in the end: the impulse response of 1/Π(p − pᵢ) is then positive, so its
/// steady-state gain bounds e₁ for every such σ.
///
/// ```
/// use brunovsky::{controller::sliding_mode::SlidingSurface, prelude::*};
///
/// // (p + 3)² in two ways, for a plant of order 3.
/// let surface = SlidingSurface::<f64, 3>::from_lambda(3.0)?;
/// assert_eq!(surface, SlidingSurface::new(Gains::from_poles([-3.0, -3.0])?));
/// assert_eq!(surface.value(&SVector::from([1.0, 0.0, 0.0])), 9.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingSurface<T, const N: usize> {
    c: SVector<T, N>,
}

impl<T: Scalar, const N: usize> SlidingSurface<T, N> {
    /// The surface with (c₁, …, c_{N−1}) as Hurwitz as `gains` are; M = N − 1.
    pub fn new<const M: usize>(gains: Gains<T, M>) -> Self {
        const { assert!(M + 1 == N, "a surface has one coefficient less than the plant's order") };
        let gains = gains.as_vector();
        Self { c: SVector::from_fn(|i, _| gains.get(i).copied().unwrap_or(T::one())) }
    }

    /// All poles at −λ: (p + λ)ᴺ⁻¹, so c_i = C(N−1, i−1)·λ^(N−i). λ > 0 in 1/s; for N = 1 it has nothing to decide.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `lambda`; [`Error::NonFiniteEntry`] or [`Error::NotPositive`] if its powers leave the
    /// range of `T`.
    pub fn from_lambda(lambda: T) -> Result<Self, Error> {
        const { assert!(N > 0, "a chain has at least one integrator") };
        positive("lambda", lambda)?;
        let mut c = SVector::<T, N>::zeros();
        let mut next = T::one();
        for (j, c) in c.iter_mut().rev().enumerate() {
            // c_N = 1 first, then C(N−1, 1)·λ, C(N−1, 2)·λ², …
            *c = next;
            next *= lambda * constant((N - 1 - j) as f64) / constant((j + 1) as f64);
        }
        finite_vector("surface", &c)?;
        positive("c1", c[0])?;
        Ok(Self { c })
    }

    /// The coefficients (c₁, …, c_{N−1}, 1).
    pub fn as_vector(&self) -> &SVector<T, N> {
        &self.c
    }

    /// The sliding variable σ of the error e.
    pub fn value(&self, e: &SVector<T, N>) -> T {
        self.c.dot(e)
    }

    /// Σ c_i·e_{i+1}, the part of σ̇ that is known without the plant: the feedback u_b under which σ stands still.
    pub fn feedback(&self, e: &SVector<T, N>) -> T {
        let pairs = self.c.iter().zip(e.iter().skip(1));
        pairs.fold(T::zero(), |sum, (c, e)| sum + *c * *e)
    }
}

checked! {
    [T: Scalar, const N: usize] SlidingSurface<T, N>, [T] { c: SVector<T, N> } =>
    finite_vector("surface", &c).and_then(|()| {
        let mut descending = c;
        descending.as_mut_slice().reverse();
        let parts = descending.as_mut_slice().split_first_mut();
        let (last, gains) = parts.ok_or(Error::Missing { name: "surface" })?;
        at_most("distance of c_N from 1", (*last - T::one()).abs(), T::zero())?;
        crate::controller::gains::routh(gains)?;
        Ok(Self { c })
    })
}
