//! PID control against the matrix exponential of its continuous loop, geometric series, and what "without a bump" means.

mod anti_windup;
mod bumpless;
mod law;

use brunovsky::{
    Error,
    controller::{AntiWindup, Controller, Measurement, Pid, PidCommand, PidGains, Reference},
};

/// K, k_i, k_d, T_f as they are.
fn gains(k: f64, k_i: f64, k_d: f64, t_f: f64) -> PidGains<f64> {
    PidGains::parallel(k, k_i, k_d, t_f).unwrap()
}

fn pid<const N: usize>(gains: PidGains<f64>) -> Pid<f64, N> {
    Pid::new(gains, AntiWindup::None).unwrap()
}

/// A sample of the output `y` alone.
fn sampled(pid: &mut Pid<f64, 1>, y: f64, r: f64, dt: f64) -> PidCommand<f64> {
    pid.update(&Measurement::new([y]), &Reference::setpoint(r), dt).unwrap()
}

/// The same, told that `applied` has arrived since the sample before.
fn told(pid: &mut Pid<f64, 1>, applied: f64, y: f64, r: f64, dt: f64) -> PidCommand<f64> {
    let measurement = Measurement::new([y]).with_applied([applied]);
    pid.update(&measurement, &Reference::setpoint(r), dt).unwrap()
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY] {
        let names = [
            ("K", PidGains::new(bad)),
            ("K", PidGains::parallel(bad, 1.0, 1.0, 1.0)),
            ("k_i", PidGains::parallel(1.0, bad, 1.0, 1.0)),
            ("k_d", PidGains::parallel(1.0, 1.0, bad, 1.0)),
            ("T_f", PidGains::parallel(1.0, 1.0, 1.0, bad)),
            ("T_i", PidGains::new(1.0).unwrap().with_integral_time(bad)),
            ("T_d", PidGains::new(1.0).unwrap().with_derivative_time(bad, 1.0)),
            ("T_f", PidGains::new(1.0).unwrap().with_derivative_time(1.0, bad)),
            ("b", PidGains::new(1.0).unwrap().with_weights(bad, 0.0)),
            ("c", PidGains::new(1.0).unwrap().with_weights(0.0, bad)),
        ];
        for (wrong, gains) in names {
            assert!(
                matches!(gains, Err(Error::NonFinite { name, .. }) if name == wrong),
                "{wrong}"
            );
        }
    }
    let one = PidGains::new(1.0).unwrap();
    for value in [0.0, -1.0] {
        let refused = Err(Error::NotPositive { name: "T_i", value });
        assert_eq!(one.with_integral_time(value), refused);
        let refused = Err(Error::NotPositive { name: "T_f", value });
        assert_eq!(one.with_derivative_time(1.0, value), refused);
        assert_eq!(PidGains::parallel(1.0, 1.0, 1.0, value), refused);
    }
    let value = -1.0;
    assert_eq!(one.with_derivative_time(value, 1.0), Err(Error::Negative { name: "T_d", value }));
    for (wrong, anti_windup) in [
        ("tracking time", AntiWindup::BackCalculation { tracking_time: value }),
        ("tolerance", AntiWindup::Conditional { tolerance: value }),
    ] {
        let refused = Pid::<_, 1>::new(one, anti_windup).unwrap_err();
        assert_eq!(refused, Error::Negative { name: wrong, value });
    }
    // K/T_i and K·T_d beyond the range of the scalar.
    let large = PidGains::new(1e300).unwrap();
    assert!(matches!(
        large.with_integral_time(1e-300),
        Err(Error::NonFinite { name: "K/T_i", .. })
    ));
    assert!(matches!(
        large.with_derivative_time(1e300, 1.0),
        Err(Error::NonFinite { name: "K*T_d", .. })
    ));
}

/// K, T_i and T_d name the gains that K, k_i and k_d name.
#[test]
fn the_standard_form_is_the_parallel_one() {
    let standard = PidGains::new(3.0).unwrap();
    let standard = standard.with_integral_time(0.5).unwrap();
    let standard = standard.with_derivative_time(0.25, 0.125).unwrap();
    assert_eq!(standard, gains(3.0, 6.0, 0.75, 0.125));
}

#[test]
fn a_bad_call_changes_nothing_and_reset_everything() {
    let fresh = pid::<2>(gains(2.0, 1.0, 0.5, 0.1));
    let mut used = fresh;
    let (x, rest) = (Measurement::new([1.0, 2.0]), Reference::setpoint(0.0));
    used.update(&x, &rest, 0.1).unwrap();
    used.start_at(4.0).unwrap();
    let before = used;
    assert_ne!(used, fresh);
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(used.update(&x, &rest, dt).is_err());
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = used.update(&Measurement::new([0.0, bad]), &rest, 0.1);
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "x", index: 1, .. })));
        assert!(used.update(&x.with_applied([bad]), &rest, 0.1).is_err());
        assert!(used.update(&x, &Reference::setpoint(bad), 0.1).is_err());
        assert!(used.start_at(bad).is_err());
    }
    // Finite, and yet out of range with the gains, now or at the next sample.
    for huge in [f64::MAX, f64::MAX / 1e3] {
        assert!(used.update(&Measurement::new([huge, 0.0]), &rest, 0.1).is_err());
    }
    assert!(used.set_gains(gains(f64::MAX, 1.0, 0.5, 0.1)).is_err());
    let refused = Error::Missing { name: "consent" };
    assert_eq!(used.update_if(&x, &rest, 0.1, &mut |_| Err(refused)), Err(refused));
    assert_eq!(used, before);
    Controller::reset(&mut used);
    assert_eq!(used, fresh);
}
