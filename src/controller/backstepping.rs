use nalgebra::SVector;

#[cfg(doc)]
use super::FeedbackLinearization;
use super::{
    Accept, Command, Controller, Gains, Measurement, Reference,
    feedback_linearization::{closed_loop, linearizing},
};
use crate::{
    Error, Scalar,
    error::{finite_vector, positive},
    learning::LearningMode,
    plant::FeedbackLinearizable,
    scalar::constant,
};

/// Backstepping on a chain: u = b(x)⁻¹·(−a(x) + u_f + u_b), u_b from z₁ = e₁ and zᵢ₊₁ = żᵢ + cᵢ·zᵢ + zᵢ₋₁, so that ż_n = −c_n·z_n − z_{n−1}.
///
/// Each zᵢ is what the virtual input of step i − 1 lacks. If the plant is the model, the loop is
///
/// ```text
/// żᵢ = −cᵢ·zᵢ − zᵢ₋₁ + zᵢ₊₁   (z₀ = zₙ₊₁ = 0),   V = ½·Σ zᵢ²,   V̇ = −Σ cᵢ·zᵢ²
/// ```
///
/// so with c = min cᵢ the norm of z falls by e^(−c·t) at least, without an overshoot of V; an uncertainty Δ adds −z_n·Δ to V̇ and leaves
/// |z| ≤ |Δ|/c in the end. On a chain all of this is linear: u_b = k·e is that of [`FeedbackLinearization`] with
/// [`Gains::from_backstepping`], and the command shows z and V besides. For N = 2, k = (1 + c₁·c₂, c₁ + c₂). The polynomial of k is that of a
/// Schwarz matrix, so every cᵢ > 0 is stable, and every stable polynomial is that of some c.
///
/// Assumes what feedback linearization assumes. Plants in strict-feedback form that are not chains have first to be
/// [linearized](crate::plant::Linearized).
///
/// # References
/// M. Krstić, I. Kanellakopoulos, P. Kokotović, *Nonlinear and Adaptive Control Design*, 1995, 2.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Backstepping<P: FeedbackLinearizable<N>, const N: usize> {
    model: P,
    gains: Gains<P::Scalar, N>,
    c: SVector<P::Scalar, N>,
}

/// An input of [`Backstepping`], its shares, and the error coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BacksteppingCommand<T, const N: usize> {
    /// The input u, in the plant's units.
    pub u: T,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// The feedback u_b = k·e, in the units of ẋ_n.
    pub u_b: T,
    /// The error coordinates z.
    pub z: SVector<T, N>,
}

impl<T: Scalar, const N: usize> BacksteppingCommand<T, N> {
    /// V = ½·Σ zᵢ².
    pub fn lyapunov(&self) -> T {
        self.z.norm_squared() * constant(0.5)
    }
}

impl<T: Scalar, const N: usize> Command<T, 1> for BacksteppingCommand<T, N> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

/// The coefficients of zᵢ = Σ_j mᵢⱼ·eⱼ for every i ≤ n, given to `row` one after the other, and k of −ż_n − c_n·z_n − z_{n−1} = k·e − ….
///
/// In terms of p = d/dt they are polynomials: zᵢ₊₁ = (p + cᵢ)·zᵢ + zᵢ₋₁.
fn polynomials<T: Scalar, const N: usize>(
    c: &SVector<T, N>,
    mut row: impl FnMut(usize, &SVector<T, N>),
) -> SVector<T, N> {
    let (mut before, mut z) = (SVector::<T, N>::zeros(), SVector::<T, N>::zeros());
    if let Some(first) = z.iter_mut().next() {
        *first = T::one();
    }
    for (i, c) in c.iter().enumerate() {
        row(i, &z);
        // The leading coefficient 1 of the last one, pᴺ, is beyond the vector.
        let next = SVector::from_fn(|j, _| {
            let shifted = j.checked_sub(1).map_or(T::zero(), |j| z[j]);
            shifted + *c * z[j] + before[j]
        });
        (before, z) = (z, next);
    }
    z
}

impl<T: Scalar, const N: usize> Gains<T, N> {
    /// The gains k for which e obeys the loop of [`Backstepping`] with `c` = (c₁, …, c_n), in 1/s.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for an entry of `c`; [`Error::NonFiniteEntry`] or [`Error::NotHurwitz`] if their products
    /// leave the range of `T`.
    pub fn from_backstepping(c: impl Into<SVector<T, N>>) -> Result<Self, Error> {
        let c = c.into();
        for c in c.iter() {
            positive("c", *c)?;
        }
        Self::new(polynomials(&c, |_, _| ()))
    }
}

impl<P: FeedbackLinearizable<N>, const N: usize> Backstepping<P, N> {
    /// A controller for the plant that `model` describes, with `c` = (c₁, …, c_n), all > 0, in 1/s.
    ///
    /// # Errors
    /// Those of [`Gains::from_backstepping`].
    pub fn new(model: P, c: impl Into<SVector<P::Scalar, N>>) -> Result<Self, Error> {
        let c = c.into();
        Ok(Self { model, gains: Gains::from_backstepping(c)?, c })
    }

    /// The gains k that it amounts to.
    pub fn gains(&self) -> &Gains<P::Scalar, N> {
        &self.gains
    }

    /// z of an error e.
    pub fn coordinates(&self, e: &SVector<P::Scalar, N>) -> SVector<P::Scalar, N> {
        let mut z = SVector::zeros();
        polynomials(&self.c, |i, row| z[i] = row.dot(e));
        z
    }
}

impl<P: FeedbackLinearizable<N>, const N: usize> Controller<N, 1> for Backstepping<P, N> {
    type Scalar = P::Scalar;
    type Reference = Reference<P::Scalar, N>;
    type Command = BacksteppingCommand<P::Scalar, N>;

    /// # Errors
    /// Those of [`FeedbackLinearization`], and [`Error::NonFiniteEntry`] for z.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let feedback = |e: &_| self.gains.feedback(e);
        let (last, off) = (nalgebra::zero(), LearningMode::Off);
        let at = closed_loop(&self.model, feedback, measurement, reference, dt, last, off)?;
        let z = self.coordinates(&at.e);
        finite_vector("z", &z)?;
        let u = linearizing(&at, at.u_f + at.u_b)?;
        let command = BacksteppingCommand { u, u_f: at.u_f, u_b: at.u_b, z };
        accept(&command)?;
        Ok(command)
    }

    fn reset(&mut self) {}
}

checked! {
    [P: FeedbackLinearizable<N>, const N: usize] Backstepping<P, N>, [P, P::Scalar]
    { model: P, c: SVector<P::Scalar, N>; gains } =>
    Self::new(model, c)
}
