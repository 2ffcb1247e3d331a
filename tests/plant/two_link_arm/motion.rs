//! What the arm conserves, and the pendulums inside it.

use super::*;

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

at_f32_and_f64! {
    below_a_held_joint_the_second_link_swings_as_a_pendulum => swings_as_a_pendulum_below_a_held_joint,
    it_rests_hanging_and_upright => rests_hanging_and_upright,
}
