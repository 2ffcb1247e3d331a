//! The flexible joint by its equations, and its linearizing law as derived by hand (Spong, Vidyasagar, *Robot Dynamics and Control*, 11.5).

use brunovsky::{
    Scalar,
    differentiation::Smooth,
    elementary::sin_cos,
    nalgebra::SMatrix,
    plant::{Linearization, SmoothPlant},
    prelude::SVector,
};

/// I·q̈ = −m·g·l·sin q − k·(q − θ), J·θ̈ = k·(q − θ) + u. State (q, q̇, θ, θ̇).
#[derive(Clone, Copy)]
pub struct FlexibleJoint<T> {
    link: T,
    motor: T,
    weight: T,
    stiffness: T,
}

impl<T: Scalar> FlexibleJoint<T> {
    pub fn new([link, motor, weight, stiffness]: [T; 4]) -> Self {
        Self { link, motor, weight, stiffness }
    }

    pub fn by_hand(&self, x: &SVector<T, 4>) -> Linearization<T, 4, 1> {
        let [q, q_dot, theta, theta_dot] = (*x).into();
        let (sin, cos) = sin_cos(q);
        let weight = self.weight / self.link;
        let (link, motor) = (self.stiffness / self.link, self.stiffness / self.motor);
        let second = -weight * sin - link * (q - theta);
        let third = -weight * cos * q_dot - link * (q_dot - theta_dot);
        let fourth = weight * sin * (q_dot * q_dot + weight * cos + link)
            + link * (q - theta) * (link + motor + weight * cos);
        let matrix = SMatrix::from([[link / self.motor]]);
        Linearization {
            chains: [SVector::from([q, q_dot, second, third])],
            drift: SVector::from([fourth]),
            matrix,
            inverted: matrix,
        }
    }
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
