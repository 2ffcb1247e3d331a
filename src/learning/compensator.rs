use super::{ClosedLoop, ErrorRate};
use crate::{
    Error, Scalar,
    error::{finite, positive},
};

/// What a compensator adds to the loop at one sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compensation<T> {
    /// The learned term u_n, in the units of ẋ_n.
    pub u_n: T,
    /// The sliding variable s = ė_n + u_b that it was learned from (eq_ss2).
    pub s: T,
}

/// A learner in parallel with the feedback of a loop of order N.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a compensator for a loop of order {N}",
    label = "not a compensator for this loop",
    note = "a `NeuroFuzzy` compensates a loop of the order that its network has inputs"
)]
pub trait Compensator<T, const N: usize>: Clone {
    /// Learns from a sample, and what it adds to the loop, if `accept` has nothing against it. `dt > 0` is the time since the sample before.
    ///
    /// An implementation computes first, asks `accept` once when nothing else can fail, and changes itself last: the loop may still fail in the
    /// same sample.
    ///
    /// # Errors
    /// [`Error::Missing`] if ė_n cannot be had; [`Error::NotPositive`] for `dt`; [`Error::NonFinite`] and
    /// [`Error::NonFiniteEntry`] for e, s or u_n outside the range of `T`; and that of `accept`. The compensator is then as before.
    fn advance_if(
        &mut self,
        at: &ClosedLoop<T, N>,
        dt: T,
        accept: &mut dyn FnMut(&Compensation<T>) -> Result<(), Error>,
    ) -> Result<Compensation<T>, Error>;

    /// The compensator after a sample, and what it adds to the loop; itself it stays as it is.
    ///
    /// # Errors
    /// Those of [`advance_if`](Self::advance_if).
    fn advanced(&self, at: &ClosedLoop<T, N>, dt: T) -> Result<(Self, Compensation<T>), Error> {
        let mut next = self.clone();
        let compensation = next.advance_if(at, dt, &mut |_| Ok(()))?;
        Ok((next, compensation))
    }
}

/// The compensator that watches s and adds nothing: CLELC with it is feedback linearization control, bit for bit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct NullCompensator<E> {
    error_rate: E,
}

impl<E> NullCompensator<E> {
    /// A compensator that watches s with ė_n from `error_rate`.
    pub const fn new(error_rate: E) -> Self {
        Self { error_rate }
    }
}

impl<T: Scalar, E: ErrorRate<T, N> + Clone, const N: usize> Compensator<T, N>
    for NullCompensator<E>
{
    fn advance_if(
        &mut self,
        at: &ClosedLoop<T, N>,
        dt: T,
        accept: &mut dyn FnMut(&Compensation<T>) -> Result<(), Error>,
    ) -> Result<Compensation<T>, Error> {
        positive("dt", dt)?;
        // −0 is the number that changes no sum: x + (−0) = x even for x = −0.
        let u_n = -T::zero();
        let mut error_rate = self.error_rate.clone();
        let s = finite("s", error_rate.error_rate(at, u_n, dt)? + at.u_b)?;
        let compensation = Compensation { u_n, s };
        accept(&compensation)?;
        self.error_rate = error_rate;
        Ok(compensation)
    }
}
