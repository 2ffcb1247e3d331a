use brunovsky::{
    channel::{Delay, Lag, RateLimit, Saturation},
    controller::{
        Clelc, Controller, Decoupling, FeedbackLinearization, Gains, Supervised,
        unicycle::{Direction, Standstill, UnicycleController},
    },
    differentiator::{
        BackwardDifference, Differentiator, FilteredDifference, HighGain, RobustExact, Tracking,
    },
    fuzzy::{FuzzyNetwork, Gaussian},
    integrators::{Adaptive, DormandPrince, Tolerance},
    learning::{
        Advisor, Bounded, Conditional, GradientDescent, Guarded, ModelAided, NeuroFuzzy, Redundant,
        SlidingMode, Switching, Watchdog,
    },
    plant::{
        BallAndBeam, CartPole, CartPoleOutput, Duffing, FlexibleJoint, IntegratorChain, Linearized,
        Link, Pendulum, QuadrotorAttitude, TwoLinkArm,
    },
    simulation::{ErrorMetrics, StepInfo},
    trajectory::{Circle, ConstantSpeed, FigureEight, MinimumJerk, Quintic},
};
use serde::{Deserialize, de::value};
use serde_json::json;

use crate::support::{measured, reference, refusal};

type Loop = Clelc<
    IntegratorChain<f64, 2>,
    NeuroFuzzy<FuzzyNetwork<f64, 2, 3>, ModelAided<f64>, SlidingMode<f64>>,
    2,
>;

/// A loop that has learned for some samples.
fn learned() -> Loop {
    let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(2.0).unwrap());
    let network = FuzzyNetwork::evenly_spaced([1.0, 2.0]).unwrap();
    let rule = SlidingMode::new(5.0).unwrap();
    let mut clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));
    for k in 0..20 {
        clelc.update(&measured(k), &reference(k, 0.0), 0.02).unwrap();
    }
    clelc
}

#[test]
fn parameters_out_of_range_are_named() {
    let gaussian = Gaussian::new(0.0, 1.0).unwrap();
    assert_eq!(refusal(&gaussian, "/width", json!(-1.0)), "width = -1 must be greater than 0");
    let gains = Gains::new([1.0, 3.0, 3.0]).unwrap();
    assert!(refusal(&gains, "/k", json!([100.0, 1.0, 1.0])).contains("not Hurwitz"));
    let rule = SlidingMode::new(5.0).unwrap();
    assert_eq!(refusal(&rule, "/alpha", json!(0.0)), "alpha = 0 must be greater than 0");
    let delta = json!({ "Explicit": { "delta": 0.0 } });
    assert_eq!(refusal(&rule, "/switching", delta), "delta = 0 must be greater than 0");
    let delta = json!({ "Implicit": { "delta": -1.0 } });
    assert_eq!(refusal(&rule, "/switching", delta), "delta = -1 must not be negative");
    assert_eq!(
        refusal(&rule, "/antecedents/floor", json!(100.0)),
        "floor = 100 must be less than 100"
    );
    let certificate = rule.certificate(0.01, 1.0).unwrap();
    assert_eq!(refusal(&certificate, "/dt", json!(-0.1)), "dt = -0.1 must be greater than 0");
    let descent = GradientDescent::new(1.0).unwrap();
    assert_eq!(refusal(&descent, "/rate", json!(0.0)), "learning rate = 0 must be greater than 0");
    let bounded = Bounded::new(rule, 1.0).unwrap().with_rate(2.0).unwrap();
    assert_eq!(refusal(&bounded, "/bound", json!(0.0)), "bound = 0 must be greater than 0");
    assert_eq!(refusal(&bounded, "/rate", json!(-2.0)), "rate of u_n = -2 must be greater than 0");
    let filter = FilteredDifference::new(0.1).unwrap();
    assert_eq!(
        refusal(&filter, "/time_constant", json!(-1)),
        "time constant = -1 must not be negative"
    );
    let conditional = Conditional::new(BackwardDifference::<f64>::new(), 0.1).unwrap();
    assert_eq!(
        refusal(&conditional, "/tolerance", json!(-1)),
        "tolerance = -1 must not be negative"
    );
    let watchdog = Watchdog::new(certificate, 0.1, 1.0).unwrap();
    assert_eq!(refusal(&watchdog, "/patience", json!(-1)), "patience = -1 must not be negative");
    assert_eq!(
        refusal(&watchdog, "/late", json!(-1)),
        "time above the bound = -1 must not be negative"
    );
    let guarded = Guarded::new(*learned().compensator(), watchdog).with_fallback(1.0).unwrap();
    assert_eq!(refusal(&guarded, "/fade", json!(0)), "fade = 0 must be greater than 0");
    let limits = Saturation::symmetric([1.0, 2.0]).unwrap();
    assert_eq!(refusal(&limits, "/least/1", json!(2.0)), "least = 2 must be less than 2");
    let limit = RateLimit::new([1.0]).unwrap();
    assert_eq!(refusal(&limit, "/rate/0", json!(-1.0)), "rate = -1 must not be negative");
}

