use super::TwoLinkArm;
use crate::{Scalar, differentiation::Smooth, plant::SmoothPlant};

impl<T: Scalar> TwoLinkArm<T> {
    /// q̈ = M(q)⁻¹·`torque`, in closed form; see [`inverse_mass_matrix`](Self::inverse_mass_matrix).
    #[inline]
    fn accelerations<S: Smooth<T>>(&self, q2: S, torque: [S; 2]) -> [S; 2] {
        let (sin, cos) = q2.sin_cos();
        let [first, second] = &self.links;
        let reach = self.reach();
        let (apart, outer) = (second.length - second.centre, self.outer_inertia());
        let inner = first.about_joint() + self.carried() * reach * reach;
        let coupled = cos * self.coupling();
        let off_diagonal = coupled + outer;
        let determinant = (sin * self.coupling()).powi(2)
            + (first.about_joint() * outer
                + reach
                    * reach
                    * (self.carried() * second.inertia
                        + second.mass * self.payload * apart * apart));
        let [shoulder, elbow] = torque;
        [
            (shoulder * outer - elbow * off_diagonal) / determinant,
            (elbow * (coupled + off_diagonal + inner) - shoulder * off_diagonal) / determinant,
        ]
    }
}

/// The outputs are the angles of the joints.
impl<T: Scalar> SmoothPlant<4, 2> for TwoLinkArm<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [q1, q2, w1, w2]: [S; 4]) -> [S; 4] {
        let (first, second) = self.levers();
        let h = -q2.sin() * self.coupling();
        let outer_weight = (q1 + q2).cos() * (self.gravity * second);
        let weight = q1.cos() * (self.gravity * first) + outer_weight;
        let shoulder = h * w2 * (w1 + (w1 + w2)) + w1 * self.friction[0] + weight;
        let elbow = -h * w1 * w1 + w2 * self.friction[1] + outer_weight;
        let [first, second] = self.accelerations(q2, [-shoulder, -elbow]);
        [w1, w2, first, second]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, [_, q2, ..]: [S; 4]) -> [[S; 4]; 2] {
        let (zero, one) = (S::zero(), S::one());
        [[one, zero], [zero, one]].map(|torque| {
            let [first, second] = self.accelerations(q2, torque);
            [zero, zero, first, second]
        })
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [q1, q2, ..]: [S; 4]) -> [S; 2] {
        [q1, q2]
    }
}
