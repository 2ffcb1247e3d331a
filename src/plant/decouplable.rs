use nalgebra::{SMatrix, SVector};

use crate::{Error, Scalar, error::finite_vector};

/// A plant with M inputs whose M outputs are the heads of M chains of N integrators:
/// zᵢ⁽ᴺ⁾ = aᵢ(x) + Σⱼ Bᵢⱼ(x)·uⱼ, in short z⁽ᴺ⁾ = a(x) + B(x)·u.
///
/// The input u = B(x)⁻¹·(−a(x) + ν) turns it into M separate chains zᵢ⁽ᴺ⁾ = νᵢ, wherever the decoupling matrix B is regular. It is the
/// [`FeedbackLinearizable`](super::FeedbackLinearizable) of several inputs, for chains of one length. A chain of an order R < N fills the
/// last R entries of its vector, behind zeros; [`Padded`](crate::controller::Padded) gives it a controller of its own order.
///
/// # References
/// A. Isidori, *Nonlinear Control Systems*, 5.2 and 5.3.
pub trait Decouplable<const NX: usize, const N: usize, const M: usize> {
    /// The number type of states and inputs.
    type Scalar: Scalar;

    /// The chains (zᵢ, żᵢ, …, zᵢ⁽ᴺ⁻¹⁾) at the state `x`, one for each output.
    fn chains(&self, x: &SVector<Self::Scalar, NX>) -> [SVector<Self::Scalar, N>; M];

    /// The drift a(x): z⁽ᴺ⁾ without input.
    fn chain_drift(&self, x: &SVector<Self::Scalar, NX>) -> SVector<Self::Scalar, M>;

    /// The decoupling matrix B(x): column j is ∂z⁽ᴺ⁾/∂uⱼ.
    fn decoupling_matrix(&self, x: &SVector<Self::Scalar, NX>) -> SMatrix<Self::Scalar, M, M>;

    /// The matrix that a controller inverts: B(x), or a regular stand-in for it where B(x) is singular.
    fn inverted_matrix(&self, x: &SVector<Self::Scalar, NX>) -> SMatrix<Self::Scalar, M, M> {
        self.decoupling_matrix(x)
    }

    /// z⁽ᴺ⁾ from a measured ẋ: for controllers that can use a sensor for it.
    fn chain_rates(
        &self,
        x: &SVector<Self::Scalar, NX>,
        x_dot: &SVector<Self::Scalar, NX>,
    ) -> SVector<Self::Scalar, M>;

    /// All that a controller needs at the state `x`, for a plant that computes it at once or has more to check.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] for a(x), and what the plant finds wrong with the state.
    fn linearization(
        &self,
        x: &SVector<Self::Scalar, NX>,
    ) -> Result<Linearization<Self::Scalar, N, M>, Error> {
        let drift = self.chain_drift(x);
        finite_vector("a(x)", &drift)?;
        Ok(Linearization {
            chains: self.chains(x),
            drift,
            matrix: self.decoupling_matrix(x),
            inverted: self.inverted_matrix(x),
        })
    }
}

impl<P: Decouplable<NX, N, M> + ?Sized, const NX: usize, const N: usize, const M: usize>
    Decouplable<NX, N, M> for &P
{
    type Scalar = P::Scalar;

    fn chains(&self, x: &SVector<P::Scalar, NX>) -> [SVector<P::Scalar, N>; M] {
        (**self).chains(x)
    }

    fn chain_drift(&self, x: &SVector<P::Scalar, NX>) -> SVector<P::Scalar, M> {
        (**self).chain_drift(x)
    }

    fn decoupling_matrix(&self, x: &SVector<P::Scalar, NX>) -> SMatrix<P::Scalar, M, M> {
        (**self).decoupling_matrix(x)
    }

    fn inverted_matrix(&self, x: &SVector<P::Scalar, NX>) -> SMatrix<P::Scalar, M, M> {
        (**self).inverted_matrix(x)
    }

    fn chain_rates(
        &self,
        x: &SVector<P::Scalar, NX>,
        x_dot: &SVector<P::Scalar, NX>,
    ) -> SVector<P::Scalar, M> {
        (**self).chain_rates(x, x_dot)
    }

    fn linearization(
        &self,
        x: &SVector<P::Scalar, NX>,
    ) -> Result<Linearization<P::Scalar, N, M>, Error> {
        (**self).linearization(x)
    }
}

/// A [`Decouplable`] plant at one state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linearization<T, const N: usize, const M: usize> {
    /// The chains (zᵢ, żᵢ, …, zᵢ⁽ᴺ⁻¹⁾).
    pub chains: [SVector<T, N>; M],
    /// The drift a(x).
    pub drift: SVector<T, M>,
    /// The decoupling matrix B(x).
    pub matrix: SMatrix<T, M, M>,
    /// The matrix to invert: B(x), or its stand-in.
    pub inverted: SMatrix<T, M, M>,
}

checked! {
    [T: Scalar, const N: usize, const M: usize] Linearization<T, N, M>, [T]
    {
        chains: Array<SVector<T, N>, M> = Array(*chains),
        drift: SVector<T, M>,
        matrix: SMatrix<T, M, M>,
        inverted: SMatrix<T, M, M>,
    } =>
    known("chains", chains.0.iter().flatten().copied()).and_then(|()| {
        known("a(x)", drift.iter().copied())?;
        known("B(x)", matrix.iter().chain(inverted.iter()).copied())?;
        Ok(Self { chains: chains.0, drift, matrix, inverted })
    })
}