#[test]
fn the_switching_is_checked_where_it_is_used() {
    // On its own it is a plain value, as in Rust.
    let switching: Switching<f64> =
        serde_json::from_value(json!({ "Explicit": { "delta": 0.0 } })).unwrap();
    assert!(SlidingMode::new(1.0).unwrap().with_switching(switching).is_err());
}

#[test]
fn plants_and_controllers_out_of_range_are_named() {
    let pendulum = Pendulum::new(1.0, 1.0, 0.0, 9.81).unwrap();
    assert_eq!(refusal(&pendulum, "/mass", json!(0)), "mass = 0 must be greater than 0");
    let link = Link { mass: 1.0, length: 0.3, centre: 0.1, inertia: 0.02 };
    let arm = TwoLinkArm::new([link; 2], [0.1, 0.1], 9.81).unwrap();
    assert_eq!(
        refusal(&arm, "/links/1/mass", json!(-1)),
        "mass of link 2 = -1 must be greater than 0"
    );
    assert_eq!(refusal(&arm, "/payload", json!(-1)), "payload = -1 must not be negative");
    let decoupling = Decoupling::new(arm, [learned(), learned()]);
    assert_eq!(
        refusal(&decoupling, "/max_condition", json!(0)),
        "condition number limit = 0 must be greater than 0"
    );
    let unicycle =
        UnicycleController::new([learned(), learned()], Direction::Forward, 0.1, Standstill::Hold)
            .unwrap();
    assert_eq!(
        refusal(&unicycle, "/decoupling/model/min_speed", json!(0)),
        "min_speed = 0 must be greater than 0"
    );
    let supervised = Supervised::new(learned(), [1.0]).unwrap();
    assert_eq!(refusal(&supervised, "/fade/0", json!(0)), "fade = 0 must be greater than 0");
}

#[test]
fn plants_by_their_equations_out_of_range_are_named() {
    let duffing = Duffing::new(0.1, 1.0, 2.0).unwrap();
    assert_eq!(refusal(&duffing, "/damping", json!(-1)), "damping = -1 must not be negative");
    let ball = BallAndBeam::new(0.4, 9.81).unwrap();
    assert_eq!(refusal(&ball, "/share", json!(0)), "share = 0 must be greater than 0");
    assert_eq!(refusal(&ball, "/share", json!(1.5)), "1 - share = -0.5 must not be negative");
    let cart = CartPole::new(1.0, 0.1, 0.5, [0.0; 2], 9.81, CartPoleOutput::Angle).unwrap();
    assert_eq!(
        refusal(&cart, "/friction/1", json!(-1)),
        "friction of the pivot = -1 must not be negative"
    );
    let body = QuadrotorAttitude::new([0.1; 3]).unwrap();
    assert_eq!(
        refusal(&body, "/inertia/2", json!(0)),
        "inertia about z = 0 must be greater than 0"
    );
    let joint = FlexibleJoint::new(0.03, 0.004, 31.0, 0.8).unwrap();
    let model = Linearized::<_, 4, 4, 1>::new(joint, [0.1; 4]).unwrap();
    assert_eq!(
        refusal(&model, "/plant/stiffness", json!(0)),
        "stiffness = 0 must be greater than 0"
    );
    for degree in [0, 5] {
        assert_eq!(
            refusal(&model, "/degrees/0", json!(degree)),
            format!("output 0 has relative degree {degree}, not 4")
        );
    }
    assert_eq!(refusal(&model, "/min_gains/0", json!(-1)), "min_gains = -1 must not be negative");
}

