use super::ErrorRate;
use crate::{Error, Scalar, learning::ClosedLoop};

/// Two sources of ė_n, the second for the samples at which the first lacks its measurement: [`Measured`](super::Measured) with
/// [`ModelAided`](super::ModelAided) behind it bears a sensor that drops out.
///
/// A sensor that lies is not noticed here; see [`Guarded`](crate::learning::Guarded).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Redundant<A, B> {
    first: A,
    second: B,
}

impl<A, B> Redundant<A, B> {
    /// `first` where it can be had, `second` elsewhere.
    pub const fn new(first: A, second: B) -> Self {
        Self { first, second }
    }
}

impl<T: Scalar, A: ErrorRate<T, N>, B: ErrorRate<T, N>, const N: usize> ErrorRate<T, N>
    for Redundant<A, B>
{
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error> {
        // Both see every sample, so that the second has its memory when it is needed.
        let second = self.second.error_rate(at, u_n, dt);
        match self.first.error_rate(at, u_n, dt) {
            Err(Error::Missing { .. }) => second,
            first => first,
        }
    }
}
