use nalgebra::SVector;

use super::{SmoothPlant, smooth::control_affine};
use crate::{
    Error, Scalar,
    differentiation::Smooth,
    elementary::{cos, sin},
    error::{not_negative, positive},
    scalar::constant,
};

/// An inverted pendulum on a cart, a point mass on a massless rod:
/// (M + m)·p̈ − m·l·(θ̈·cos θ − θ̇²·sin θ) + c·ṗ = F, m·l²·θ̈ − m·l·p̈·cos θ + d·θ̇ − m·g·l·sin θ = 0.
///
/// State (p, θ, ṗ, θ̇) in m, rad, m/s and rad/s, with θ counter-clockwise from upright, the mass at (p − l·sin θ, l·cos θ); input F, the force
/// on the cart in N. With one input it has one output, of relative degree 2, and zero dynamics of order 2:
///
/// | output | relative degree | what is left when it rests |
/// |---|---|---|
/// | [`Position`](CartPoleOutput::Position) p | 2 everywhere | a pendulum on a fixed pivot, m·l²·θ̈ + d·θ̇ = m·g·l·sin θ: unstable about upright, stable about hanging (θ = π), asymptotically if d > 0 |
/// | [`Angle`](CartPoleOutput::Angle) θ | 2 for \|θ\| < π/2, none at ±π/2 | a cart that drifts: p̈ = −g·tan θ, at θ = 0 on and on with the speed it has |
///
/// So neither output, followed exactly, balances the pendulum *and* keeps the cart.
///
/// # References
/// K. J. Åström, R. M. Murray, *Feedback Systems*, "Balance systems" (equations and signs); A. Isidori, *Nonlinear Control Systems*, 4.3 (zero
/// dynamics).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CartPole<T> {
    cart: T,
    pole: T,
    length: T,
    friction: [T; 2],
    gravity: T,
    output: CartPoleOutput,
}

/// What of [`CartPole`] is to follow a reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum CartPoleOutput {
    /// The position p of the cart, in m.
    Position,
    /// The angle θ of the pole, in rad.
    Angle,
}

impl<T: Scalar> CartPole<T> {
    /// A `cart` of mass M > 0 and a `pole` of mass m > 0 in kg and `length` l > 0 in m, with viscous `friction` of the cart c ≥ 0 in N·s/m and of
    /// the pivot d ≥ 0 in N·m·s/rad, under `gravity` g ≥ 0 in m/s².
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`], naming the parameter.
    pub fn new(
        cart: T,
        pole: T,
        length: T,
        friction: [T; 2],
        gravity: T,
        output: CartPoleOutput,
    ) -> Result<Self, Error> {
        Ok(Self {
            cart: positive("cart", cart)?,
            pole: positive("pole", pole)?,
            length: positive("length", length)?,
            friction: [
                not_negative("friction of the cart", friction[0])?,
                not_negative("friction of the pivot", friction[1])?,
            ],
            gravity: not_negative("gravity", gravity)?,
            output,
        })
    }

    /// The energy ½·M·ṗ² + ½·m·|v|² + m·g·l·cos θ in J, with v the velocity of the point mass; Ė = F·ṗ − c·ṗ² − d·θ̇².
    pub fn energy(&self, x: &SVector<T, 4>) -> T {
        let across = x[2] - self.length * x[3] * cos(x[1]);
        let down = self.length * x[3] * sin(x[1]);
        let kinetic = self.cart * x[2] * x[2] + self.pole * (across * across + down * down);
        kinetic * constant(0.5) + self.pole * self.gravity * self.length * cos(x[1])
    }

    /// M + m·sin² θ: what a force on the cart has to move.
    #[inline]
    fn moved<S: Smooth<T>>(&self, sin: S) -> S {
        sin * sin * self.pole + self.cart
    }
}

impl<T: Scalar> SmoothPlant<4, 1> for CartPole<T> {
    type Scalar = T;

    #[inline]
    fn drift_field<S: Smooth<T>>(&self, [_, theta, p_dot, theta_dot]: [S; 4]) -> [S; 4] {
        let (sin, cos) = theta.sin_cos();
        let [cart, pivot] = self.friction;
        // Forces on the cart; torque about the pivot over m·l.
        let force = -(theta_dot * theta_dot * sin * (self.pole * self.length) + p_dot * cart);
        let torque = sin * self.gravity - theta_dot * (pivot / (self.pole * self.length));
        let moved = self.moved(sin);
        let p_ddot = (force + cos * torque * self.pole) / moved;
        let theta_ddot = (torque * (self.cart + self.pole) + cos * force) / (moved * self.length);
        [p_dot, theta_dot, p_ddot, theta_ddot]
    }

    #[inline]
    fn input_fields<S: Smooth<T>>(&self, [_, theta, ..]: [S; 4]) -> [[S; 4]; 1] {
        let (sin, cos) = theta.sin_cos();
        let inverse = self.moved(sin).recip();
        [[S::zero(), S::zero(), inverse, cos * inverse / self.length]]
    }

    #[inline]
    fn outputs<S: Smooth<T>>(&self, [p, theta, ..]: [S; 4]) -> [S; 1] {
        match self.output {
            CartPoleOutput::Position => [p],
            CartPoleOutput::Angle => [theta],
        }
    }
}

control_affine!(CartPole, 4, 1);

checked! {
    [T: Scalar] CartPole<T>, [T]
    { cart: T, pole: T, length: T, friction: [T; 2], gravity: T, output: CartPoleOutput } =>
    Self::new(cart, pole, length, friction, gravity, output)
}
