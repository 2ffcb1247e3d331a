//! The arm against mechanics: the Lagrangian by hyper-dual numbers, energy, momentum, mirror images and the pendulums inside it.

mod equations;
mod motion;
mod parameters;

use brunovsky::{
    Error, Scalar,
    plant::{ControlAffine, Decouplable, Link, Pendulum, Plant, TwoLinkArm},
};
use nalgebra::{ComplexField, Matrix2, SMatrix, SVector};
use num_dual::{Dual64, HyperDual64};
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{assert_equal_to_rounding, flow, num, order},
};

/// The parameters of an arm as plain numbers.
#[derive(Debug, Clone, Copy)]
struct Parameters {
    /// (m, l, c, I) of each link.
    links: [[f64; 4]; 2],
    friction: [f64; 2],
    gravity: f64,
    payload: f64,
}

impl Parameters {
    fn arm<T: Scalar>(&self) -> TwoLinkArm<T> {
        let links = self.links.map(|link| {
            let [mass, length, centre, inertia] = link.map(num::<T>);
            Link { mass, length, centre, inertia }
        });
        let arm = TwoLinkArm::new(links, self.friction.map(num), num(self.gravity)).unwrap();
        arm.with_payload(num(self.payload)).unwrap()
    }

    /// L = T − V, from where the three masses are and how fast they go; it knows no mass matrix.
    fn lagrangian(&self, q: [HyperDual64; 2], q_dot: [HyperDual64; 2]) -> HyperDual64 {
        let [[m1, l1, c1, i1], [m2, l2, c2, i2]] = self.links;
        let (angle, rate) = (q[0] + q[1], q_dot[0] + q_dot[1]);
        // A point at `a` along link 1 and `b` along the direction of link 2: ½·m·v² − m·g·y.
        let point = |mass: f64, a: f64, b: f64| {
            let x_dot = -q[0].sin() * q_dot[0] * a - angle.sin() * rate * b;
            let y_dot = q[0].cos() * q_dot[0] * a + angle.cos() * rate * b;
            let y = q[0].sin() * a + angle.sin() * b;
            (x_dot * x_dot + y_dot * y_dot) * (0.5 * mass) - y * (mass * self.gravity)
        };
        let spin = q_dot[0] * q_dot[0] * (0.5 * i1) + rate * rate * (0.5 * i2);
        point(m1, c1, 0.0) + point(m2, l1, c2) + point(self.payload, l1, l2) + spin
    }

    /// The torques of d/dt ∂L/∂q̇ − ∂L/∂q + F·q̇ = τ for the accelerations `q_ddot`.
    fn euler_lagrange(&self, x: &SVector<f64, 4>, q_ddot: &SVector<f64, 2>) -> SVector<f64, 2> {
        // Derivatives of L by the entries i and j of x; their numbers are exact to rounding.
        let second = |i: usize, j: usize| {
            let at: [HyperDual64; 4] = core::array::from_fn(|k| {
                let part = |of: usize| f64::from(u8::from(k == of));
                HyperDual64::new(x[k], part(i), part(j), 0.0)
            });
            self.lagrangian([at[0], at[1]], [at[2], at[3]])
        };
        SVector::from_fn(|i, _| {
            let rate_of_momentum: f64 = (0..2)
                .map(|j| {
                    second(2 + i, 2 + j).eps1eps2 * q_ddot[j] + second(2 + i, j).eps1eps2 * x[2 + j]
                })
                .sum();
            rate_of_momentum - second(i, i).eps1 + self.friction[i] * x[2 + i]
        })
    }
}

/// An arm of the size of a human one.
const ARM: Parameters = Parameters {
    links: [[2.0, 0.35, 0.15, 0.02], [1.5, 0.3, 0.2, 0.015]],
    friction: [0.0, 0.0],
    gravity: 9.81,
    payload: 0.8,
};

