//! Chains that learn: a payload that the model does not know, and what s says of it.

use super::*;

/// The joints' errors after 30 s of holding the pose with a payload of 1 kg that the model does not know.
fn held<C: ChainControllers<f64, 2, 2>>(chains: C) -> SVector<f64, 2> {
    let (plant, model) = (arm::<f64>(1.0), arm::<f64>(0.0));
    let x0 = [POSE[0], POSE[1], 0.0, 0.0];
    let simulation =
        Simulation::new(&plant, Decoupling::new(model, chains), pose, x0, 0.005).unwrap();
    let x = simulation.until(30.0).unwrap().last().unwrap().unwrap().x;
    SVector::from([POSE[0] - x[0], POSE[1] - x[1]])
}

/// At rest at q the torque M̂·(k₁·e) + Ĝ of the model is the G of the loaded arm: k₁·e = M̂(q)⁻¹·(G(q) − Ĝ(q)), at q = r − e.
#[test]
fn an_unknown_payload_leaves_the_steady_error_of_both_arms_gravity() {
    let e = held([joint(4.0); 2]);
    let q = SVector::from(POSE) - e;
    let missing = arm::<f64>(1.0).gravity_torque(&q) - arm::<f64>(0.0).gravity_torque(&q);
    let expected = arm::<f64>(0.0).mass_matrix(&q).try_inverse().unwrap() * missing / 16.0;
    assert!(e.amax() > 0.1);
    approx::assert_abs_diff_eq!(e, expected, epsilon = 1e-9);
}

#[test]
fn learning_chains_leave_no_steady_error() {
    // The loop rests where s = 0 to rounding, and with ė₂ = 0 there u_b = 16·e₁.
    assert!(held([learner(ModelAided::new()); 2]).amax() < 1e-6);
    assert!(held([learner(Measured); 2]).amax() < 1e-6);
    assert!(held([learner(BackwardDifference::new()); 2]).amax() < 1e-6);
}

fn sliding_is_minus_what_is_not_learned<T: Scalar>() {
    let (plant, model) = (arm::<T>(1.0), arm::<T>(0.0));
    let mut controller = Decoupling::new(model, [learner::<T, _>(Measured); 2]);
    let mut learned = SVector::<T, 2>::zeros();
    let tolerance = T::default_epsilon() * num(4000.0);
    for k in 0..20 {
        let at = f64::from(k) * 0.1;
        let x = SVector::from([at.sin(), 0.5 - at, 1.0 - at, at.cos()].map(num::<T>));
        let u = SVector::from([2.0 + at, at.sin()].map(num::<T>));
        let x_dot = plant.derivative(T::zero(), &x, &u);
        let delta = (x_dot - model.derivative(T::zero(), &x, &u)).fixed_rows::<2>(2).into_owned();
        let measurement = Measurement::new(x).with_rate(x_dot).with_applied(u);
        let reference = [Reference::setpoint(num(0.3)), Reference::setpoint(num(-0.2))];
        let command = controller.update(&measurement, &reference, num(0.01)).unwrap();
        for i in 0..2 {
            let ClelcCommand { s, u_n, .. } = command.chains[i];
            // The antecedents flow with the error, so before it learns the network's output is still the u_n of the sample before. Accelerations
            // of up to 500 rad/s² cancel.
            assert!((s + learned[i] + delta[i]).abs() <= tolerance, "{s} at {k}");
            learned[i] = u_n;
        }
    }
    assert!(learned.amin() != T::zero());
}

/// With the null compensator u_n = 0, so s is −Δ at every sample.
fn measured_sliding_is_minus_the_uncertainty<T: Scalar>() {
    let (plant, model) = (arm::<T>(1.0), arm::<T>(0.0));
    let null = Clelc::new(joint::<T>(4.0), NullCompensator::new(Measured));
    let mut controller = Decoupling::new(model, [null; 2]);
    for k in 0..20 {
        let at = f64::from(k) * 0.1;
        let x = SVector::from([at.sin(), 0.5 - at, 1.0 - at, at.cos()].map(num::<T>));
        let u = SVector::from([2.0 + at, at.sin()].map(num::<T>));
        let x_dot = plant.derivative(T::zero(), &x, &u);
        let modelled = model.derivative(T::zero(), &x, &u);
        let measurement = Measurement::new(x).with_rate(x_dot).with_applied(u);
        let command = controller
            .update(&measurement, &[Reference::setpoint(T::zero()); 2], num(0.01))
            .unwrap();
        for i in 0..2 {
            let s = command.chains[i].s;
            // Accelerations of up to 500 rad/s² cancel.
            let tolerance = 4000.0 * real(T::default_epsilon());
            approx::assert_abs_diff_eq!(
                real(s),
                real(modelled[2 + i] - x_dot[2 + i]),
                epsilon = tolerance
            );
        }
    }
}

/// s of ModelAided is −Δ̂: what the last period showed under the *reported* input, whatever was commanded.
fn a_reported_saturation_leaves_s_untouched<T: Scalar>() {
    let model = arm::<T>(0.0);
    let null = Clelc::new(joint::<T>(4.0), NullCompensator::new(ModelAided::new()));
    let mut controller = Decoupling::new(model, [null; 2]);
    let far = [Reference::setpoint(num(30.0)), Reference::setpoint(num(-30.0))];
    let dt = num::<T>(0.01);
    let delta = SVector::from([3.0, -2.0].map(num::<T>));
    let x = SVector::from([0.3, 0.4, 0.5, -0.6].map(num::<T>));
    controller.update(&Measurement::new(x), &far, dt).unwrap();
    let u = SVector::from([4.0, 1.0].map(num::<T>));
    // A period at whose end the rates have changed by dt times the mean of (a + B·u) at both ends, and Δ. The rates at the end appear in the
    // mean, so they are found by iteration, which contracts with dt.
    let mut end = x;
    for _ in 0..40 {
        let mean = (model.derivative(dt, &x, &u) + model.derivative(dt, &end, &u)) * num::<T>(0.5);
        for i in 0..2 {
            end[2 + i] = x[2 + i] + dt * (mean[2 + i] + delta[i]);
        }
    }
    let command = controller.update(&Measurement::new(end).with_applied(u), &far, dt).unwrap();
    assert!((command.u - u).amin() > num(10.0), "the command is far from what arrived");
    for i in 0..2 {
        // Rates near 1 round, and are divided by dt.
        let tolerance = 64.0 * 100.0 * real(T::default_epsilon());
        approx::assert_abs_diff_eq!(
            real(command.chains[i].s),
            -real(delta[i]),
            epsilon = tolerance
        );
    }
}

at_f32_and_f64! {
    s_of_a_learning_chain_is_what_is_not_learned => sliding_is_minus_what_is_not_learned,
    s_of_a_measured_rate_is_minus_the_uncertainty => measured_sliding_is_minus_the_uncertainty,
    an_applied_input_that_is_reported_does_not_show_in_s => a_reported_saturation_leaves_s_untouched,
}
