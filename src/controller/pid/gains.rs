use crate::{
    Error, Scalar,
    error::{finite, not_negative, positive},
};

/// The gains of a [`Pid`](super::Pid): K, k_i = K/T_i, k_d = K·T_d, the filter time T_f and the set-point weights b and c.
///
/// K is positive for a plant whose y grows with u, and negative for one whose y falls. With b = 1 and c = 0 the derivative acts on y alone, so
/// that a step of r is not differentiated; b < 1 takes overshoot of the response to r without a change of that to disturbances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PidGains<T> {
    pub(super) k: T,
    pub(super) k_i: T,
    pub(super) k_d: T,
    pub(super) t_f: T,
    pub(super) b: T,
    pub(super) c: T,
}

impl<T: Scalar> PidGains<T> {
    /// Proportional feedback, with the gain K in units of u per unit of y.
    ///
    /// # Errors
    /// [`Error::NonFinite`].
    pub fn new(k: T) -> Result<Self, Error> {
        let zero = T::zero();
        Ok(Self { k: finite("K", k)?, k_i: zero, k_d: zero, t_f: T::one(), b: T::one(), c: zero })
    }

    /// The parallel form: K, k_i and k_d of either sign, and the filter time T_f > 0 in seconds.
    ///
    /// # Errors
    /// [`Error::NonFinite`], or [`Error::NotPositive`] for `t_f`.
    pub fn parallel(k: T, k_i: T, k_d: T, t_f: T) -> Result<Self, Error> {
        let (k_i, k_d) = (finite("k_i", k_i)?, finite("k_d", k_d)?);
        Ok(Self { k_i, k_d, t_f: positive("T_f", t_f)?, ..Self::new(k)? })
    }

    /// The same with integral action, k_i = K/T_i with T_i > 0 in seconds.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_integral_time(self, t_i: T) -> Result<Self, Error> {
        Ok(Self { k_i: finite("K/T_i", self.k / positive("T_i", t_i)?)?, ..self })
    }

    /// The same with derivative action, k_d = K·T_d with T_d ≥ 0 in seconds, behind a filter with the time constant T_f > 0: T_d/8 to T_d/2 as a
    /// rule.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_derivative_time(self, t_d: T, t_f: T) -> Result<Self, Error> {
        let k_d = finite("K*T_d", self.k * not_negative("T_d", t_d)?)?;
        Ok(Self { k_d, t_f: positive("T_f", t_f)?, ..self })
    }

    /// The same with other set-point weights: b of the proportional and c of the derivative share.
    ///
    /// # Errors
    /// [`Error::NonFinite`].
    pub fn with_weights(self, b: T, c: T) -> Result<Self, Error> {
        Ok(Self { b: finite("b", b)?, c: finite("c", c)?, ..self })
    }

    /// K·(b·r − y).
    pub(super) fn proportional(&self, r: T, y: T) -> T {
        self.k * (self.b * r - y)
    }

    /// w = c·r − y, what the derivative is taken of.
    pub(super) fn differentiated(&self, r: T, y: T) -> T {
        self.c * r - y
    }
}

checked! {
    [T: Scalar] PidGains<T>, [T] { k: T, k_i: T, k_d: T, t_f: T, b: T, c: T } =>
    Self::parallel(k, k_i, k_d, t_f).and_then(|gains| gains.with_weights(b, c))
}
