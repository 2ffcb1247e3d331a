mod equations;

use nalgebra::{SMatrix, SVector};

use super::{ControlAffine, Decouplable};
use crate::{
    Error, Scalar,
    elementary::{cos, sin},
    error::{not_negative, positive},
    scalar::constant,
};

/// A planar arm with two revolute joints in a vertical plane: M(q)·q̈ + C(q, q̇)·q̇ + F·q̇ + G(q) = τ.
///
/// State x = (q₁, q₂, q̇₁, q̇₂) in rad and rad/s: q₁ is the angle of link 1 from the horizontal x axis, q₂ that of link 2 from link 1,
/// both counter-clockwise, so that the arm hangs down at q = (−π/2, 0). Input u = τ, the torques of the joints in N·m. A payload, a
/// point mass at the tip, counts as part of link 2.
///
/// M(q) is positive definite for all parameters that are accepted, so every torque has its accelerations and the joints are two
/// chains (qᵢ, q̇ᵢ) with the decoupling matrix M(q)⁻¹.
///
/// Assumes rigid links whose centres of mass lie on the line between their joints, and viscous friction.
///
/// # References
/// M. W. Spong, S. Hutchinson, M. Vidyasagar, *Robot Modeling and Control*, "Planar elbow manipulator" (equations of motion);
/// R. M. Murray, Z. Li, S. S. Sastry, *A Mathematical Introduction to Robotic Manipulation*, 4.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoLinkArm<T> {
    links: [Link<T>; 2],
    friction: [T; 2],
    gravity: T,
    payload: T,
}

/// A rigid link of [`TwoLinkArm`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Link<T> {
    /// The mass m > 0 in kg.
    pub mass: T,
    /// The length l > 0 in m, from its joint to the next joint or to the tip.
    pub length: T,
    /// The distance c ≥ 0 in m of the centre of mass from its joint; it may lie beyond the end.
    pub centre: T,
    /// The moment of inertia I ≥ 0 in kg·m² about the centre of mass; 0 for a point mass.
    pub inertia: T,
}

impl<T: Scalar> Link<T> {
    /// The moment of inertia I + m·c² about its joint, in kg·m².
    fn about_joint(&self) -> T {
        self.inertia + self.mass * self.centre * self.centre
    }

    /// The same link, checked; `names` are those of mass, length, centre, inertia and the moment of inertia about the joint.
    fn validated(self, names: [&'static str; 5]) -> Result<Self, Error> {
        let [mass, length, centre, inertia, about_joint] = names;
        positive(mass, self.mass)?;
        positive(length, self.length)?;
        not_negative(centre, self.centre)?;
        not_negative(inertia, self.inertia)?;
        positive(about_joint, self.about_joint())?;
        Ok(self)
    }
}

impl<T: Scalar> TwoLinkArm<T> {
    /// An arm of `links`, the first one at the base, with viscous `friction` F₁, F₂ ≥ 0 in the joints in N·m·s/rad, under `gravity`
    /// g ≥ 0 in m/s² (0 for an arm in a horizontal plane), without payload.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`], naming the parameter and its link or joint; also for a
    /// moment of inertia I + m·c² about the joint that is zero or beyond the range of `T`.
    pub fn new(links: [Link<T>; 2], friction: [T; 2], gravity: T) -> Result<Self, Error> {
        let [first, second] = links;
        Ok(Self {
            links: [
                first.validated([
                    "mass of link 1",
                    "length of link 1",
                    "centre of link 1",
                    "inertia of link 1",
                    "inertia of link 1 about its joint",
                ])?,
                second.validated([
                    "mass of link 2",
                    "length of link 2",
                    "centre of link 2",
                    "inertia of link 2",
                    "inertia of link 2 about its joint",
                ])?,
            ],
            friction: [
                not_negative("friction of joint 1", friction[0])?,
                not_negative("friction of joint 2", friction[1])?,
            ],
            gravity: not_negative("gravity", gravity)?,
            payload: T::zero(),
        })
    }

    /// The same arm with a point mass `payload` ≥ 0 in kg at its tip.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NonFinite`].
    pub fn with_payload(self, payload: T) -> Result<Self, Error> {
        Ok(Self { payload: not_negative("payload", payload)?, ..self })
    }

    /// The mass matrix M(q) in kg·m², symmetric and positive definite.
    pub fn mass_matrix(&self, q: &SVector<T, 2>) -> SMatrix<T, 2, 2> {
        let outer = self.outer_inertia();
        let coupling = self.coupling() * cos(q[1]);
        let inner = self.links[0].about_joint() + self.carried() * self.reach() * self.reach();
        let off_diagonal = outer + coupling;
        SMatrix::from([
            [inner + outer + coupling * constant(2.0), off_diagonal],
            [off_diagonal, outer],
        ])
    }

    /// The matrix C(q, q̇) of Coriolis and centrifugal torques C·q̇ in N·m, of Christoffel symbols: Ṁ − 2C is skew-symmetric.
    pub fn coriolis_matrix(&self, q: &SVector<T, 2>, q_dot: &SVector<T, 2>) -> SMatrix<T, 2, 2> {
        let h = -self.coupling() * sin(q[1]);
        SMatrix::from([[h * q_dot[1], -h * q_dot[0]], [h * (q_dot[0] + q_dot[1]), T::zero()]])
    }

