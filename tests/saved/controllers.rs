use std::fmt::Debug;

use brunovsky::{
    channel::{RateLimit, Saturation},
    controller::{
        Clelc, Controller, Decoupling, FeedbackLinearization, Gains, Limited, Mode, Padded,
        Supervised,
        unicycle::{Direction, Standstill, UnicycleController},
    },
    differentiator::{
        BackwardDifference, Differentiator, FilteredDifference, HighGain, RobustExact, Tracking,
    },
    fuzzy::FuzzyNetwork,
    learning::{
        AdaptationRule, Bounded, Compensator, Conditional, ErrorRate, Fixed, GradientDescent,
        Guarded, LearningMode, Measured, ModelAided, NeuroFuzzy, NullCompensator, NullRule,
        OfState, Redundant, SlidingMode, Switching, Watchdog,
    },
    plant::{
        DcMotor, FlexibleJoint, IntegratorChain, Linearized, Link, MotorDrivenLink, Pendulum,
        ThirdOrder, TwoLinkArm, VanDerPol,
    },
};
use serde::{Serialize, de::DeserializeOwned};

use crate::support::{Number, goes_on, num, reference};

in_both_precisions! {
    feedback_linearization_goes_on,
    clelc_goes_on_with_every_source_of_the_error_rate,
    clelc_goes_on_with_every_differentiator,
    clelc_goes_on_with_every_rule,
    networks_of_other_sizes_go_on,
    what_was_derived_by_differentiation_goes_on,
    a_guarded_learner_goes_on_before_and_after_it_falls_back,
    decoupling_goes_on,
    the_unicycle_goes_on,
    what_stands_behind_an_actuator_goes_on,
    what_an_operator_supervises_goes_on,
}

/// What every part of a controller under test can do.
pub trait Part: Clone + Serialize + DeserializeOwned + PartialEq + Debug {}

impl<P: Clone + Serialize + DeserializeOwned + PartialEq + Debug> Part for P {}

pub fn pendulum<T: Number>() -> FeedbackLinearization<Pendulum<T>, 2> {
    let pendulum = Pendulum::new(num(1.3), num(0.5), num(0.1), num(9.81)).unwrap();
    FeedbackLinearization::new(pendulum, Gains::from_lambda(num(3.0)).unwrap())
}

fn chain<T: Number>() -> FeedbackLinearization<IntegratorChain<T, 2>, 2> {
    FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(num(1.1)).unwrap())
}

pub fn rule<T: Number>() -> SlidingMode<T> {
    SlidingMode::new(num(7.0)).unwrap()
}

fn neuro_fuzzy<T: Number, E: ErrorRate<T, 2>, R: AdaptationRule<FuzzyNetwork<T, 2, 3>>>(
    error_rate: E,
    rule: R,
) -> NeuroFuzzy<FuzzyNetwork<T, 2, 3>, E, R> {
    let network = FuzzyNetwork::evenly_spaced([num(1.0), num(2.0)]).unwrap();
    NeuroFuzzy::new(network, error_rate, rule)
}

fn learner<T: Number>() -> NeuroFuzzy<FuzzyNetwork<T, 2, 3>, ModelAided<T>, SlidingMode<T>> {
    neuro_fuzzy(ModelAided::new(), rule())
}

pub fn clelc_goes_on<T: Number, C: Compensator<T, 2> + Part>(compensator: C) {
    goes_on(Clelc::new(pendulum::<T>(), compensator), |k| reference(k, 0.0));
}

fn feedback_linearization_goes_on<T: Number>() {
    goes_on(pendulum::<T>(), |k| reference(k, 0.0));
    let gains = Gains::from_lambda(num(2.0)).unwrap();
    goes_on(FeedbackLinearization::new(ThirdOrder::<T>::new(), gains), |k| reference(k, 0.3));
    let gains = Gains::from_lambda(num(2.0)).unwrap();
    let oscillator = VanDerPol::<T>::new(num(0.7)).unwrap();
    goes_on(FeedbackLinearization::new(oscillator, gains), |k| reference(k, 0.3));
}

