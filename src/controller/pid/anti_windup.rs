use crate::{Error, Scalar, error::not_negative};

/// What happens to the integral of a [`Pid`](super::Pid) while something else arrives at the plant than it asked for.
///
/// What arrived comes with the measurement, as `applied`: from [`Limited`](crate::controller::Limited) or from the actuators themselves. Without a
/// report, what was asked for is taken to have arrived.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub enum AntiWindup<T> {
    /// The integral goes on: it winds up behind a limit.
    None,
    /// The integral follows what arrived: İ = k_i·e + (u_applied − u)/T_t, sampled implicitly, I ← I + h/(T_t + h)·(u_applied − u), which is
    /// stable for every h.
    ///
    /// Behind a limit u stays at k_i·e·(T_t + h) beyond it. Usual are T_t = T_i without and T_t = √(T_i·T_d) with derivative action; T_t = 0 is
    /// the velocity form, in which each output starts from what arrived.
    BackCalculation {
        /// T_t ≥ 0 in seconds.
        tracking_time: T,
    },
    /// The integral stands still where more than the tolerance of u is missing and k_i·e would ask for still more.
    Conditional {
        /// What may be missing without being a limit, ≥ 0 in units of u: the step of a converter, for one.
        tolerance: T,
    },
}

impl<T: Scalar> AntiWindup<T> {
    pub(super) fn validated(self) -> Result<Self, Error> {
        match self {
            Self::None => {}
            Self::BackCalculation { tracking_time } => {
                not_negative("tracking time", tracking_time)?;
            }
            Self::Conditional { tolerance } => {
                not_negative("tolerance", tolerance)?;
            }
        }
        Ok(self)
    }

    /// I after a period `dt` that adds `step`, in which `excess` = u − u_applied did not arrive.
    pub(super) fn integral(&self, i: T, step: T, excess: T, dt: T) -> T {
        match *self {
            Self::None => i + step,
            Self::BackCalculation { tracking_time } => {
                i + step - excess * (dt / (tracking_time + dt))
            }
            Self::Conditional { tolerance } => {
                let pushing = excess.is_sign_positive() == step.is_sign_positive();
                if excess.abs() > tolerance && pushing { i } else { i + step }
            }
        }
    }
}
