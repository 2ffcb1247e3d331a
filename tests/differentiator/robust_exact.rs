use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    differentiator::{BackwardDifference, Differentiator, RobustExact},
    simulation::TotalVariation,
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, cases, rates, real, rng, ulps};

in_both_precisions! {
    a_polynomial_of_its_degree_is_exact_after_as_many_samples_as_it_has_coefficients,
    scaling_the_signal_and_the_bound_scales_the_estimates,
    scaling_time_scales_the_estimates,
    a_bound_out_of_range_is_refused,
}

/// The gains of the three orders.
const GAINS: [&[f64]; 3] = [&[1.5, 1.1], &[2.0, 2.12, 1.1], &[3.0, 4.16, 3.06, 1.1]];

/// The largest magnitude.
fn peak(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(0.0, |peak: f64, error| peak.max(error.abs()))
}

/// Estimates at every sample.
fn run<const M: usize>(
    mut source: RobustExact<f64, M>,
    h: f64,
    samples: u32,
    signal: impl Fn(u32) -> f64,
) -> Vec<[f64; M]> {
    let mut estimates = |k| {
        source.update(signal(k), h).unwrap();
        source.estimates().unwrap()
    };
    (0..samples).map(&mut estimates).collect()
}

/// With a bound that no sample exceeds the mode slides from the start, and a polynomial of degree n is known from n + 1 samples.
fn a_polynomial_of_its_degree_is_exact_after_as_many_samples_as_it_has_coefficients<T: Scalar>() {
    fn check<T: Scalar, const M: usize>(source: RobustExact<T, M>) {
        proptest!(cases(50), |(c in prop::array::uniform4(-8..8_i32), h in 0.1..1.0_f64)| {
            let c = c.map(f64::from);
            let mut source = source;
            for k in 0..10 {
                let t = f64::from(k) * h;
                // Coefficients beyond the degree are 0.
                let y = (0..M).rev().fold(0.0, |sum, i| sum * t + c[i]);
                let rate = source.update(real(y), real(h)).unwrap();
                if k as usize >= M {
                    let wanted = (1..M).rev().fold(0.0, |sum, i| sum * t + i as f64 * c[i]);
                    // |y| < 8·(1 + 9 + 81 + 729), rounded, over h; the weights of four samples have a sum below 10, of what they carry along, 10 more.
                    let size = 8.0 * (0..M).map(|i| t.max(1.0).powi(i as i32)).sum::<f64>();
                    assert_abs_diff_eq!(rate, real(wanted), epsilon = ulps(size / h * 100.0));
                }
            }
        });
    }
    let huge = real::<T>(1e12);
    check(RobustExact::first_order(huge).unwrap());
    check(RobustExact::second_order(huge).unwrap());
    check(RobustExact::third_order(huge).unwrap());
}

/// The scheme of the literature, written from its equations in backward differences: zᵢ⁺ = zᵢ + h·zᵢ₊₁⁺ − h·λᵢ·L^((i+1)/M)·|e|^((n−i)/M)·sgn(e), and
/// e = z₀⁺ − y found by bisection.
fn textbook(lambda: &[f64], bound: f64, h: f64, x: &mut [f64], y: f64) {
    let m = lambda.len() as i32;
    let strength = |i: usize, e: f64| {
        let exponent = |j: i32| f64::from(j) / f64::from(m);
        lambda[i] * bound.powf(exponent(i as i32 + 1)) * e.powf(exponent(m - 1 - i as i32))
    };
    let ahead: f64 = x.iter().enumerate().map(|(i, x)| x * h.powi(i as i32)).sum::<f64>() - y;
    let pull = |e: f64| -> f64 {
        e + (0..x.len()).map(|i| h.powi(i as i32 + 1) * strength(i, e)).sum::<f64>()
    };
    let last = lambda.len() - 1;
    let (mut low, mut high) = (0.0, ahead.abs());
    let set_valued = (ahead.abs() - pull(0.0)).min(0.0) / (h.powi(m) * strength(last, 0.0));
    if ahead.abs() > pull(0.0) {
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if pull(middle) > ahead.abs() { high = middle } else { low = middle }
        }
    } else {
        high = 0.0;
    }
    let e = high;
    let sign = ahead.signum();
    for i in (0..x.len()).rev() {
        let share = if i == last { 1.0 + set_valued } else { 1.0 };
        let next = x.get(i + 1).copied().unwrap_or(0.0);
        x[i] += h * next - h * strength(i, e) * share * sign;
    }
}

