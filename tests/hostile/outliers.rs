//! One finite outlier, of any size and anywhere in a call, silences nothing: whether it is refused or not, the calls after it are answered.

use core::fmt::Debug;

use brunovsky::{
    controller::{
        AntiWindup, Clelc, Controller, Decoupling, FeedbackLinearization, Gains, Measurement,
        ModelReferenceAdaptive, Pid, PidGains, Reference, StateRegressor,
        unicycle::{Direction, Standstill, UnicycleController},
    },
    fuzzy::FuzzyNetwork,
    learning::{
        BackwardDifference, ErrorRate, FilteredDifference, Measured, ModelAided, NeuroFuzzy,
        SlidingMode,
    },
    plant::{FeedbackLinearizable, IntegratorChain, Link, TwoLinkArm, VanDerPol},
};

use crate::driver::Float;

fn num<T: Float>(value: f64) -> T {
    nalgebra::convert(value)
}

/// Puts powers of two of either sign into each of the numbers of a call, all of them near the end of the range and every 16th below: `call` makes
/// one with the given numbers.
fn answers_after_an_outlier<T: Float, C: Clone, A: Debug, const M: usize>(
    fresh: &C,
    call: impl Fn(&mut C, [T; M]) -> Result<A, brunovsky::Error>,
) {
    let good: [T; M] = core::array::from_fn(|i| num((1.0 + i as f64).sin()));
    let most = T::max_value().unwrap();
    let mut size = most;
    while size > T::zero() {
        for (place, outlier) in (0..M).flat_map(|place| [(place, size), (place, -size)]) {
            for samples_before in [0, 2] {
                let mut controller = fresh.clone();
                for _ in 0..samples_before {
                    call(&mut controller, good).unwrap();
                }
                let mut numbers = good;
                numbers[place] = outlier;
                let answer = call(&mut controller, numbers);
                for _ in 0..3 {
                    let after = call(&mut controller, good);
                    assert!(after.is_ok(), "{after:?} after {outlier:?} at {place}: {answer:?}");
                }
            }
        }
        size *= num(if size > most * num(2.0_f64.powi(-32)) { 0.5 } else { 2.0_f64.powi(-16) });
    }
}

type Learning<P, T, E> = Clelc<P, NeuroFuzzy<FuzzyNetwork<T, 2, 3>, E, SlidingMode<T>>, 2>;

fn clelc<P, T: Float, E>(model: P, source: E) -> Learning<P, T, E>
where
    P: FeedbackLinearizable<2, Scalar = T>,
    E: ErrorRate<T, 2> + Clone,
{
    let base = FeedbackLinearization::new(model, Gains::from_lambda(num(2.0)).unwrap());
    let network = FuzzyNetwork::evenly_spaced([T::one(), T::one()]).unwrap();
    Clelc::new(base, NeuroFuzzy::new(network, source, SlidingMode::new(num(5.0)).unwrap()))
}

/// 5 Hz to 1 kHz.
const PERIODS: [f64; 2] = [0.2, 0.001];

fn of_a_chain<T: Float, E: ErrorRate<T, 2> + Clone>(source: E) {
    let fresh = clelc(VanDerPol::new(num(0.5)).unwrap(), source);
    for dt in PERIODS {
        answers_after_an_outlier(&fresh, |controller, numbers: [T; 8]| {
            let [x1, x2, v, a, u, r1, r2, r3] = numbers;
            let measurement = Measurement::new([x1, x2]).with_rate([v, a]).with_applied([u]);
            controller.update(&measurement, &Reference::new([r1, r2], r3), num(dt))
        });
        // Without a report of what was applied, it is the command that is remembered.
        answers_after_an_outlier(&fresh, |controller, numbers: [T; 7]| {
            let [x1, x2, v, a, r1, r2, r3] = numbers;
            let measurement = Measurement::new([x1, x2]).with_rate([v, a]);
            controller.update(&measurement, &Reference::new([r1, r2], r3), num(dt))
        });
    }
}

