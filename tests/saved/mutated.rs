//! Whatever stands in a file: it is refused, or what is loaded is such that its constructors accept it and its calls do not fail in another way
//! than those of any controller.

use brunovsky::{
    channel::{RateLimit, Saturation},
    controller::{Clelc, Command, Controller, FeedbackLinearization, Gains, Limited},
    differentiator::FilteredDifference,
    fuzzy::{FuzzyNetwork, Gaussian},
    learning::{Advisor, Bounded, Guarded, Measured, NeuroFuzzy, Redundant, SlidingMode, Watchdog},
    plant::Pendulum,
};
use proptest::prelude::*;
use serde_json::{Value, json};

use crate::support::{measured, reference};

type Source = Redundant<Measured, FilteredDifference<f64>>;
type Learner = NeuroFuzzy<FuzzyNetwork<f64, 2, 3>, Source, Bounded<SlidingMode<f64>, f64>>;
type Base = Clelc<Pendulum<f64>, Guarded<Learner, f64>, 2>;
type Whole = Limited<Base, (Saturation<f64, 1>, RateLimit<f64, 1>), f64, 1>;

fn whole() -> Whole {
    let pendulum = Pendulum::new(1.0, 0.5, 0.1, 9.81).unwrap();
    let flc = FeedbackLinearization::new(pendulum, Gains::from_lambda(3.0).unwrap());
    let network = FuzzyNetwork::evenly_spaced([1.0, 2.0]).unwrap();
    let source = Redundant::new(Measured, FilteredDifference::new(0.05).unwrap());
    let rule = SlidingMode::new(6.0).unwrap();
    let watchdog = Watchdog::new(rule.certificate(0.02, 1.0).unwrap(), 0.1, 0.2).unwrap();
    let bounded = Bounded::new(rule, 5.0).unwrap().with_rate(4.0).unwrap();
    let learner = NeuroFuzzy::new(network, source, bounded);
    let guarded = Guarded::new(learner, watchdog).with_fallback(2.0).unwrap();
    let actuator = (Saturation::symmetric([9.0]).unwrap(), RateLimit::new([30.0]).unwrap());
    let mut whole = Limited::new(Clelc::new(flc, guarded), actuator);
    for k in 0..25 {
        whole.update(&measured(k), &reference(k, 0.0), 0.02).unwrap();
    }
    whole
}

/// The places of all values that hold no others.
fn leaves(value: &Value, at: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(key, value)| leaves(value, &format!("{at}/{key}"), found));
        }
        Value::Array(entries) => {
            let entries = entries.iter().enumerate();
            entries.for_each(|(i, value)| leaves(value, &format!("{at}/{i}"), found));
        }
        _ => found.push(at.to_owned()),
    }
}

fn replacement() -> impl Strategy<Value = Value> {
    prop_oneof![
        4 => any::<f64>().prop_map(|number| json!(number)),
        4 => (-3.0..3.0).prop_map(|number: f64| json!(number)),
        2 => prop::sample::select(vec![0.0, -0.0, 1e-320, 1e300, -1e300, f64::MAX, f64::MIN_POSITIVE]).prop_map(|number| json!(number)),
        1 => prop::sample::select(vec![json!(null), json!(true), json!("1"), json!([]), json!({}), json!("Off")]),
    ]
}

/// What the constructors promise of every part, and what a controller promises of its calls.
fn as_good_as_new(mut loaded: Whole) -> Result<(), TestCaseError> {
    // Nothing in it is NaN, or it would not be read again.
    let again: Whole = serde_json::from_value(serde_json::to_value(loaded).unwrap()).unwrap();
    prop_assert_eq!(&again, &loaded);
    let base = loaded.controller();
    prop_assert!(Gains::new(*base.base().gains().as_vector()).is_ok());
    let network = base.compensator().compensator().network();
    for membership in network.memberships().as_flattened() {
        prop_assert!(
            Gaussian::new(membership.centre(), membership.width()).is_ok(),
            "{membership:?}"
        );
    }
    prop_assert!(network.consequents().iter().all(|f| f.is_finite()));
    for k in 25..60 {
        let before = loaded;
        match loaded.update(&measured(k), &reference(k, 0.0), 0.02) {
            Ok(command) => {
                prop_assert!(command.input()[0].is_finite() && command.input()[0].abs() <= f64::MAX)
            }
            Err(_) => prop_assert_eq!(&loaded, &before),
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]
    #[test]
    fn a_changed_file_is_refused_or_as_good_as_new(
        changes in prop::collection::vec((any::<prop::sample::Index>(), replacement()), 1..4),
    ) {
        let mut file = serde_json::to_value(whole()).unwrap();
        let mut places = Vec::new();
        leaves(&file, "", &mut places);
        for (place, value) in changes {
            if let Some(old) = file.pointer_mut(place.get(places.as_slice()).as_str()) {
                *old = value;
            }
        }
        let Ok(loaded) = serde_json::from_value::<Whole>(file) else { return Ok(()) };
        as_good_as_new(loaded)?;
    }

    #[test]
    fn changed_bytes_are_refused_or_as_good_as_new(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
        cut in prop::option::weighted(0.1, any::<prop::sample::Index>()),
    ) {
        let mut bytes = postcard::to_stdvec(&whole()).unwrap();
        for (place, byte) in changes {
            *place.get_mut(bytes.as_mut_slice()) = byte;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        if let Ok(loaded) = postcard::from_bytes::<Whole>(&bytes) {
            as_good_as_new(loaded)?;
        }
    }

    #[test]
    fn changed_bytes_of_an_advisor_are_refused_or_work(
        samples in 0..200_u32,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let mut advisor = Advisor::new(0.01).unwrap();
        for k in 0..samples {
            advisor.push(0.0, (0.1 * f64::from(k)).sin()).unwrap();
        }
        let mut bytes = postcard::to_stdvec(&advisor).unwrap();
        for (place, byte) in changes {
            *place.get_mut(bytes.as_mut_slice()) = byte;
        }
        if let Ok(mut loaded) = postcard::from_bytes::<Advisor<f64>>(&bytes) {
            for k in 0..100 {
                loaded.push(0.0, f64::from(k % 7)).unwrap();
            }
            if let Ok(advice) = loaded.recommend() {
                prop_assert!(advice.rule().is_ok() && advice.certificate().is_ok());
            }
        }
    }
}
