//! The arm against mechanics: the Lagrangian by hyper-dual numbers, energy, momentum, mirror images and the pendulums inside it.

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

#[test]
fn without_friction_and_torque_the_energy_drifts_only_by_the_error_of_the_integrator() {
    let plant = ARM.arm::<f64>();
    let start = SVector::from([-1.0, 0.5, 0.0, 0.0]);
    let drift = |steps| {
        let end = flow(&plant, start, [0.0, 0.0], 2.0, steps);
        (plant.energy(&end) - plant.energy(&start)).abs()
    };
    // Rk4 has order 4, and order 5 where the errors of the energy cancel.
    let measured = order(drift(1000), drift(2000));
    assert!((3.8..5.5).contains(&measured), "order {measured}");
    assert!(drift(16_000) < 1e-10);
}

/// In a horizontal plane a turn of joint 1 changes nothing, so its momentum (M·q̇)₁ is conserved while the arm folds.
#[test]
fn without_gravity_the_angular_momentum_about_the_base_is_conserved() {
    let plant = Parameters { gravity: 0.0, ..ARM }.arm::<f64>();
    let momentum = |x: &SVector<f64, 4>| {
        let (q, q_dot) = halves(x);
        (plant.mass_matrix(&q) * q_dot)[0]
    };
    let start = SVector::from([0.3, 1.0, 1.5, -4.0]);
    let end = flow(&plant, start, [0.0, 0.0], 2.0, 8000);
    assert!((end - start).norm() > 1.0);
    // The state is exact to (h·q̇)⁴ ≈ 1e-12.
    approx::assert_abs_diff_eq!(momentum(&end), momentum(&start), epsilon = 1e-11);
}

/// With the outer link of a mass μ, joint 1 without torque and joint 2 straight, link 1 swings as the pendulum of its own mass:
/// the deviation falls with μ.
#[test]
fn an_outer_link_of_vanishing_mass_leaves_the_pendulum_of_the_inner_one() {
    let (mass, length) = (1.3, 0.7);
    let deviation = |mu: f64| {
        let links = [[mass, length, length, 0.0], [mu, 0.4, 0.2, 0.01 * mu]];
        let arm = Parameters { links, payload: 0.0, ..ARM }.arm::<f64>();
        let pendulum = Pendulum::new(mass, length, 0.0, ARM.gravity).unwrap();
        let start: [f64; 2] = [1.0, 0.4];
        // The pendulum's θ is counted from hanging down.
        let x = [start[0] - core::f64::consts::FRAC_PI_2, 0.2, start[1], 0.0];
        let found = arm.derivative(0.0, &x.into(), &SVector::zeros());
        (found[2] - pendulum.derivative(0.0, &start.into(), &[0.0].into())[1]).abs()
    };
    let measured = order(deviation(1e-3), deviation(5e-4));
    assert!((measured - 1.0).abs() < 0.01, "order {measured}");
}

/// With q₁ held at rest by its torque, link 2 is a physical pendulum: (I + m·c² + m_p·l²)·q̈₂ = τ₂ − F·q̇₂ − g·(m·c + m_p·l)·cos(q₁ + q₂).
fn swings_as_a_pendulum_below_a_held_joint<T: Scalar>() {
    let arm = Parameters { friction: [0.3, 0.2], ..ARM }.arm::<T>();
    let [m, l, c, i] = ARM.links[1];
    let inertia = i + m * c * c + ARM.payload * l * l;
    let lever = m * c + ARM.payload * l;
    let (q, rate, tau): ([f64; 2], f64, f64) = ([0.4, -1.9], 1.5, 0.7);
    let swing = (tau - 0.2 * rate - ARM.gravity * lever * (q[0] + q[1]).cos()) / inertia;
    let x = SVector::from([q[0], q[1], 0.0, rate].map(num::<T>));
    // The torque at joint 1 for which q̈ = (0, swing), from the first row of the equation of motion.
    let (position, velocity) = halves(&x);
    let q_ddot = SVector::from([T::zero(), num(swing)]);
    let holding = arm.mass_matrix(&position) * q_ddot
        + arm.coriolis_matrix(&position, &velocity) * velocity
        + arm.gravity_torque(&position);
    let found = arm.derivative(T::zero(), &x, &SVector::from([holding[0], num(tau)]));
    let expected = SVector::from([T::zero(), num(rate), T::zero(), num(swing)]);
    // M⁻¹ ≤ 20 /(kg·m²) times torques of 20 N·m round at 400 rad/s².
    assert_equal_to_rounding(&found, &expected, 400.0);
}

/// Both links hanging and both upright need no torque.
fn rests_hanging_and_upright<T: Scalar>() {
    let arm = ARM.arm::<T>();
    for (angle, side) in [(-T::frac_pi_2(), -1.0), (T::frac_pi_2(), 1.0)] {
        let x = SVector::from([angle, T::zero(), T::zero(), T::zero()]);
        let rate = arm.derivative(T::zero(), &x, &SVector::zeros());
        // π/2 is rounded to T: cos is as small as that rounding, and M⁻¹·g·Σ m·l ≤ 20·9.81·2.
        assert_equal_to_rounding(&rate, &SVector::zeros(), 400.0);
        let [[m1, l1, c1, _], [m2, l2, c2, _]] = ARM.links;
        let lifted = m1 * c1 + m2 * (l1 + c2) + ARM.payload * (l1 + l2);
        approx::assert_relative_eq!(
            arm.energy(&x),
            num::<T>(side * ARM.gravity * lifted),
            max_relative = T::default_epsilon() * num(8.0)
        );
    }
}

