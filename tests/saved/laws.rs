//! Control laws beside CLELC, and the networks and rules that it learns with beside its own.

use brunovsky::{
    channel::Saturation,
    controller::{
        ActiveDisturbanceRejection, AntiWindup, Backstepping, Compensated, Gains, Leakage, Limited,
        ModelReferenceAdaptive, Pid, PidGains, Projection, StateFeedback, StateRegressor,
        sliding_mode::{
            IntegralSlidingMode, SlidingModeControl, SlidingSurface, Stepping, SuperTwisting,
            SuperTwistingGains,
        },
    },
    fuzzy::{FuzzyNetwork, IntervalNetwork, TriangularNetwork, TypeReduction},
    learning::{
        AdaptiveSlidingMode, FeedbackError, Fixed, ModelAided, NeuroFuzzy, RecursiveLeastSquares,
        Switching,
    },
    nalgebra::{SMatrix, SVector},
    plant::Pendulum,
};

use crate::{
    controllers::{clelc_goes_on, pendulum, rule},
    support::{Number, goes_on, num, reference},
};

in_both_precisions! {
    pid_goes_on_with_every_anti_windup,
    state_feedback_goes_on,
    adaptive_control_goes_on_with_every_modification,
    backstepping_goes_on,
    sliding_mode_control_goes_on_with_every_sign,
    super_twisting_goes_on_with_both_steppings,
    active_disturbance_rejection_goes_on,
    what_a_compensator_was_added_to_goes_on,
    recursive_least_squares_go_on,
    sliding_modes_that_adapt_go_on,
    interval_networks_go_on,
}

fn model<T: Number>() -> Pendulum<T> {
    *pendulum().model()
}

fn gains<T: Number>() -> Gains<T, 2> {
    Gains::from_lambda(num(3.0)).unwrap()
}

fn surface<T: Number>() -> SlidingSurface<T, 2> {
    SlidingSurface::new(Gains::new([num::<T>(2.0)]).unwrap())
}

/// An actuator that does not give all that is asked for.
fn actuator<T: Number>() -> Saturation<T, 1> {
    Saturation::symmetric([num::<T>(4.0)]).unwrap()
}

fn pid<T: Number>(anti_windup: AntiWindup<T>) -> Pid<T, 2> {
    let gains = PidGains::parallel(num(9.0), num(4.0), num(2.0), num(0.07)).unwrap();
    Pid::new(gains.with_weights(num(0.8), num(0.1)).unwrap(), anti_windup).unwrap()
}

fn pid_goes_on_with_every_anti_windup<T: Number>() {
    for anti_windup in [
        AntiWindup::None,
        AntiWindup::BackCalculation { tracking_time: num(0.5) },
        AntiWindup::Conditional { tolerance: num(0.1) },
    ] {
        let mut pid = pid::<T>(anti_windup);
        for start in [None, Some(num(0.7))] {
            start.map_or(Ok(()), |u| pid.start_at(u)).unwrap();
            // The start that is asked for last is forgotten by a reset, as by a sample.
            goes_on(Limited::new(pid, actuator()), |k| reference(k, 0.0));
        }
    }
}

fn state_feedback_goes_on<T: Number>() {
    let gain = SMatrix::<T, 1, 2>::new(num(7.3), num(1.9));
    goes_on(StateFeedback::new(gain, [num::<T>(0.4)]).unwrap(), |k| reference::<T, 2>(k, 0.0).r);
}

fn adaptive_control_goes_on_with_every_modification<T: Number>() {
    let new = || {
        let q = [num::<T>(1.3), num(0.7)];
        ModelReferenceAdaptive::new(pendulum::<T>(), StateRegressor, num(5.0), q).unwrap()
    };
    let whole = new().with_unknown_effectiveness(num(2.0), [num(0.5), num(1.2)]).unwrap();
    let ball = Projection::Ball { radius: num(0.9) };
    let (lower, upper) = (SVector::from([num(-0.3), num(0.1)]), SVector::from([num(0.4); 2]));
    let sides = Projection::Box { lower, upper };
    for adaptive in [
        new(),
        new().with_leakage(Leakage::Sigma { sigma: num(0.2) }).unwrap(),
        whole.with_leakage(Leakage::Error { sigma: num(0.2) }).unwrap(),
        new().with_projection(ball).unwrap().with_parameters([num(3.0), num(4.0)]).unwrap(),
        whole.with_projection(sides).unwrap().with_model_at([num(0.2), num(0.1)]).unwrap(),
    ] {
        goes_on(adaptive, |k| reference(k, 0.0));
    }
}