fn of_several_chains<T: Float, C>(fresh: &C)
where
    C: Controller<4, 2, Scalar = T, Reference = [Reference<T, 2>; 2], Command: Debug> + Clone,
{
    for (dt, reported) in PERIODS.into_iter().flat_map(|dt| [(dt, false), (dt, true)]) {
        answers_after_an_outlier(fresh, |controller, numbers: [T; 16]| {
            let [x1, x2, x3, x4, v1, v2, v3, v4, u1, u2, r1, r2, r3, q1, q2, q3] = numbers;
            let mut measurement = Measurement::new([x1, x2, x3, x4]).with_rate([v1, v2, v3, v4]);
            if reported {
                measurement = measurement.with_applied([u1, u2]);
            }
            let reference = [Reference::new([r1, r2], r3), Reference::new([q1, q2], q3)];
            controller.update(&measurement, &reference, num(dt))
        });
    }
}

fn of_the_arm<T: Float, E: ErrorRate<T, 2> + Clone>(source: E) {
    let link = Link { mass: num(2.0), length: num(1.0), centre: num(0.4), inertia: num(0.1) };
    let arm = TwoLinkArm::new([link; 2], [num(0.3); 2], num(9.81)).unwrap();
    let chain = clelc(IntegratorChain::new(), source);
    of_several_chains(&Decoupling::new(arm, [chain.clone(), chain]));
}

fn of_the_unicycle<T: Float, E: ErrorRate<T, 2> + Clone>(source: E) {
    let axis = clelc(IntegratorChain::new(), source);
    let axes = [axis.clone(), axis];
    let hold = Standstill::Hold;
    of_several_chains(&UnicycleController::new(axes, Direction::Forward, num(0.05), hold).unwrap());
}

fn of_a_second_order<T: Float, C>(fresh: &C)
where
    C: Controller<2, 1, Scalar = T, Reference = Reference<T, 2>, Command: Debug> + Clone,
{
    for (dt, reported) in PERIODS.into_iter().flat_map(|dt| [(dt, false), (dt, true)]) {
        answers_after_an_outlier(fresh, |controller, numbers: [T; 6]| {
            let [x1, x2, u, r1, r2, r3] = numbers;
            let mut measurement = Measurement::new([x1, x2]);
            if reported {
                measurement = measurement.with_applied([u]);
            }
            controller.update(&measurement, &Reference::new([r1, r2], r3), num(dt))
        });
    }
}

fn of_the_pid<T: Float>() {
    let gains = PidGains::parallel(num::<T>(3.0), num(2.0), num(0.5), num(0.02)).unwrap();
    for anti_windup in [
        AntiWindup::None,
        AntiWindup::BackCalculation { tracking_time: num(0.5) },
        AntiWindup::Conditional { tolerance: num(0.1) },
    ] {
        of_a_second_order(&Pid::<T, 2>::new(gains, anti_windup).unwrap());
    }
}

fn of_an_adaptive<T: Float>() {
    let model = VanDerPol::new(num::<T>(0.5)).unwrap();
    let base = FeedbackLinearization::new(model, Gains::from_lambda(num(2.0)).unwrap());
    let fresh =
        ModelReferenceAdaptive::new(base, StateRegressor, num(5.0), [T::one(), T::one()]).unwrap();
    of_a_second_order(&fresh);
    let range = [num(0.2), num(5.0)];
    of_a_second_order(&fresh.with_unknown_effectiveness(num(2.0), range).unwrap());
}

#[test]
fn a_pid_controller_answers_after_an_outlier() {
    of_the_pid::<f32>();
    of_the_pid::<f64>();
}

#[test]
fn an_adaptive_controller_answers_after_an_outlier() {
    of_an_adaptive::<f32>();
    of_an_adaptive::<f64>();
}

macro_rules! sources {
    ($($name:ident: $source:expr),+ $(,)?) => {
        $(mod $name {
            use super::*;

            #[test]
            fn answers_after_an_outlier_of_a_chain() {
                of_a_chain::<f32, _>($source);
                of_a_chain::<f64, _>($source);
            }

            #[test]
            fn answers_after_an_outlier_of_the_arm() {
                of_the_arm::<f32, _>($source);
                of_the_arm::<f64, _>($source);
            }

            #[test]
            fn answers_after_an_outlier_of_the_unicycle() {
                of_the_unicycle::<f32, _>($source);
                of_the_unicycle::<f64, _>($source);
            }
        })+
    };
}

sources! {
    measured: Measured,
    backward_difference: BackwardDifference::new(),
    filtered_difference: FilteredDifference::new(num(0.05)).unwrap(),
    model_aided: ModelAided::new(),
}
