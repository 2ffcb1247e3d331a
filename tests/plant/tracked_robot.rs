use brunovsky::{
    Error,
    integrators::{Integrator, Rk4},
    plant::{Plant, TrackedRobot, Traction},
};
use nalgebra::SVector;

/// The state after `t` seconds under a constant command.
fn driven(traction: Traction<f64>, lag: f64, x: [f64; 5], u: [f64; 2], t: f64) -> SVector<f64, 5> {
    let robot = TrackedRobot::new(lag, |_, _| traction).unwrap();
    let field = |t, x: &SVector<f64, 5>| robot.derivative(t, x, &u.into());
    Rk4.integrate(field, 0.0, &x.into(), t, 4000).unwrap()
}

/// The tracks follow a step like 1 − e^(−t/τ).
#[test]
fn the_drives_are_first_order_lags() {
    let traction = Traction::new(0.9, 0.6, 0.1).unwrap();
    let x = driven(traction, 0.3, [0.0; 5], [0.4, 0.1], 0.5);
    let share = 1.0 - (-0.5_f64 / 0.3).exp();
    approx::assert_relative_eq!(x[3], 0.4 * share, max_relative = 1e-12);
    approx::assert_relative_eq!(x[4], 0.1 * share, max_relative = 1e-12);
    // The heading is κ times the integral of the yaw rate of the tracks.
    approx::assert_relative_eq!(x[2], 0.6 * 0.1 * (0.5 - 0.3 * share), max_relative = 1e-12);
}

/// With settled drives the robot turns about a point beside the one x_ICR ahead of it, at the distance μv/(κω).
#[test]
fn it_drives_a_circle_about_its_centre_of_rotation() {
    let traction = Traction::new(0.9, 0.5, 0.2).unwrap();
    let start = [1.0, 2.0, 0.3, 0.4, 0.08];
    let [mu_v, kappa_omega] = [0.9 * 0.4, 0.5 * 0.08];
    let centre = |x: &SVector<f64, 5>| {
        let ((sin, cos), radius) = (x[2].sin_cos(), mu_v / kappa_omega);
        [x[0] + 0.2 * cos - radius * sin, x[1] + 0.2 * sin + radius * cos]
    };
    let end = driven(traction, 0.3, start, [0.4, 0.08], 40.0);
    approx::assert_relative_eq!(end[2], 0.3 + kappa_omega * 40.0, max_relative = 1e-12);
    for (before, after) in centre(&start.into()).into_iter().zip(centre(&end)) {
        approx::assert_abs_diff_eq!(before, after, epsilon = 1e-9);
    }
}

/// The ground is what it is where the robot stands.
#[test]
fn the_traction_is_that_of_the_position() {
    let ground = |x: f64, y: f64| Traction::new(0.5 + 0.1 * x, 0.5 + 0.1 * y, 0.0).unwrap();
    let robot = TrackedRobot::new(0.3, ground).unwrap();
    let over_ground = robot.over_ground(&[2.0, 3.0, 0.7, 1.0, 0.5].into());
    assert_eq!(over_ground, [0.7, -0.0, 0.4]);
}

#[test]
fn parameters_out_of_range_are_refused() {
    let refused = |error: Option<Error>, wanted: &'static str| {
        assert!(matches!(error, Some(Error::NotPositive { name, value: 0.0 }) if name == wanted));
    };
    refused(Traction::new(0.0, 1.0, 0.0).err(), "mu");
    refused(Traction::new(1.0, 0.0, 0.0).err(), "kappa");
    let ground = |_, _| Traction { longitudinal: 1.0, yaw: 1.0, side: 0.0 };
    refused(TrackedRobot::new(0.0, ground).err(), "lag");
    let refused = Traction::new(1.0, 1.0, f64::NAN).err();
    assert!(matches!(refused, Some(Error::NonFinite { name: "x_icr", .. })));
}
