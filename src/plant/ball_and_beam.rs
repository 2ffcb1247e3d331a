use super::{SmoothPlant, smooth::control_affine};
use crate::{Error, Scalar, differentiation::Smooth, error::not_negative};

/// A ball that rolls on a turning beam: r̈ = B·(r·θ̇² − g·sin θ), θ̈ = u, with B = 1/(1 + J/(m·ρ²)) for a ball of moment of inertia J and radius ρ.
///
/// State (r, ṙ, θ, θ̇) in m, m/s, rad and rad/s, with r the position of the ball from the pivot and θ counter-clockwise from horizontal, so
/// that the ball rolls towards smaller r for θ > 0; input u in rad/s², the beam's acceleration (its torque, after a regular change of
/// input); output r.
///
/// It is the standard example of a plant without a relative degree: the input acts on r⃛ by 2·B·r·θ̇, which vanishes with the ball at the pivot
/// and with the beam at rest, at every equilibrium that is. Off r·θ̇ = 0 the relative degree is 3, and one order of zero dynamics is
/// left. [`SmoothPlant::linearized`] refuses the equilibria.
///
/// ```
/// use brunovsky::{Error, plant::{BallAndBeam, SmoothPlant}};
///
/// let plant = BallAndBeam::new(0.4, 9.81)?;
/// let at_rest = plant.relative_degree([0.3, 0.0, 0.0, 0.0]);
/// assert!(matches!(at_rest, Err(Error::UndefinedRelativeDegree { order: 2, .. })));
/// assert_eq!(plant.relative_degree([0.3, 0.0, 0.0, 0.5])?.degrees, [3]);
/// # Ok::<(), Error>(())
/// ```
///
/// # References
/// J. Hauser, S. Sastry, P. Kokotović, "Nonlinear control via approximate input-output linearization: the ball and beam example", IEEE
/// Transactions on Automatic Control 37(3), 1992.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallAndBeam<T> {
    share: T,
    gravity: T,
}

impl<T: Scalar> BallAndBeam<T> {
    /// A ball with the ratio J/(m·ρ²) = `inertia_ratio` ≥ 0 (2/5 if solid, 2/3 if hollow, 0 if it slides), under `gravity` g ≥ 0 in m/s².
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(inertia_ratio: T, gravity: T) -> Result<Self, Error> {
        Ok(Self {
            share: (not_negative("inertia ratio", inertia_ratio)? + T::one()).recip(),
            gravity: not_negative("gravity", gravity)?,
        })
    }
}

impl<T: Scalar> SmoothPlant<4, 1> for BallAndBeam<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [r, r_dot, theta, theta_dot]: [S; 4]) -> [S; 4] {
        let force = r * theta_dot * theta_dot - theta.sin() * self.gravity;
        [r_dot, force * self.share, theta_dot, S::zero()]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _x: [S; 4]) -> [[S; 4]; 1] {
        [[S::zero(), S::zero(), S::zero(), S::one()]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [r, ..]: [S; 4]) -> [S; 1] {
        [r]
    }
}

control_affine!(BallAndBeam, 4, 1);

checked! {
    [T: Scalar] BallAndBeam<T>, [T] { share: T, gravity: T } =>
    positive("share", share).and_then(|_| {
        not_negative("1 - share", T::one() - share)?;
        Ok(Self { share, gravity: not_negative("gravity", gravity)? })
    })
}
