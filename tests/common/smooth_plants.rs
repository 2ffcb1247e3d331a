//! Plants by their equations, as their textbooks have them.

use brunovsky::{Scalar, differentiation::Smooth, plant::SmoothPlant};

/// A link driven through a spring: I·q̈ = −m·g·l·sin q − k·(q − θ), J·θ̈ = k·(q − θ) + u. State (q, q̇, θ, θ̇).
#[derive(Debug, Clone, Copy)]
pub struct FlexibleJoint<T> {
    pub link: T,
    pub motor: T,
    pub weight: T,
    pub stiffness: T,
}

impl<T: Scalar> SmoothPlant<4, 1> for FlexibleJoint<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [q, q_dot, theta, theta_dot]: [S; 4]) -> [S; 4] {
        let spring = (q - theta) * self.stiffness;
        let weight = q.sin() * self.weight;
        [q_dot, -(weight + spring) / self.link, theta_dot, spring / self.motor]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _: [S; 4]) -> [[S; 4]; 1] {
        [[T::zero(), T::zero(), T::zero(), self.motor.recip()].map(S::from)]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [q, ..]: [S; 4]) -> [S; 1] {
        [q]
    }
}

/// The unicycle with its speed as a state: ṗ = v·(cos θ, sin θ), v̇ = u₁, θ̇ = u₂; the position is to follow. State (p_x, p_y, θ, v).
#[derive(Debug, Clone, Copy)]
pub struct Cart<T>(pub core::marker::PhantomData<T>);

impl<T: Scalar> SmoothPlant<4, 2> for Cart<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [_, _, theta, v]: [S; 4]) -> [S; 4] {
        [v * theta.cos(), v * theta.sin(), S::zero(), S::zero()]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, _: [S; 4]) -> [[S; 4]; 2] {
        let (zero, one) = (S::zero(), S::one());
        [[zero, zero, zero, one], [zero, zero, one, zero]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [x, y, ..]: [S; 4]) -> [S; 2] {
        [x, y]
    }
}

/// Two links and a load at the tip: M(q)·q̈ + c(q, q̇) + F·q̇ + G(q) = τ, from the masses and where they are; the joint angles are to follow. State
/// (q₁, q₂, q̇₁, q̇₂), angles from the horizontal and from link 1.
#[derive(Debug, Clone, Copy)]
pub struct Arm<T> {
    /// (m, l, c, I) of each link.
    pub links: [[T; 4]; 2],
    pub friction: [T; 2],
    pub gravity: T,
    pub payload: T,
}

impl<T: Scalar> Arm<T> {
    /// M(q)⁻¹ by Cramer's rule.
    #[inline]
    fn inverse_mass<S: Smooth<T>>(&self, elbow: S) -> [[S; 2]; 2] {
        let [[m1, _, c1, i1], [m2, l2, c2, i2]] = self.links;
        let (l1, load) = (self.links[0][1], self.payload);
        let outer = i2 + m2 * c2 * c2 + load * l2 * l2;
        let off = elbow.cos() * (l1 * (m2 * c2 + load * l2)) + outer;
        let first = off + off - outer + (i1 + m1 * c1 * c1 + (m2 + load) * l1 * l1);
        let determinant = first * outer - off * off;
        let (diagonal, off) = (S::from(outer) / determinant, -off / determinant);
        [[diagonal, off], [off, first / determinant]]
    }
}

impl<T: Scalar> SmoothPlant<4, 2> for Arm<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [q1, q2, w1, w2]: [S; 4]) -> [S; 4] {
        let [[m1, l1, c1, _], [m2, l2, c2, _]] = self.links;
        let second = m2 * c2 + self.payload * l2;
        let first = m1 * c1 + (m2 + self.payload) * l1;
        let centrifugal = q2.sin() * (l1 * second);
        let hanging = (q1 + q2).cos() * (second * self.gravity);
        let torques = [
            -centrifugal * w2 * (w1 + w1 + w2)
                + w1 * self.friction[0]
                + hanging
                + q1.cos() * (first * self.gravity),
            centrifugal * w1 * w1 + w2 * self.friction[1] + hanging,
        ];
        let accelerations =
            self.inverse_mass(q2).map(|row| -(row[0] * torques[0] + row[1] * torques[1]));
        [w1, w2, accelerations[0], accelerations[1]]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, [_, q2, ..]: [S; 4]) -> [[S; 4]; 2] {
        // M⁻¹ is symmetric: its rows are its columns.
        self.inverse_mass(q2).map(|column| [S::zero(), S::zero(), column[0], column[1]])
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [q1, q2, ..]: [S; 4]) -> [S; 2] {
        [q1, q2]
    }
}
