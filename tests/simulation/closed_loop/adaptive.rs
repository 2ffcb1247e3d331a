//! Adaptive methods between samples, and jumps between them.

use brunovsky::{
    Error, Scalar,
    integrators::{Adaptive, DormandPrince, Heun, Integrator, Propagator, Rk4, Rodas, Tolerance},
    plant::{IntegratorChain, Pendulum, Plant, Uncertain},
    simulation::Simulation,
};
use nalgebra::SVector;

use super::{Scripted, idle};
use crate::{at_f32_and_f64, num};

fn within<M, T: Scalar>(method: M, tolerance: f64) -> Adaptive<M, T, 2>
where
    Adaptive<M, T, 2>: Propagator<T, 2>,
    M: brunovsky::integrators::Embedded<T, 2>,
{
    Adaptive::new(method, Tolerance::new(num(tolerance), num(tolerance)).unwrap())
}

/// Δ = 3 from a switch on that is no sampling instant: from there x₂ = 3·τ and x₁ = 1.5·τ², and before it nothing moves.
fn end<I: Propagator<T, 2>, T: Scalar>(integrator: I, declared: &[T]) -> SVector<T, 2> {
    let switch = num::<T>(0.709);
    let plant = Uncertain::matched(IntegratorChain::<T, 2>::new(), move |t: T, _: &_, _: &_| {
        if t >= switch { num(3.0) } else { T::zero() }
    });
    let simulation = Simulation::new(&plant, idle(), |t| t, [T::zero(); 2], num(0.25)).unwrap();
    let simulation = simulation.integrator(integrator).discontinuities(declared).unwrap();
    simulation.until(num(2.0)).unwrap().last().unwrap().unwrap().x
}

/// Rk4 is exact for constants, so with the jump declared only rounding is left; undeclared it is smeared over a substep of 0.025 s.
fn a_switch_between_samples_is_not_smeared<T: Scalar>() {
    let tau = num::<T>(2.0) - num(0.709);
    let expected = SVector::from([num::<T>(1.5) * tau * tau, num::<T>(3.0) * tau]);
    let rounding = T::default_epsilon() * num(300.0);
    let declared = [num(0.709)];
    approx::assert_abs_diff_eq!(end(Rk4, &declared), expected, epsilon = rounding);
    approx::assert_abs_diff_eq!(end(Heun, &declared), expected, epsilon = rounding);
    let adaptive = end(within(DormandPrince, 1e-4), &declared);
    approx::assert_abs_diff_eq!(adaptive, expected, epsilon = rounding);
    assert!((end(Rk4, &[]) - expected).amax() > num(1e-3));
}

at_f32_and_f64! {
    a_declared_switch_between_samples_acts_from_there_on => a_switch_between_samples_is_not_smeared,
}

/// A pendulum under a disturbance that changes twice between samples.
fn disturbed<I: Propagator<f64, 2>>(
    integrator: I,
    substeps: u32,
    declared: &[f64],
) -> SVector<f64, 2> {
    let pendulum = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    let plant =
        Uncertain::matched(
            pendulum,
            |t: f64, _: &_, _: &_| {
                if (0.31..0.47).contains(&t) { 5.0 } else { (3.0 * t).sin() }
            },
        );
    let script = Scripted::new(|k: usize| SVector::from([(k as f64).cos()]));
    let simulation = Simulation::new(&plant, script, |t| t, [-0.5, 2.0], 0.25).unwrap();
    let simulation = simulation.integrator(integrator).substeps(substeps).unwrap();
    let simulation = simulation.discontinuities(declared).unwrap();
    simulation.until(1.0).unwrap().last().unwrap().unwrap().x
}

const JUMPS: [f64; 2] = [0.31, 0.47];

/// The exponent of the error over a factor of 16 in the substeps.
fn order<I: Integrator + Copy>(method: I, declared: &[f64]) -> f64 {
    let exact = disturbed(Rk4, 4000, &JUMPS);
    let error = |substeps| (disturbed(method, substeps, declared) - exact).norm();
    (error(8) / error(128)).log2() / 4.0
}

/// A smeared jump errs by the part of a substep that it is off, which falls like the substep with chance in it.
#[test]
fn methods_keep_their_order_across_declared_jumps_and_lose_it_across_others() {
    for (declared, stated) in [(order(Rk4, &JUMPS), 4.0), (order(Heun, &JUMPS), 2.0)] {
        assert!((declared - stated).abs() < 0.15, "order {declared}, stated {stated}");
    }
    let smeared = order(Rk4, &[]);
    assert!(smeared < 2.0, "{smeared}");
}

#[test]
fn adaptive_methods_agree_with_many_equal_steps() {
    let exact = disturbed(Rk4, 4000, &JUMPS);
    let explicit = disturbed(within(DormandPrince, 1e-9), 10, &JUMPS);
    approx::assert_abs_diff_eq!(explicit, exact, epsilon = 1e-7);
    let stiff = disturbed(within(Rodas::new(), 1e-9), 10, &JUMPS);
    approx::assert_abs_diff_eq!(stiff, exact, epsilon = 1e-7);
}

/// x₁ driven by an actuator x₂ with a lag of 10 µs, under a period of 10 ms.
struct Lag;