/// A payload is the point mass that it would be as part of link 2, by Steiner's theorem.
fn carries_a_payload_as_part_of_its_second_link<T: Scalar>() {
    let [[m1, l1, c1, i1], [m, l, c, i]] = ARM.links;
    let mass = m + ARM.payload;
    let centre = (m * c + ARM.payload * l) / mass;
    let inertia = i + m * (c - centre).powi(2) + ARM.payload * (l - centre).powi(2);
    let links = [[m1, l1, c1, i1], [mass, l, centre, inertia]];
    let merged = Parameters { links, payload: 0.0, ..ARM }.arm::<T>();
    let x = SVector::from([0.4, 1.1, -2.0, 3.0].map(num::<T>));
    let tau = SVector::from([3.0, -1.0].map(num::<T>));
    let expected = merged.derivative(T::zero(), &x, &tau);
    assert_equal_to_rounding(&ARM.arm().derivative(T::zero(), &x, &tau), &expected, 100.0);
}

/// Point masses on massless rods, folded so that M is as close to singular as it gets: det M = m₁·c₁²·M₂₂ at q₂ = 0.
fn inverts_the_double_pendulum_where_it_is_straight<T: Scalar>() {
    let links = [[1e-3, 1.0, 1.0, 0.0], [1.0, 1.0, 1.0, 0.0]];
    let arm = Parameters { links, payload: 0.0, ..ARM }.arm::<T>();
    let b = arm.decoupling_matrix(&SVector::zeros());
    // M = m₁·(1 0; 0 0) + (4 2; 2 1), so M⁻¹ = (1 −2; −2 4)/m₁ + (0 0; 0 1).
    let expected = SMatrix::<f64, 2, 2>::new(1000.0, -2000.0, -2000.0, 4001.0).map(num::<T>);
    let tolerance = T::default_epsilon() * num(8.0);
    approx::assert_relative_eq!(b, expected, max_relative = tolerance);
}

at_f32_and_f64! {
    below_a_held_joint_the_second_link_swings_as_a_pendulum => swings_as_a_pendulum_below_a_held_joint,
    it_rests_hanging_and_upright => rests_hanging_and_upright,
    a_payload_is_part_of_the_second_link => carries_a_payload_as_part_of_its_second_link,
    the_inverse_keeps_its_digits_near_a_singular_mass_matrix => inverts_the_double_pendulum_where_it_is_straight,
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    type Place = fn(&mut Parameters) -> &mut f64;
    let positive: [(&str, Place); 4] = [
        ("mass of link 1", |p| &mut p.links[0][0]),
        ("length of link 1", |p| &mut p.links[0][1]),
        ("mass of link 2", |p| &mut p.links[1][0]),
        ("length of link 2", |p| &mut p.links[1][1]),
    ];
    let not_negative: [(&str, Place); 8] = [
        ("centre of link 1", |p| &mut p.links[0][2]),
        ("inertia of link 1", |p| &mut p.links[0][3]),
        ("centre of link 2", |p| &mut p.links[1][2]),
        ("inertia of link 2", |p| &mut p.links[1][3]),
        ("friction of joint 1", |p| &mut p.friction[0]),
        ("friction of joint 2", |p| &mut p.friction[1]),
        ("gravity", |p| &mut p.gravity),
        ("payload", |p| &mut p.payload),
    ];
    let made = |place: Place, value: f64| {
        let mut p = ARM;
        *place(&mut p) = value;
        let links =
            p.links.map(|[mass, length, centre, inertia]| Link { mass, length, centre, inertia });
        TwoLinkArm::new(links, p.friction, p.gravity)?.with_payload(p.payload)
    };
    for (name, place) in positive {
        for value in [0.0, -0.0, -1.0] {
            assert_eq!(made(place, value), Err(Error::NotPositive { name, value }));
        }
    }
    for (name, place) in not_negative {
        assert!(made(place, 0.0).is_ok());
        let value = -1e-300;
        assert_eq!(made(place, value), Err(Error::Negative { name, value }));
    }
    for (name, place) in positive.into_iter().chain(not_negative) {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let error = made(place, value).unwrap_err();
            assert!(matches!(error, Error::NonFinite { name: found, .. } if found == name));
        }
    }
}

#[test]
fn a_link_that_turns_without_inertia_about_its_joint_is_refused() {
    let good = Link { mass: 1.0, length: 1.0, centre: 0.5, inertia: 0.0 };
    let made = |links| TwoLinkArm::new(links, [0.0; 2], 9.81).unwrap_err();
    let name = "inertia of link 1 about its joint";
    let bad = Link { centre: 0.0, ..good };
    assert_eq!(made([bad, good]), Error::NotPositive { name, value: 0.0 });
    let name = "inertia of link 2 about its joint";
    assert_eq!(made([good, bad]), Error::NotPositive { name, value: 0.0 });
    let bad = Link { centre: 1e200, ..good };
    assert_eq!(made([good, bad]), Error::NonFinite { name, value: f64::INFINITY });
}