prop_compose! {
    fn parameters()(
        first in (0.5..5.0_f64, 0.2..1.5_f64, 0.0..1.0_f64, 0.01..0.5_f64),
        second in (0.5..5.0_f64, 0.2..1.5_f64, 0.0..1.0_f64, 0.01..0.5_f64),
        friction in prop::array::uniform2(0.0..2.0_f64), gravity in 0.0..20.0_f64,
        payload in prop_oneof![Just(0.0), 0.0..3.0_f64],
    ) -> Parameters {
        Parameters { links: [first.into(), second.into()], friction, gravity, payload }
    }
}

fn state() -> impl Strategy<Value = SVector<f64, 4>> {
    prop::array::uniform4(-4.0..4.0_f64).prop_map(SVector::from)
}

fn torque() -> impl Strategy<Value = SVector<f64, 2>> {
    prop::array::uniform2(-20.0..20.0_f64).prop_map(SVector::from)
}

fn halves<T: Scalar>(x: &SVector<T, 4>) -> (SVector<T, 2>, SVector<T, 2>) {
    (x.fixed_rows::<2>(0).into_owned(), x.fixed_rows::<2>(2).into_owned())
}

/// `x` moving at `rate`, as dual numbers.
fn moving(x: &SVector<f64, 4>, rate: &SVector<f64, 4>) -> SVector<Dual64, 4> {
    x.zip_map(rate, Dual64::new)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_accelerations_satisfy_the_euler_lagrange_equations(p in parameters(), x in state(), tau in torque()) {
        let rate = p.arm::<f64>().derivative(0.0, &x, &tau);
        let (velocity, q_ddot) = halves(&rate);
        prop_assert_eq!(velocity, halves(&x).1);
        // Torques of gravity and of rotation cancel in the sum; M·q̈ has their size, which rounding is relative to.
        let inertial = p.arm::<f64>().mass_matrix(&halves(&x).0).amax() * q_ddot.amax();
        let scale = 1000.0 + inertial;
        let error = (p.euler_lagrange(&x, &q_ddot) - tau).amax() / scale;
        prop_assert!(error <= 1e-12, "{error}");
    }

    #[test]
    fn the_terms_of_the_equation_are_those_of_the_lagrangian(p in parameters(), x in state()) {
        let arm = p.arm::<f64>();
        let (q, q_dot) = halves(&x);
        let rest = SVector::from([q[0], q[1], 0.0, 0.0]);
        let gravity = p.euler_lagrange(&rest, &SVector::zeros());
        // Torques of at most (15 kg·m)·(20 m/s²).
        prop_assert!((arm.gravity_torque(&q) - gravity).amax() <= 1e-12 * 300.0);
        for j in 0..2 {
            let unit = SVector::from_fn(|i, _| f64::from(u8::from(i == j)));
            let column = p.euler_lagrange(&rest, &unit) - gravity;
            prop_assert!((arm.mass_matrix(&q).column(j) - column).amax() <= 1e-12 * 300.0);
        }
        let friction = SVector::from(p.friction).component_mul(&q_dot);
        let coriolis = p.euler_lagrange(&x, &SVector::zeros()) - gravity - friction;
        // Squares of rates up to 8 rad/s times inertias up to 30 kg·m².
        prop_assert!((arm.coriolis_matrix(&q, &q_dot) * q_dot - coriolis).amax() <= 1e-12 * 2000.0);
    }

    /// dE/dt = τᵀ·q̇ − q̇ᵀ·F·q̇: the derivative of the energy along the field, exact by dual numbers.
    #[test]
    fn the_energy_changes_by_the_power_of_the_torques_and_of_the_friction(
        p in parameters(), x in state(), tau in torque(),
    ) {
        let rate = p.arm::<f64>().derivative(0.0, &x, &tau);
        let power = p.arm::<Dual64>().energy(&moving(&x, &rate)).eps;
        let q_dot = halves(&x).1;
        let lost = SVector::from(p.friction).component_mul(&q_dot).dot(&q_dot);
        // q̇ᵀ·M·q̈ cancels all but the power, to roundings of its size.
        let scale = 1e4 + p.arm::<f64>().mass_matrix(&halves(&x).0).amax() * rate.amax() * 8.0;
        prop_assert!((power - (tau.dot(&q_dot) - lost)).abs() <= 1e-13 * scale);
    }

    #[test]
    fn the_mass_matrix_is_symmetric_positive_definite_and_the_inverse_of_the_decoupling_matrix(
        p in parameters(), x in state(),
    ) {
        let arm = p.arm::<f64>();
        let m = arm.mass_matrix(&halves(&x).0);
        prop_assert_eq!(m, m.transpose());
        prop_assert!(m.cholesky().is_some());
        let b = arm.decoupling_matrix(&x);
        prop_assert_eq!(b, b.transpose());
        // The residual of an inverse is a few roundings times ‖M‖·‖M⁻¹‖.
        let tolerance = 32.0 * f64::EPSILON * m.norm() * b.norm();
        prop_assert!((m * b - Matrix2::identity()).amax() <= tolerance);
    }

    /// Ṁ along a motion, exact by dual numbers.
    #[test]
    fn the_rate_of_the_mass_matrix_less_twice_coriolis_is_skew_symmetric(p in parameters(), x in state()) {
        let (q, q_dot) = halves(&x);
        let along = q.zip_map(&q_dot, Dual64::new);
        let m_dot = p.arm::<Dual64>().mass_matrix(&along).map(|entry| entry.eps);
        let skew = m_dot - p.arm::<f64>().coriolis_matrix(&q, &q_dot) * 2.0;
        // Sums of two terms of at most 15·1.5·8.
        prop_assert!((skew + skew.transpose()).amax() <= 8.0 * f64::EPSILON * 200.0);
    }

    /// Reflection in the vertical axis: q₁ ↦ π − q₁ and everything else changes sign. Reflection in the horizontal axis turns gravity
    /// round, so it is a symmetry without gravity only.
    #[test]
    fn a_mirrored_arm_moves_as_the_mirror_image(p in parameters(), x in state(), tau in torque()) {
        let pi = core::f64::consts::PI;
        let there = p.arm::<f64>().derivative(0.0, &x, &tau);
        let image = SVector::from([pi - x[0], -x[1], -x[2], -x[3]]);
        let mirrored = p.arm::<f64>().derivative(0.0, &image, &(-tau));
        // π − q₁ rounds by 4 units, which gravity and M⁻¹ pass on.
        let scale = 1.0 + there.amax() + 300.0 * p.arm::<f64>().decoupling_matrix(&x).amax();
        prop_assert!((mirrored + there).amax() <= 32.0 * f64::EPSILON * scale);
        let horizontal = Parameters { gravity: 0.0, ..p }.arm::<f64>();
        prop_assert_eq!(
            horizontal.derivative(0.0, &(-x), &(-tau)),
            -horizontal.derivative(0.0, &x, &tau)
        );
    }

    #[test]
    fn any_pose_is_an_equilibrium_under_the_torques_that_hold_it(p in parameters(), x in state()) {
        let (q, _) = halves(&x);
        let arm = p.arm::<f64>();
        let rest = SVector::from([q[0], q[1], 0.0, 0.0]);
        let rate = arm.derivative(0.0, &rest, &arm.gravity_torque(&q));
        let scale = arm.decoupling_matrix(&rest).amax() * 300.0;
        prop_assert!(rate.amax() <= 16.0 * f64::EPSILON * scale);
    }

    #[test]
    fn its_rungs_and_its_chains_tell_of_one_motion(p in parameters(), x in state(), tau in torque()) {
        let arm = p.arm::<f64>();
        let rate = arm.derivative(0.0, &x, &tau);
        prop_assert_eq!(rate, arm.drift_field(&x) + arm.input_fields(&x) * tau);
        let (_, q_ddot) = halves(&rate);
        prop_assert_eq!(q_ddot, arm.chain_drift(&x) + arm.decoupling_matrix(&x) * tau);
        prop_assert_eq!(q_ddot, arm.chain_rates(&x, &rate));
        prop_assert_eq!(arm.chains(&x), [SVector::from([x[0], x[2]]), SVector::from([x[1], x[3]])]);
    }
}