impl Plant<2, 1> for Lag {
    type Scalar = f64;

    fn derivative(&self, _t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>) -> SVector<f64, 2> {
        SVector::from([x[1] - x[0], (u[0] - x[1]) * 1e5])
    }
}

/// Under u = 1 from the first sample: x₂ is 1 at once, and x₁ = 1 − e^−(t − τ) but for a delay of τ = 10 µs or so. RODAS takes this in its
/// stride, where ten substeps of Rk4 diverge.
#[test]
fn a_stiff_actuator_is_no_hindrance() {
    let run = || {
        let script = Scripted::new(|_| SVector::from([1.0]));
        Simulation::new(&Lag, script, |t| t, [0.0, 0.0], 0.01).unwrap()
    };
    let samples = run().integrator(within(Rodas::new(), 1e-6)).until(1.0).unwrap();
    for sample in samples {
        let sample = sample.unwrap();
        approx::assert_abs_diff_eq!(sample.x[0], 1.0 - (-sample.t).exp(), epsilon = 2e-5);
    }
    assert!(run().until(1.0).unwrap().any(|sample| sample.is_err()));
}

/// What happens in a period depends on its first state and its input, so a run that goes on is a run that starts anew, but for the rounding
/// of other times. A step size remembered from the period before would change the error, which is some 10⁻⁶.
#[test]
fn every_period_starts_anew() {
    let plant = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    let method = within(DormandPrince, 1e-6);
    let run = |x0: [f64; 2]| {
        let simulation = Simulation::new(&plant, idle(), |t| t, x0, 0.25).unwrap();
        simulation.integrator(method)
    };
    let samples = run([1.0, 0.0]).take(10).collect::<Result<Vec<_>, _>>().unwrap();
    let rest = run(samples[4].x.into()).take(6).collect::<Result<Vec<_>, _>>().unwrap();
    for (sample, again) in samples[4..].iter().zip(&rest) {
        approx::assert_abs_diff_eq!(sample.x, again.x, epsilon = 1e-12);
    }
}

/// Evaluations of a pendulum in a second of 100 periods, with the one that measures ẋ at each of the 101 samples.
fn evaluations(integrator: impl Propagator<f64, 2>) -> (u32, SVector<f64, 2>) {
    let count = core::cell::Cell::new(0);
    let pendulum = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    let plant = Uncertain::matched(pendulum, |t: f64, _: &_, _: &_| {
        count.set(count.get() + 1);
        (3.0 * t).sin()
    });
    let simulation = Simulation::new(&plant, idle(), |t| t, [-0.5, 2.0], 0.01).unwrap();
    let end = simulation.integrator(integrator).until(1.0).unwrap().last().unwrap().unwrap().x;
    (count.get(), end)
}

/// Told to try a whole period at once, where that is within the tolerance, it evaluates the plant seven times, not forty.
#[test]
fn a_short_period_takes_one_step() {
    let (fixed, exact) = evaluations(Rk4);
    assert_eq!(fixed, 100 * 40 + 101);
    let (adaptive, end) = evaluations(within(DormandPrince, 1e-8).with_first_step(0.01).unwrap());
    assert_eq!(adaptive, 100 * 7 + 101);
    approx::assert_abs_diff_eq!(end, exact, epsilon = 1e-7);
}

#[test]
fn jumps_that_are_no_times_or_out_of_order_are_refused() {
    let chain = IntegratorChain::<f64, 2>::new();
    let refused = |times: &'static [f64]| {
        let simulation = Simulation::new(&chain, idle(), |t| t, [0.0; 2], 0.25).unwrap();
        simulation.discontinuities(times).err()
    };
    let falling = Error::NotBelow { name: "discontinuity", value: 2.0, limit: 2.0 };
    assert_eq!(refused(&[1.0, 2.0, 2.0]), Some(falling));
    assert!(matches!(refused(&[f64::NAN]), Some(Error::NonFinite { name: "discontinuity", .. })));
}

/// The default is what it always was: ten steps of Rk4 from k·dt, over dt, with f as it is before the next sample, bit for bit; and a jump
/// declared at a sampling instant changes nothing.
#[test]
fn the_default_is_ten_steps_of_rk4() {
    let pendulum = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    let plant = Uncertain::matched(pendulum, |t: f64, _: &_, _: &_| (3.0 * t).sin());
    let script = |k: usize| SVector::from([(k as f64).cos()]);
    let (dt, jumps) = (0.1, [3.0 * 0.1]);
    let run = || Simulation::new(&plant, Scripted::new(script), |t| t, [-0.5, 2.0], dt).unwrap();
    let declared = run().discontinuities(&jumps).unwrap();
    let mut x = SVector::from([-0.5, 2.0]);
    for (k, (sample, again)) in run().zip(declared).take(40).enumerate() {
        let sample = sample.unwrap();
        if k > 0 {
            let before = k as f64 * dt * (1.0 - f64::EPSILON);
            let u = script(k - 1);
            let f = |t: f64, x: &SVector<f64, 2>| plant.derivative(t.min(before), x, &u);
            x = Rk4.integrate(f, (k - 1) as f64 * dt, &x, dt, 10).unwrap();
        }
        assert_eq!(sample.x, x);
        assert_eq!(again.unwrap(), sample);
    }
}