fn clelc_goes_on_with_every_source_of_the_error_rate<T: Number>() {
    clelc_goes_on::<T, _>(neuro_fuzzy(BackwardDifference::new(), rule()));
    clelc_goes_on::<T, _>(neuro_fuzzy(FilteredDifference::new(num(0.1)).unwrap(), rule()));
    clelc_goes_on::<T, _>(neuro_fuzzy(ModelAided::new(), rule()));
    let redundant = Redundant::new(Measured, BackwardDifference::new());
    clelc_goes_on::<T, _>(neuro_fuzzy(redundant, rule()));
    let conditional = Conditional::new(ModelAided::new(), num(0.1)).unwrap();
    clelc_goes_on::<T, _>(neuro_fuzzy(conditional, rule()));
}

fn clelc_goes_on_with_every_differentiator<T: Number>() {
    fn with<T: Number, D: Differentiator<Scalar = T> + Part>(differentiator: D) {
        clelc_goes_on::<T, _>(neuro_fuzzy(ModelAided::through(differentiator), rule()));
    }
    with(FilteredDifference::new(num::<T>(0.1)).unwrap());
    with(HighGain::first_order(num::<T>(7.0)).unwrap());
    with(HighGain::second_order(num::<T>(7.0)).unwrap());
    with(Tracking::new(num::<T>(30.0), num(0.05)).unwrap());
    with(RobustExact::first_order(num::<T>(3.0)).unwrap());
    with(RobustExact::second_order(num::<T>(3.0)).unwrap());
    with(RobustExact::third_order(num::<T>(3.0)).unwrap());
    let observer = HighGain::first_order(num::<T>(7.0)).unwrap();
    clelc_goes_on::<T, _>(neuro_fuzzy(observer, rule()));
    clelc_goes_on::<T, _>(neuro_fuzzy(OfState::new(observer), rule()));
}

fn networks_of_other_sizes_go_on<T: Number>() {
    let gains = Gains::from_lambda(num(2.0)).unwrap();
    let flc = FeedbackLinearization::new(ThirdOrder::<T>::new(), gains);
    let network = FuzzyNetwork::<T, 3, 5>::evenly_spaced([num(1.0), num(2.0), num(3.0)]).unwrap();
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule()));
    goes_on(clelc, |k| reference(k, 0.0));
    let flc = FeedbackLinearization::new(
        IntegratorChain::<T, 1>::new(),
        Gains::from_lambda(num(2.0)).unwrap(),
    );
    let network = FuzzyNetwork::<T, 1, 40>::evenly_spaced([num(1.0)]).unwrap();
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule()));
    goes_on(clelc, |k| reference(k, 0.0));
}

fn what_was_derived_by_differentiation_goes_on<T: Number>() {
    let gains = Gains::from_lambda(num(2.0)).unwrap();
    let motor = DcMotor { torque: num(0.1), inductance: num(0.025), resistance: num(5.0) };
    let link = MotorDrivenLink::new(num::<T>(0.06), num(0.02), num(2.2), motor).unwrap();
    let model = Linearized::<_, 3, 3, 1>::new(link, [num(0.3), num(0.0), num(0.0)]).unwrap();
    let chain = FeedbackLinearization::new(IntegratorChain::<T, 3>::new(), gains);
    goes_on(Decoupling::new(model, [chain]), |k| [reference(k, 0.0)]);
    let joint = FlexibleJoint::new(num::<T>(0.03), num(0.004), num(31.0), num(0.8)).unwrap();
    let model = Linearized::<_, 4, 4, 1>::new(joint, [num::<T>(0.1); 4]).unwrap();
    let gains = Gains::from_lambda(num(2.0)).unwrap();
    let chain = FeedbackLinearization::new(IntegratorChain::<T, 4>::new(), gains);
    goes_on(Decoupling::new(model, [chain]), |k| [reference(k, 0.0)]);
    // A chain that is shorter than there is room for.
    let pendulum = Pendulum::new(num::<T>(1.3), num(0.5), num(0.1), num(9.81)).unwrap();
    let model = Linearized::<_, 2, 4, 1>::with_degrees(pendulum, [2], [num(0.2), num(0.0)]);
    let chains = [Padded::<_, 2>(Clelc::new(self::chain::<T>(), learner()))];
    goes_on(Decoupling::new(model.unwrap(), chains), |k| [reference(k, 0.0)]);
}

