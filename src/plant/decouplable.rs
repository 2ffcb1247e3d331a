use nalgebra::{SMatrix, SVector};

use crate::Scalar;

/// A plant with M inputs whose M outputs are the heads of M chains of N integrators:
/// zᵢ⁽ᴺ⁾ = aᵢ(x) + Σⱼ Bᵢⱼ(x)·uⱼ, in short z⁽ᴺ⁾ = a(x) + B(x)·u.
///
/// The input u = B(x)⁻¹·(−a(x) + ν) turns it into M separate chains zᵢ⁽ᴺ⁾ = νᵢ, wherever the decoupling matrix B is regular. It is the
/// [`FeedbackLinearizable`](super::FeedbackLinearizable) of several inputs, for chains of one length.
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
}