    /// The torques G(q) in N·m that hold the arm against gravity.
    pub fn gravity_torque(&self, q: &SVector<T, 2>) -> SVector<T, 2> {
        let (first, second) = self.levers();
        let outer = self.gravity * second * cos(q[0] + q[1]);
        SVector::from([self.gravity * first * cos(q[0]) + outer, outer])
    }

    /// The mechanical energy ½·q̇ᵀ·M·q̇ + V(q) in J, V = 0 where both links are horizontal.
    ///
    /// It changes by the power of the joints: Ė = τᵀ·q̇ − q̇ᵀ·F·q̇.
    pub fn energy(&self, x: &SVector<T, 4>) -> T {
        let (q, q_dot) = halves(x);
        let (first, second) = self.levers();
        let potential = self.gravity * (first * sin(q[0]) + second * sin(q[0] + q[1]));
        q_dot.dot(&(self.mass_matrix(&q) * q_dot)) * constant(0.5) + potential
    }

    /// l₁.
    fn reach(&self) -> T {
        self.links[0].length
    }

    /// m₂ + m_p: what joint 2 carries.
    fn carried(&self) -> T {
        self.links[1].mass + self.payload
    }

    /// (m₁·c₁ + (m₂ + m_p)·l₁, m₂·c₂ + m_p·l₂) in kg·m: what gravity pulls at along link 1 and along link 2.
    fn levers(&self) -> (T, T) {
        let [first, second] = &self.links;
        (
            first.mass * first.centre + self.carried() * first.length,
            second.mass * second.centre + self.payload * second.length,
        )
    }

    /// I₂ + m₂·c₂² + m_p·l₂²: link 2 and payload about joint 2.
    fn outer_inertia(&self) -> T {
        let link = &self.links[1];
        link.about_joint() + self.payload * link.length * link.length
    }

    /// l₁·(m₂·c₂ + m_p·l₂), the factor of cos q₂ in M.
    fn coupling(&self) -> T {
        self.reach() * self.levers().1
    }

    /// M(q)⁻¹ in closed form.
    fn inverse_mass_matrix(&self, q: &SVector<T, 2>) -> SMatrix<T, 2, 2> {
        let [first, second] = &self.links;
        let apart = second.length - second.centre;
        let across = self.levers().1 * sin(q[1]);
        // det M with Steiner's theorem about the common centre of mass of link 2 and payload: no term is negative and the first
        // is positive, where M₁₁·M₂₂ − M₁₂² would cancel.
        let determinant = first.about_joint() * self.outer_inertia()
            + self.reach()
                * self.reach()
                * (self.carried() * second.inertia
                    + second.mass * self.payload * apart * apart
                    + across * across);
        let m = self.mass_matrix(q);
        SMatrix::from([[m[(1, 1)], -m[(1, 0)]], [-m[(0, 1)], m[(0, 0)]]]) / determinant
    }
}

/// (q, q̇) of the state.
fn halves<T: Scalar>(x: &SVector<T, 4>) -> (SVector<T, 2>, SVector<T, 2>) {
    (SVector::from([x[0], x[1]]), SVector::from([x[2], x[3]]))
}

impl<T: Scalar> ControlAffine<4, 2> for TwoLinkArm<T> {
    type Scalar = T;

    fn drift_field(&self, x: &SVector<T, 4>) -> SVector<T, 4> {
        let drift = self.chain_drift(x);
        SVector::from([x[2], x[3], drift[0], drift[1]])
    }

    fn input_fields(&self, x: &SVector<T, 4>) -> SMatrix<T, 4, 2> {
        let inverse = self.decoupling_matrix(x);
        SMatrix::from_fn(|i, j| if i < 2 { T::zero() } else { inverse[(i - 2, j)] })
    }
}

impl<T: Scalar> Decouplable<4, 2, 2> for TwoLinkArm<T> {
    type Scalar = T;

    fn chains(&self, x: &SVector<T, 4>) -> [SVector<T, 2>; 2] {
        [SVector::from([x[0], x[2]]), SVector::from([x[1], x[3]])]
    }

    fn chain_drift(&self, x: &SVector<T, 4>) -> SVector<T, 2> {
        let (q, q_dot) = halves(x);
        let friction = SVector::from(self.friction).component_mul(&q_dot);
        let resistance =
            self.coriolis_matrix(&q, &q_dot) * q_dot + friction + self.gravity_torque(&q);
        -(self.inverse_mass_matrix(&q) * resistance)
    }

    fn decoupling_matrix(&self, x: &SVector<T, 4>) -> SMatrix<T, 2, 2> {
        self.inverse_mass_matrix(&halves(x).0)
    }

    fn chain_rates(&self, _x: &SVector<T, 4>, x_dot: &SVector<T, 4>) -> SVector<T, 2> {
        halves(x_dot).1
    }
}

checked! {
    [T: Scalar] TwoLinkArm<T>, [T]
    { links: [Link<T>; 2], friction: [T; 2], gravity: T, payload: T } =>
    Self::new(links, friction, gravity).and_then(|arm| arm.with_payload(payload))
}