/// At a constant period the estimates are those of the textbook's scheme, with derivatives for its backward differences. The bound is met and
/// exceeded in turn.
#[test]
fn it_is_the_implicit_scheme_of_the_literature() {
    fn check<const M: usize>(source: RobustExact<f64, M>, lambda: &[f64], bound: f64) {
        let h = 0.1;
        let signal = |k: u32| (0.7 * f64::from(k) * h).sin() + if k > 60 { 3.0 } else { 0.0 };
        let mut x = vec![0.0; M];
        x[0] = signal(0);
        for (k, z) in run(source, h, 150, signal).into_iter().enumerate().skip(1) {
            textbook(lambda, bound, h, &mut x, signal(k as u32));
            let difference = |i: usize| x.get(i).copied().unwrap_or(0.0);
            let rate = difference(1) + h / 2.0 * difference(2) + h * h / 3.0 * difference(3);
            assert_abs_diff_eq!(z[0], x[0], epsilon = 1e-9);
            assert_abs_diff_eq!(z[1], rate, epsilon = 1e-7);
            assert_abs_diff_eq!(z[M - 1], x[M - 1], epsilon = 1e-5);
        }
    }
    for bound in [0.3, 2.0, 50.0] {
        check(RobustExact::first_order(bound).unwrap(), GAINS[0], bound);
        check(RobustExact::second_order(bound).unwrap(), GAINS[1], bound);
        check(RobustExact::third_order(bound).unwrap(), GAINS[2], bound);
    }
}

/// Powers of two scale without rounding.
fn scaling_the_signal_and_the_bound_scales_the_estimates<T: Scalar>() {
    let signal = |t: f64| (3.0 * t).sin() + (17.0 * t).cos() * 0.125;
    for scale in [0.0625, 8.0] {
        let plain = rates::<T>(RobustExact::second_order(real(2.0)).unwrap(), 0.1, 100, signal);
        let source = RobustExact::second_order(real(2.0 * scale)).unwrap();
        let scaled = rates::<T>(source, 0.1, 100, |t| scale * signal(t));
        assert!(plain.into_iter().zip(scaled).all(|(one, other)| one * real(scale) == other));
    }
}

/// The weights of homogeneity: with t → 2t, y⁽ⁱ⁾ → 2⁻ⁱ·y⁽ⁱ⁾ and L → 2⁻ᴹ·L.
fn scaling_time_scales_the_estimates<T: Scalar>() {
    let signal = |t: f64| (3.0 * t).sin() + (17.0 * t).cos() * 0.125;
    let fast = rates::<T>(RobustExact::third_order(real(16.0)).unwrap(), 0.125, 100, signal);
    let slow =
        rates::<T>(RobustExact::third_order(real(1.0)).unwrap(), 0.25, 100, |t| signal(t / 2.0));
    assert!(fast.into_iter().zip(slow).all(|(fast, slow)| fast == slow * real(2.0)));
}

/// A ramp from rest: ζ = (|e|^½·sgn e, ė) obeys ζ̇ = |e|^(−½)·A·ζ, so with AᵀP + PA = −1 and V = ζᵀPζ, V̇ ≤ −γ·√V with γ = √λ_min(P)/λ_max(P), and V
/// reaches 0 within 2·√V(0)/γ (Moreno and Osorio). The scheme lags by a period at each end.
#[test]
fn a_ramp_is_caught_within_the_time_of_the_lyapunov_function() {
    // The entries of AᵀP + PA = −1 for A = [−λ₀/2, 1/2; −λ₁, 0], solved by hand; L = 1.
    let (a, b) = (1.5 / 2.0, 1.1);
    // −2a·p − 2b·r = −1, p/2 − a·r − b·q = 0, r = −1.
    let r = -1.0;
    let p = (1.0 - 2.0 * b * r) / (2.0 * a);
    let q = (p / 2.0 - a * r) / b;
    let half = ((p - q) / 2.0_f64).hypot(r);
    let (least, largest) = ((p + q) / 2.0 - half, (p + q) / 2.0 + half);
    assert!(least > 0.0);
    for slope in [0.1, 1.0, 10.0] {
        let h = 0.01;
        let time = 2.0 * f64::sqrt(q) * slope * largest / f64::sqrt(least);
        let rates =
            rates(RobustExact::first_order(1.0).unwrap(), h, (time / h) as u32 + 200, |t| {
                slope * t
            });
        let caught = rates.iter().rposition(|rate| (rate - slope).abs() > 1e-9).unwrap();
        assert!(caught as f64 * h <= time + 2.0 * h, "{slope}: {caught} after {time}");
    }
}

/// Lⁱᐟᴹ·ε⁽ᴹ⁻ⁱ⁾ᐟᴹ: in the rate √ε for first order, ε^(2/3) for second. The period is short enough to leave h^M·L far below ε.
#[test]
fn noise_leaves_an_error_of_the_stated_order() {
    fn error<const M: usize>(source: RobustExact<f64, M>, noise: f64, h: f64) -> f64 {
        let mut rng = rng();
        let shaken: Vec<f64> = (0..(30.0 / h) as u32)
            .map(|k| (f64::from(k) * h).sin() + noise * rng.random_range(-1.0..1.0))
            .collect();
        let z = run(source, h, shaken.len() as u32, |k| shaken[k as usize]);
        // The start is caught within 10 s.
        peak(z.iter().enumerate().skip(z.len() / 3).map(|(k, z)| z[1] - (k as f64 * h).cos()))
    }
    // Four decades of noise, at periods that scale with it as homogeneity has it would be an identity; here the period stays.
    let h = 2e-4;
    let slope = |large: f64, small: f64| (large / small).log10() / 2.0;
    let first = |noise| error(RobustExact::first_order(1.0).unwrap(), noise, h);
    let order = slope(first(1e-2), first(1e-4));
    assert!((0.4..0.6).contains(&order), "{order}");
    let second = |noise| error(RobustExact::second_order(1.0).unwrap(), noise, h);
    let order = slope(second(1e-2), second(1e-4));
    assert!((0.57..0.77).contains(&order), "{order}");
}