fn backstepping_goes_on<T: Number>() {
    let backstepping = Backstepping::new(model::<T>(), [num(2.1), num(3.3)]).unwrap();
    goes_on(backstepping, |k| reference(k, 0.0));
}

fn sliding_mode_control_goes_on_with_every_sign<T: Number>() {
    let delta = num::<T>(0.3);
    let new = || SlidingModeControl::new(model::<T>(), surface(), num(4.0)).unwrap();
    for sliding in [
        new(),
        new().with_switching(Switching::Implicit { delta }).unwrap(),
        new().with_switching(Switching::Explicit { delta }).unwrap(),
        new().with_saturation(delta).unwrap(),
    ] {
        goes_on(sliding, |k| reference(k, 0.0));
    }
}

fn super_twisting_goes_on_with_both_steppings<T: Number>() {
    for stepping in [Stepping::Explicit, Stepping::Implicit] {
        let gains = SuperTwistingGains::for_rate(num(2.0)).unwrap();
        let surface = SlidingSurface::from_lambda(num(2.0)).unwrap();
        let twisting = SuperTwisting::new(model::<T>(), surface, gains).with_stepping(stepping);
        goes_on(Limited::new(twisting, actuator()), |k| reference(k, 0.0));
    }
}

fn active_disturbance_rejection_goes_on<T: Number>() {
    let rejection = ActiveDisturbanceRejection::new(gains::<T>(), num(12.0), num(3.1)).unwrap();
    goes_on(rejection, |k| reference(k, 0.0));
}

fn what_a_compensator_was_added_to_goes_on<T: Number>() {
    let delta = num::<T>(0.02);
    for switching in [Switching::SetValued, Switching::Explicit { delta }] {
        let integral = IntegralSlidingMode::new(num(3.0)).unwrap();
        let integral = integral.with_switching(switching).unwrap();
        let base = pid(AntiWindup::Conditional { tolerance: num(0.0) });
        let compensated = Compensated::new(base, model::<T>(), integral);
        goes_on(Limited::new(compensated, actuator()), |k| reference(k, 0.0));
    }
}

fn recursive_least_squares_go_on<T: Number>() {
    let network = TriangularNetwork::<T, 2, 3>::evenly_spaced([num(1.0), num(2.0)]).unwrap();
    let rule = RecursiveLeastSquares::<T, 2, 3>::new(num(50.0)).unwrap();
    for rule in [rule, rule.with_memory(num(0.1)).unwrap()] {
        clelc_goes_on::<T, _>(NeuroFuzzy::new(network, FeedbackError, rule));
    }
}

fn sliding_modes_that_adapt_go_on<T: Number>() {
    let network = FuzzyNetwork::<T, 2, 3>::evenly_spaced([num(1.0), num(2.0)]).unwrap();
    let adaptive = AdaptiveSlidingMode::new(rule::<T>(), num(20.0), num(0.1)).unwrap();
    for rule in [adaptive, adaptive.with_ceiling(num(7.5)).unwrap()] {
        clelc_goes_on::<T, _>(NeuroFuzzy::new(network, ModelAided::new(), rule));
    }
}

fn interval_networks_go_on<T: Number>() {
    let (ranges, rule) = ([num::<T>(1.0), num(2.0)], rule::<T>().with_antecedents(Fixed));
    for reduction in [TypeReduction::NieTan, TypeReduction::Bmm { m: num(0.3) }] {
        let network = IntervalNetwork::<_, T, 2, 3>::gaussian(ranges, num(0.3), reduction).unwrap();
        clelc_goes_on::<T, _>(NeuroFuzzy::new(network, ModelAided::new(), rule));
        let exponents = [num(0.7), num(1.6)];
        let network =
            IntervalNetwork::<_, T, 2, 3>::elliptic(ranges, exponents, reduction).unwrap();
        clelc_goes_on::<T, _>(NeuroFuzzy::new(network, ModelAided::new(), rule));
    }
}