fn clelc_goes_on_with_every_rule<T: Number>() {
    let source = ModelAided::<T>::new;
    for switching in [
        Switching::SetValued,
        Switching::Implicit { delta: num(0.3) },
        Switching::Explicit { delta: num(0.3) },
    ] {
        clelc_goes_on::<T, _>(neuro_fuzzy(source(), rule().with_switching(switching).unwrap()));
    }
    clelc_goes_on::<T, _>(neuro_fuzzy(source(), rule().with_antecedents(Fixed)));
    clelc_goes_on::<T, _>(neuro_fuzzy(source(), GradientDescent::new(num(0.7)).unwrap()));
    let bounded = Bounded::new(rule(), num(1.5)).unwrap();
    clelc_goes_on::<T, _>(neuro_fuzzy(source(), bounded));
    clelc_goes_on::<T, _>(neuro_fuzzy(source(), bounded.with_rate(num(2.0)).unwrap()));
    clelc_goes_on::<T, _>(neuro_fuzzy(source(), NullRule));
    clelc_goes_on::<T, _>(NullCompensator::new(source()));
}

fn a_guarded_learner_goes_on_before_and_after_it_falls_back<T: Number>() {
    for patience in [100.0, 0.1] {
        let certificate = rule().certificate(num(0.02), num(0.5)).unwrap();
        let watchdog = Watchdog::new(certificate, num(0.01), num(patience)).unwrap();
        let guarded = Guarded::new(learner::<T>(), watchdog);
        clelc_goes_on::<T, _>(guarded);
        clelc_goes_on::<T, _>(guarded.with_fallback(num(3.0)).unwrap());
    }
}

fn decoupling_goes_on<T: Number>() {
    let link = |length: f64| Link {
        mass: num(1.5),
        length: num(length),
        centre: num(0.15),
        inertia: num(0.02),
    };
    let arm = TwoLinkArm::new([link(0.4), link(0.3)], [num(0.1); 2], num(9.81)).unwrap();
    let learning = Clelc::new(chain::<T>(), learner());
    let references = |k| [reference(k, 0.0), reference(k, 1.0)];
    goes_on(Decoupling::new(arm.with_payload(num(0.7)).unwrap(), [learning; 2]), references);
    goes_on(Decoupling::new(arm, (learning, chain::<T>())), references);
}

fn the_unicycle_goes_on<T: Number>() {
    for direction in [Direction::Forward, Direction::Reverse] {
        let axes = [Clelc::new(chain::<T>(), learner()); 2];
        let controller =
            UnicycleController::new(axes, direction, num(0.05), Standstill::Hold).unwrap();
        goes_on(controller, |k| [reference(k, 0.0), reference(k, 1.0)]);
    }
}

fn what_stands_behind_an_actuator_goes_on<T: Number>() {
    let limits = Saturation::<T, 1>::symmetric([num::<T>(8.0)]).unwrap();
    let rate =
        RateLimit::<T, 1>::new([num::<T>(20.0)]).unwrap().starting_at([num::<T>(0.3)]).unwrap();
    let clelc = Clelc::new(pendulum::<T>(), learner());
    goes_on(Limited::new(clelc, (limits, rate)), |k| reference(k, 0.0));
}

fn what_an_operator_supervises_goes_on<T: Number>() {
    let clelc = Clelc::new(pendulum::<T>(), learner());
    let mut supervised = Supervised::<_, T, 1>::new(clelc, [num::<T>(0.1)]).unwrap();
    supervised.set_manual([num::<T>(0.4)]).unwrap();
    goes_on(supervised, |k| reference(k, 0.0));
    // Some samples by hand leave an offset that fades for longer than the check.
    let by_hand = crate::support::measured(0);
    supervised.update(&by_hand, &reference(0, 0.0), num(0.02)).unwrap();
    supervised.select(Mode::Automatic(LearningMode::Active));
    let mut loaded = crate::support::reloaded(&supervised);
    for k in 1..40 {
        let step = |controller: &mut Supervised<_, T, 1>| {
            let command =
                controller.update(&crate::support::measured(k), &reference(k, 0.0), num(0.02));
            format!("{:?}", command.unwrap())
        };
        let command = step(&mut supervised);
        for loaded in &mut loaded {
            assert_eq!(step(loaded), command);
        }
    }
}