/// `differentiator` after some samples.
fn used<D: Differentiator<Scalar = f64>>(mut differentiator: D) -> D {
    for y in [0.3, 0.5, 0.8] {
        differentiator.update(y, 0.1).unwrap();
    }
    differentiator
}

#[test]
fn differentiators_out_of_range_are_named() {
    let observer = used(HighGain::second_order(5.0).unwrap());
    assert_eq!(refusal(&observer, "/bandwidth", json!(0)), "bandwidth = 0 must be greater than 0");
    let robust = used(RobustExact::first_order(5.0).unwrap());
    assert_eq!(
        refusal(&robust, "/bound", json!(-1)),
        "bound on the rate = -1 must be greater than 0"
    );
    let tracking = used(Tracking::new(5.0, 0.1).unwrap());
    assert_eq!(refusal(&tracking, "/horizon", json!(0)), "horizon = 0 must be greater than 0");
    // Of an order that no constructor makes, or another than was saved.
    let observer = serde_json::to_string(&observer).unwrap();
    assert!(serde_json::from_str::<HighGain<f64, 3>>(&observer).is_ok());
    let refused = |text: &str| {
        let order = [
            serde_json::from_str::<HighGain<f64, 1>>(text).map(|_| ()),
            serde_json::from_str::<HighGain<f64, 4>>(text).map(|_| ()),
        ];
        order.map(|loaded| loaded.unwrap_err().to_string())
    };
    refused(&observer);
    let fresh = serde_json::to_string(&HighGain::first_order(5.0).unwrap()).unwrap();
    let [first, fourth] = refused(&fresh);
    assert!(first.starts_with("estimate has 1 entries"), "{first}");
    assert!(fourth.starts_with("estimate has 4 entries"), "{fourth}");
    for text in [r#"{ "bound": 1, "state": null }"#, r#"{ "bound": 1, "state": [0] }"#] {
        assert!(serde_json::from_str::<RobustExact<f64, 1>>(text).is_err());
        assert!(serde_json::from_str::<RobustExact<f64, 5>>(text).is_err());
    }
}

#[test]
fn channels_out_of_range_are_named() {
    let delay = Delay::<f64, 1, 3>::new();
    assert_eq!(refusal(&delay, "/oldest", json!(3)), "oldest = 3 must be less than 3");
    let lag = Lag::new([0.1]).unwrap();
    assert_eq!(refusal(&lag, "/time/0", json!(0)), "time constant = 0 must be greater than 0");
    let nothing = Delay::<f64, 1, 0>::new();
    refusal(&nothing, "/line", json!([[0.0]]));
}

#[test]
fn integrators_out_of_range_are_named() {
    let method = Adaptive::new(DormandPrince, Tolerance::<f64, 2>::new(1e-6, 1e-9).unwrap());
    let at = "/tolerance/absolute/1";
    assert_eq!(refusal(&method, at, json!(0)), "atol = 0 must be greater than 0");
    let at = "/tolerance/relative";
    assert_eq!(refusal(&method, at, json!(-1)), "rtol = -1 must not be negative");
    let at = "/first_step";
    assert_eq!(refusal(&method, at, json!(0)), "first step = 0 must be greater than 0");
    let at = "/longest_step";
    assert_eq!(refusal(&method, at, json!(-1)), "longest step = -1 must be greater than 0");
    let at = "/step_limit";
    assert_eq!(refusal(&method, at, json!(0)), "step limit = 0 must be greater than 0");
}

#[test]
fn figures_of_merit_out_of_range_are_named() {
    let info = StepInfo::of([(0.0, 0.0), (1.0, 0.9)], 0.0, 1.0).unwrap();
    assert_eq!(refusal(&info, "/span", json!(0)), "y_final - y_init = 0 is singular");
    assert_eq!(
        refusal(&info, "/last/0", json!(-1)),
        "time since the first sample = -1 must not be negative"
    );
    let metrics = ErrorMetrics::of([(0.0, 1.0), (1.0, 0.5)]).unwrap();
    assert_eq!(refusal(&metrics, "/ise", json!(-1)), "ISE = -1 must not be negative");
}

