use super::ErrorRate;
use crate::{Error, differentiator::Differentiator, error::finite, learning::ClosedLoop};

/// Any [`Differentiator`] is a source of ė_n: it differentiates e_n.
impl<D: Differentiator, const N: usize> ErrorRate<D::Scalar, N> for D {
    fn error_rate(
        &mut self,
        at: &ClosedLoop<D::Scalar, N>,
        _u_n: D::Scalar,
        dt: D::Scalar,
    ) -> Result<D::Scalar, Error> {
        self.update(finite("e_n", at.e[N - 1])?, dt)
    }
}