/// The explicit Euler scheme of first order.
fn explicit(bound: f64, h: f64, samples: u32, signal: impl Fn(f64) -> f64) -> Vec<f64> {
    let (mut z0, mut z1) = (signal(0.0), 0.0);
    let mut next = |k: u32| {
        let e = z0 - signal(f64::from(k) * h);
        z0 += h * (z1 - 1.5 * (bound * e.abs()).sqrt() * e.signum());
        z1 -= h * 1.1 * bound * e.signum();
        z1
    };
    (0..samples).map(&mut next).collect()
}

/// A bound a hundred times too large leaves every estimate as it was, up to rounding, and the total variation that of the derivative. The
/// explicit scheme chatters by 1.1·L·h a sample.
#[test]
fn gains_far_too_large_do_not_chatter() {
    let (h, samples) = (0.01, 2000);
    let late = |rates: Vec<f64>| TotalVariation::of(rates.into_iter().skip(1000)).unwrap();
    let true_one = TotalVariation::of((1000..samples).map(|k| (f64::from(k) * h).cos())).unwrap();
    for bound in [2.0, 200.0, 2e6] {
        let variation = late(rates(RobustExact::first_order(bound).unwrap(), h, samples, f64::sin));
        assert!(
            (0.999..1.001).contains(&(variation / true_one)),
            "{bound}: {variation}, {true_one}"
        );
        // Backward differences of second order differ from the derivative by h²/3.
        let variation =
            late(rates(RobustExact::second_order(bound).unwrap(), h, samples, f64::sin));
        assert!(
            (0.999..1.001).contains(&(variation / true_one)),
            "{bound}: {variation}, {true_one}"
        );
        let chattering = late(explicit(bound, h, samples, f64::sin));
        assert!(chattering > 0.5 * 1.1 * bound * h * 1000.0);
    }
}

/// In the sliding mode the first order is the backward difference, whatever its gains.
#[test]
fn in_the_sliding_mode_first_order_is_the_backward_difference() {
    let difference = rates(BackwardDifference::new(), 0.01, 1000, f64::sin);
    for bound in [2.0, 200.0] {
        let exact = rates(RobustExact::first_order(bound).unwrap(), 0.01, 1000, f64::sin);
        for (one, other) in exact.into_iter().zip(&difference).skip(300) {
            assert_abs_diff_eq!(one, *other, epsilon = 1e-12);
        }
    }
}

/// An error (0, e₁, e₂) that slides becomes −e₁/2 + h·e₂/4 in the rate: what follows at the next period shrinks by ½·|ρ − 1|.
#[test]
fn under_varying_periods_second_order_shrinks_as_stated() {
    for ratio in [0.5, 1.5, 2.5] {
        let mut source = RobustExact::second_order(1e9).unwrap();
        let mut h = 1.0;
        source.update(0.0, h).unwrap();
        source.update(1.0, h).unwrap();
        source.update(0.0, h).unwrap();
        let mut size = source.update(0.0, h).unwrap();
        // Constant so far: the polynomial through the last three samples.
        assert_abs_diff_eq!(size, 0.5, epsilon = 1e-12);
        size = source.estimates().unwrap()[2];
        for _ in 0..5 {
            let last = h;
            h *= ratio;
            source.update(0.0, h).unwrap();
            let now = source.estimates().unwrap()[2];
            // e₂ is that of (1, 2)·c in (e₁, h·e₂).
            assert_abs_diff_eq!(now * h, size * last * 0.5 * (ratio - 1.0), epsilon = 1e-9);
            size = now;
        }
    }
}

fn a_bound_out_of_range_is_refused<T: Scalar>() {
    let attempts = |bad: f64| {
        let bad = real::<T>(bad);
        [
            RobustExact::first_order(bad).unwrap_err(),
            RobustExact::second_order(bad).unwrap_err(),
            RobustExact::third_order(bad).unwrap_err(),
        ]
    };
    for bad in [0.0, -1.0] {
        let refused = Error::NotPositive { name: "bound on the rate", value: bad };
        assert!(attempts(bad).iter().all(|error| *error == refused));
    }
    for bad in NOT_FINITE {
        assert!(
            attempts(bad)
                .iter()
                .all(|error| matches!(error, Error::NonFinite { name: "bound on the rate", .. }))
        );
    }
}

/// A period so short that hⁿ is no number any more.
#[test]
fn a_period_below_the_range_of_the_scalar_is_refused() {
    let mut source = RobustExact::<f32, 4>::third_order(1.0).unwrap();
    source.update(0.0, 0.1).unwrap();
    let before = source;
    assert!(matches!(source.update(1.0, 1e-30), Err(Error::NonFinite { name: "y/dt^n", .. })));
    assert_eq!(source, before);
}