#[test]
fn a_record_whose_ranks_do_not_fit_is_refused() {
    let mut advisor = Advisor::new(0.01).unwrap();
    for k in 0..100 {
        advisor.push(0.0, (0.1 * f64::from(k)).sin()).unwrap();
    }
    let step = "/scales/0/step";
    assert_eq!(
        refusal(&advisor, &format!("{step}/ranks/1"), json!(0)),
        "distance of ranks = 0 must be greater than 0"
    );
    assert_eq!(
        refusal(&advisor, &format!("{step}/count"), json!(200)),
        "ranks has 98 entries, not 199"
    );
    assert_eq!(
        refusal(&advisor, &format!("{step}/count"), json!(0)),
        "ranks has 98 entries, not 4"
    );
    assert_eq!(
        refusal(&advisor, &format!("{step}/heights/0"), json!(-1)),
        "least marker = -1 must not be negative"
    );
    assert!(
        refusal(&advisor, &format!("{step}/heights/0"), json!(9))
            .starts_with("distance of markers")
    );
}

#[test]
fn the_unicycle_keeps_its_own_limit_of_the_condition_number() {
    let unicycle =
        UnicycleController::new([learned(), learned()], Direction::Forward, 0.1, Standstill::Hold)
            .unwrap();
    let mut file = serde_json::to_value(unicycle).unwrap();
    *file.pointer_mut("/decoupling/max_condition").unwrap() = json!(1.0);
    let loaded = serde_json::from_value::<UnicycleController<f64, [Loop; 2]>>(file).unwrap();
    assert_eq!(loaded, unicycle);
}

#[test]
fn trajectories_out_of_range_are_named() {
    let quintic = Quintic::rest_to_rest([0.0], [1.0], 2.0).unwrap();
    assert_eq!(refusal(&quintic, "/duration", json!(0)), "duration = 0 must be greater than 0");
    let curve = MinimumJerk::new([[0.0], [1.0], [0.5]], [0.0, 1.0, 2.0]).unwrap();
    assert_eq!(
        refusal(&curve, "/times/1", json!(2)),
        "time of the point before = 2 must be less than 2"
    );
    let steady = ConstantSpeed::new([[0.0, 0.0], [1.0, 0.0], [2.0, 1.0]], 0.5).unwrap();
    assert_eq!(refusal(&steady, "/speed", json!(-1)), "speed = -1 must be greater than 0");
    let twice = json!([0.0, 0.0]);
    assert!(
        refusal(&steady, "/points/1", twice).starts_with("distance between consecutive points = 0")
    );
    let circle = Circle::new([0.0, 0.0], 1.0, 1.0, 0.0).unwrap();
    assert_eq!(refusal(&circle, "/radius", json!(0)), "radius = 0 must be greater than 0");
    let eight = FigureEight::new(1.0, 1.0, 1.0).unwrap();
    assert_eq!(refusal(&eight, "/amplitudes/1", json!(0)), "width = 0 must be greater than 0");
}

#[test]
fn sizes_have_to_fit() {
    let clelc = learned();
    let consequents = "/compensator/network/consequents";
    assert_eq!(
        refusal(&clelc, consequents, json!([0, 0, 0, 0, 0, 0, 0, 0])),
        "8 entries instead of 9"
    );
    for pointer in [consequents, "/compensator/network/memberships", "/base/gains/k"] {
        for entries in [0, 1, 20] {
            let value = json!(vec![json!({ "centre": 0.0, "width": 1.0 }); entries]);
            refusal(&clelc, pointer, value);
            refusal(&clelc, pointer, json!(vec![1.0; entries]));
        }
    }
    // Of another number of inputs, or of memberships.
    let text = serde_json::to_string(clelc.compensator().network()).unwrap();
    assert!(serde_json::from_str::<FuzzyNetwork<f64, 2, 3>>(&text).is_ok());
    assert!(serde_json::from_str::<FuzzyNetwork<f64, 3, 3>>(&text).is_err());
    assert!(serde_json::from_str::<FuzzyNetwork<f64, 2, 2>>(&text).is_err());
}

