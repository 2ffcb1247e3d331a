use crate::{
    Error, Scalar,
    controller::Reference,
    elementary::hypot,
    error::{finite, value},
    scalar::constant,
};

/// Which way a robot faces while it follows a reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// Along the velocity: v > 0 (k = 0 in eq_ref_ha).
    Forward,
    /// Against it: v < 0 (k = 1 in eq_ref_ha).
    Reverse,
}

impl Direction {
    /// +1 or −1.
    pub fn sign<T: Scalar>(self) -> T {
        match self {
            Direction::Forward => T::one(),
            Direction::Reverse => -T::one(),
        }
    }
}

/// The speed v_d = ±√(ṙ_x² + ṙ_y²) in m/s that follows a planar reference, negative in reverse.
pub fn feedforward_speed<T: Scalar>([x, y]: &[Reference<T, 2>; 2], direction: Direction) -> T {
    direction.sign::<T>() * hypot(x.r[1], y.r[1])
}

/// The yaw rate ω_d = (r̈_y·ṙ_x − r̈_x·ṙ_y)/(ṙ_x² + ṙ_y²) in rad/s that follows a planar reference, > 0 to the left; the same forward and in
/// reverse.
///
/// # Errors
/// [`Error::Singular`] where the reference stands still, [`Error::NonFinite`] for a reference that is not finite.
pub fn feedforward_yaw_rate<T: Scalar>([x, y]: &[Reference<T, 2>; 2]) -> Result<T, Error> {
    let speed = moving(x.r[1], y.r[1])?;
    // One factor of the speed at a time: its square may underflow where the quotient does not.
    finite("omega_d", (y.r_n_dot * (x.r[1] / speed) - x.r_n_dot * (y.r[1] / speed)) / speed)
}

/// The heading θ_r = atan2(ṙ_y, ṙ_x) + k·π in \[−π, 2π\] that follows a planar reference, k = 0 forward and 1 in reverse (eq_ref_ha). See
/// [`Heading`] for one without jumps.
///
/// # Errors
/// [`Error::Singular`] where the reference stands still, [`Error::NonFinite`] for a reference that is not finite.
pub fn heading<T: Scalar>([x, y]: &[Reference<T, 2>; 2], direction: Direction) -> Result<T, Error> {
    moving(x.r[1], y.r[1])?;
    let turned = match direction {
        Direction::Forward => T::zero(),
        Direction::Reverse => T::pi(),
    };
    Ok(y.r[1].atan2(x.r[1]) + turned)
}

fn moving<T: Scalar>(x: T, y: T) -> Result<T, Error> {
    let speed = finite("reference speed", hypot(x, y))?;
    if speed > T::zero() {
        Ok(speed)
    } else {
        Err(Error::Singular { name: "reference speed", value: value(speed) })
    }
}

/// The heading θ_r of a planar reference, unwrapped: it goes on past ±π instead of jumping by 2π.
///
/// Call it once a sample; the heading must turn by less than π between two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heading<T> {
    direction: Direction,
    last: Option<T>,
}

impl<T: Scalar> Heading<T> {
    /// A heading that has seen no sample yet. Its first value is that of [`heading`].
    pub const fn new(direction: Direction) -> Self {
        Self { direction, last: None }
    }

    /// A heading that goes on from `last`, so that its first value is within π of it: from a robot's own heading, say.
    ///
    /// # Errors
    /// [`Error::NonFinite`].
    pub fn from(direction: Direction, last: T) -> Result<Self, Error> {
        Ok(Self { direction, last: Some(finite("heading", last)?) })
    }

    /// θ_r for the next sample.
    ///
    /// # Errors
    /// As [`heading`]; nothing is changed then.
    pub fn update(&mut self, reference: &[Reference<T, 2>; 2]) -> Result<T, Error> {
        let wrapped = heading(reference, self.direction)?;
        let turn = T::two_pi();
        let unwrapped = match self.last {
            None => wrapped,
            Some(last) => wrapped + turn * ((last - wrapped) / turn + constant(0.5)).floor(),
        };
        self.last = Some(unwrapped);
        Ok(unwrapped)
    }
}

checked! {
    [T: Scalar] Heading<T>, [T] { direction: Direction, last: Option<T> } =>
    last.map_or(Ok(Self::new(direction)), |last| Self::from(direction, last))
}
