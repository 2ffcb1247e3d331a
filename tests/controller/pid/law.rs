use brunovsky::{
    Scalar,
    controller::{AntiWindup, Controller, Measurement, Pid, PidGains, Reference},
    plant::{IntegratorChain, Uncertain},
};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

use super::{gains, pid, sampled};
use crate::{
    at_f32_and_f64,
    support::{num, real, run},
};

/// The loop around a mass, y'' = u, is linear in (y, ẏ, I, D): Ḋ = −(D + k_d·ẏ)/T_f, İ = k_i·(r − y). Its matrix exponential is the oracle; the
/// hold and the differences are of first order.
#[test]
fn the_loop_converges_to_the_continuous_one_with_order_one() {
    let (k, k_i, k_d, t_f, b, r) = (4.0, 1.5, 3.0, 0.2, 0.6, 2.0);
    let tuned = gains(k, k_i, k_d, t_f).with_weights(b, 0.0).unwrap();
    let rates = [
        [0.0, 1.0, 0.0, 0.0, 0.0],
        [-k, 0.0, 1.0, 1.0, k * b * r],
        [-k_i, 0.0, 0.0, 0.0, k_i * r],
        [0.0, -k_d / t_f, 0.0, -1.0 / t_f, 0.0],
        [0.0; 5],
    ];
    let rates = DMatrix::from_fn(5, 5, |i, j| rates[i][j]);
    // At the first sample D = 0, whatever ẏ.
    let start = DVector::from_row_slice(&[0.5, -1.0, 0.0, 0.0, 1.0]);
    let error = |dt| {
        let plant = IntegratorChain::<f64, 2>::new();
        let samples = run(&plant, pid(tuned), |_| Reference::setpoint(r), [0.5, -1.0], dt, 4.0);
        let errors = samples.iter().step_by(100).map(|sample| {
            let exact = (&rates * sample.t).exp() * &start;
            (sample.x[0] - exact[0]).abs().max((sample.command.u_i - exact[2]).abs())
        });
        errors.fold(0.0, f64::max)
    };
    let order = (error(0.002) / error(0.001)).log2();
    assert!((order - 1.0).abs() < 0.1, "order {order}");
}

/// I is what holds against a constant Δ, so no error is left, and none of the other shares.
#[test]
fn a_constant_uncertainty_leaves_no_error() {
    for delta in [0.7, -2.0] {
        let plant =
            Uncertain::matched(IntegratorChain::<f64, 2>::new(), |_: f64, _: &_, _: &_| delta);
        let tuned = gains(4.0, 2.0, 3.0, 0.1);
        let samples = run(&plant, pid(tuned), |_| Reference::setpoint(1.5), [0.0, 0.0], 0.01, 60.0);
        let last = samples.last().unwrap();
        // The slowest mode is about e^(−0.7·t); what is left is rounding.
        approx::assert_abs_diff_eq!(last.x[0], 1.5, epsilon = 1e-12);
        approx::assert_abs_diff_eq!(last.command.u_i, -delta, epsilon = 1e-12);
    }
}

/// After a step of y by 1: D(k) = −k_d/(T_f + h)·(T_f/(T_f + h))^(k−1), for periods on either side of T_f.
fn fades_geometrically<T: Scalar>() {
    for dt in [1e-3, 0.1, 1.0, 1e3] {
        let tuned = PidGains::parallel(T::zero(), T::zero(), num(0.7), num(0.1)).unwrap();
        let mut pid = Pid::<T, 1>::new(tuned, AntiWindup::None).unwrap();
        let mut at = |y: f64| {
            let (y, rest) = (Measurement::new([num::<T>(y)]), Reference::setpoint(T::zero()));
            real(pid.update(&y, &rest, num(dt)).unwrap().u)
        };
        assert_eq!(at(0.0), 0.0);
        for k in 0..20 {
            let expected = -0.7 / (0.1 + dt) * (0.1 / (0.1 + dt)).powi(k);
            let tolerance = 4.0 * f64::from(k + 2) * real(T::default_epsilon()) * expected.abs();
            let found = at(1.0);
            // The last of them are subnormal in f32, with steps of 1.4·10⁻⁴⁵.
            assert!((found - expected).abs() <= tolerance + 3e-45, "{found} {expected}");
        }
    }
}

/// Σ h·k_i·e(j), j < k: the error counts from the sample on at which it was measured.
fn sums_the_error<T: Scalar>() {
    let tuned = PidGains::new(num::<T>(2.0)).unwrap().with_integral_time(num(0.5)).unwrap();
    let mut pid = Pid::<T, 3>::new(tuned, AntiWindup::None).unwrap();
    let mut sum = 0.0;
    for k in 0..50_i32 {
        // Eighths and halves are exact in either precision.
        let (y, r) = (f64::from(k % 7) / 8.0, f64::from(k % 3) / 2.0);
        let x = Measurement::new([num(y), num(100.0), num(-100.0)]);
        let command = pid.update(&x, &Reference::setpoint(num(r)), num(0.25)).unwrap();
        assert_eq!(real(command.u_i), sum);
        assert_eq!(real(command.u_p), 2.0 * (r - y));
        assert_eq!((command.u, command.u_d), (command.u_p + command.u_i, T::zero()));
        sum += 0.25 * 4.0 * (r - y);
    }
}

at_f32_and_f64! {
    the_derivative_of_a_step_fades_geometrically_at_any_period => fades_geometrically,
    the_integral_is_the_sum_of_the_errors_so_far => sums_the_error,
}

proptest! {
    /// c = 0: a step of r shows in P alone; and the first sample has no derivative at all.
    #[test]
    fn a_step_of_the_reference_does_not_kick_the_derivative(
        y in -5.0..5.0_f64, r in prop::array::uniform2(-5.0..5.0_f64), b in 0.0..1.0_f64,
    ) {
        let mut pid = pid(gains(2.0, 1.0, 3.0, 0.01).with_weights(b, 0.0).unwrap());
        prop_assert_eq!(sampled(&mut pid, y, r[0], 0.01).u_d, 0.0);
        let stepped = sampled(&mut pid, y, r[1], 0.01);
        prop_assert_eq!(stepped.u_d, 0.0);
        prop_assert_eq!(stepped.u_p, 2.0 * (b * r[1] - y));
    }

    /// The law is odd: mirror y and r, and u is mirrored, bit for bit.
    #[test]
    fn the_mirrored_output_is_answered_by_the_mirrored_input(
        numbers in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -3.0..3.0_f64), 1..30),
        c in 0.0..1.0_f64, tracking_time in 0.0..2.0_f64,
    ) {
        for anti_windup in [
            AntiWindup::None,
            AntiWindup::BackCalculation { tracking_time },
            AntiWindup::Conditional { tolerance: 0.5 },
        ] {
            let tuned = gains(2.0, 1.0, 0.3, 0.05).with_weights(0.8, c).unwrap();
            let mut pid = Pid::<f64, 1>::new(tuned, anti_windup).unwrap();
            let mut mirrored = pid;
            for (y, r, u) in &numbers {
                let one = super::told(&mut pid, *u, *y, *r, 0.1);
                let other = super::told(&mut mirrored, -*u, -*y, -*r, 0.1);
                prop_assert_eq!(one.u, -other.u);
            }
        }
    }
}