#[test]
fn fields_have_to_be_there_and_no_others() {
    let refused = |text: &str| serde_json::from_str::<Gaussian<f64>>(text).unwrap_err().to_string();
    assert!(refused(r#"{ "centre": 0 }"#).starts_with("missing field `width`"));
    assert!(
        refused(r#"{ "centre": 0, "width": 1, "sigma": 2 }"#).starts_with("unknown field `sigma`")
    );
    assert!(refused(r#"{ "centre": null, "width": 1 }"#).contains("null"));
    assert!(refused("[]").contains("invalid length 0"));
    // An empty memory is written down, so that one that was lost is noticed.
    let refused =
        |text: &str| serde_json::from_str::<BackwardDifference<f64>>(text).unwrap_err().to_string();
    assert!(serde_json::from_str::<BackwardDifference<f64>>(r#"{ "last": null }"#).is_ok());
    assert!(refused("{}").starts_with("missing field `last`"));
    // Not even where a type promises nothing about its values.
    let link = r#"{ "mass": 1, "length": 1, "centre": 1, "inertia": 1, "colour": 1 }"#;
    assert!(serde_json::from_str::<Link<f64>>(link).is_err());
    let switching = r#"{ "Implicit": { "delta": 1, "layer": 3 } }"#;
    assert!(serde_json::from_str::<Switching<f64>>(switching).is_err());
    let both = r#"{ "first": { "last": 1 }, "second": { "last": 1 }, "third": 1 }"#;
    type Both = Redundant<BackwardDifference<f64>, BackwardDifference<f64>>;
    assert!(serde_json::from_str::<Both>(both).is_err());
}

#[test]
fn a_number_that_is_not_finite_is_named() {
    for (number, said) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf"), (f64::NEG_INFINITY, "-inf")] {
        let entries = [("centre", number), ("width", 1.0)];
        let file = value::MapDeserializer::<_, value::Error>::new(entries.into_iter());
        let refused = Gaussian::<f64>::deserialize(file).unwrap_err().to_string();
        assert_eq!(refused, format!("centre = {said} is not finite"));
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    // JSON has no NaN; bytes have.
    for centre in [f64::NAN, f64::INFINITY] {
        let bytes = postcard::to_stdvec(&(centre, 1.0)).unwrap();
        assert!(postcard::from_bytes::<Gaussian<f64>>(&bytes).is_err());
        let bytes = postcard::to_stdvec(&Some(centre)).unwrap();
        assert!(postcard::from_bytes::<BackwardDifference<f64>>(&bytes).is_err());
    }
    // Too large for the scalar that it is read as.
    assert!(serde_json::from_str::<Gaussian<f32>>(r#"{ "centre": 1e300, "width": 1 }"#).is_err());
    assert!(serde_json::from_str::<Gaussian<f64>>(r#"{ "centre": 1e999, "width": 1 }"#).is_err());
}

#[test]
fn bytes_of_a_learner_with_any_number_not_finite_are_refused() {
    let clelc = learned();
    let bytes = postcard::to_stdvec(&clelc).unwrap();
    for start in 0..bytes.len() - 8 {
        let mut hostile = bytes.clone();
        hostile[start..start + 8].copy_from_slice(&f64::NAN.to_le_bytes());
        // A NaN that straddles two numbers may leave both finite.
        if let Ok(loaded) = postcard::from_bytes::<Loop>(&hostile) {
            let text = serde_json::to_string(&loaded).unwrap();
            assert!(
                serde_json::from_str::<Loop>(&text).is_ok(),
                "a NaN at byte {start} was loaded"
            );
        }
    }
}

#[test]
fn a_file_that_breaks_off_is_refused() {
    let clelc = learned();
    let (bytes, text) =
        (postcard::to_stdvec(&clelc).unwrap(), serde_json::to_string(&clelc).unwrap());
    for length in 0..bytes.len() {
        assert!(postcard::from_bytes::<Loop>(&bytes[..length]).is_err());
    }
    for length in 0..text.len() {
        assert!(serde_json::from_str::<Loop>(&text[..length]).is_err());
    }
}

#[test]
fn a_travel_beyond_its_way_is_refused() {
    let clelc = learned();
    let flowed = "/compensator/network/travel/flowed/0";
    assert!(refusal(&clelc, &format!("{flowed}/by"), json!(1e3)).contains("flow to come"));
    assert!(refusal(&clelc, &format!("{flowed}/by"), json!(-1e3)).contains("flow back to come"));
    // So far that a width vanishes: d·e^{−τ} underflows.
    let way = json!({ "by": 1e4, "least": 0.0, "most": 1e4 });
    assert_eq!(refusal(&clelc, flowed, way), "width = 0 must be greater than 0");
    // Below M² = 0.
    let way = json!({ "by": 0.0, "least": -1e4, "most": 0.0 });
    refusal(&clelc, flowed, way);
}
