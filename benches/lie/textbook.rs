//! The linearizing law of the flexible joint, derived by hand (Spong, Vidyasagar, *Robot Dynamics and Control*, 11.5).

use brunovsky::{
    Scalar, elementary::sin_cos, nalgebra::SMatrix, plant::Linearization, prelude::SVector,
};

use crate::smooth_plants::FlexibleJoint;

pub fn linearization<T: Scalar>(
    joint: &FlexibleJoint<T>,
    x: &SVector<T, 4>,
) -> Linearization<T, 4, 1> {
    let [q, q_dot, theta, theta_dot] = (*x).into();
    let (sin, cos) = sin_cos(q);
    let weight = joint.weight / joint.link;
    let (link, motor) = (joint.stiffness / joint.link, joint.stiffness / joint.motor);
    let second = -weight * sin - link * (q - theta);
    let third = -weight * cos * q_dot - link * (q_dot - theta_dot);
    let fourth = weight * sin * (q_dot * q_dot + weight * cos + link)
        + link * (q - theta) * (link + motor + weight * cos);
    let matrix = SMatrix::from([[link / joint.motor]]);
    Linearization {
        chains: [SVector::from([q, q_dot, second, third])],
        drift: SVector::from([fourth]),
        matrix,
        inverted: matrix,
    }
}
