//! A call that fails says why and leaves no trace.

use brunovsky::{
    Error,
    controller::{Clelc, Controller, FeedbackLinearization, Gains, Measurement, Reference},
    fuzzy::FuzzyNetwork,
    learning::{
        Antecedents, BackwardDifference, ErrorRate, FilteredDifference, Fixed, Flow, Measured,
        ModelAided, NeuroFuzzy, SlidingMode,
    },
    plant::FeedbackLinearizable,
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::super::support::Learning;

/// a(x) = e^x₁, which overflows, and b(x) = x₂, which vanishes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Fragile;

impl FeedbackLinearizable<2> for Fragile {
    type Scalar = f64;

    fn drift(&self, x: &SVector<f64, 2>) -> f64 {
        x[0].exp()
    }

    fn input_gain(&self, x: &SVector<f64, 2>) -> f64 {
        x[1]
    }
}

fn controller<E, A>(error_rate: E, alpha: f64, antecedents: A) -> Learning<Fragile, E, f64, 2, A>
where
    E: ErrorRate<f64, 2> + Clone,
    A: Antecedents<FuzzyNetwork<f64, 2, 3>> + Clone,
{
    let base = FeedbackLinearization::new(Fragile, Gains::new([2.0, 3.0]).unwrap());
    let rule = SlidingMode::new(alpha).unwrap().with_antecedents(antecedents);
    let network = FuzzyNetwork::evenly_spaced([1.0, 2.0]).unwrap();
    Clelc::new(base, NeuroFuzzy::new(network, error_rate, rule))
}

/// One call: what is measured, what is wanted, and the period.
#[derive(Debug, Clone, Copy)]
struct Call {
    measurement: Measurement<f64, 2, 1>,
    reference: Reference<f64, 2>,
    dt: f64,
}

prop_compose! {
    fn good_call()(
        x0 in -2.0..2.0_f64, x1 in 0.5..2.0_f64, x_dot in prop::array::uniform2(-9.0..9.0_f64), applied in -9.0..9.0_f64,
        r in prop::array::uniform2(-2.0..2.0_f64), r_n_dot in -2.0..2.0_f64, dt in 0.001..0.1_f64,
    ) -> Call {
        Call {
            measurement: Measurement::new([x0, x1]).with_rate(x_dot).with_applied([applied]),
            reference: Reference::new(r, r_n_dot),
            dt,
        }
    }
}

/// Spoils one part of a good call; returns it with what its error has to name.
fn spoiled(good: Call, kind: usize, bad: f64) -> (Call, &'static str) {
    let mut call = good;
    let name = match kind {
        0 => (call.dt = bad, "dt").1,
        1 => (call.dt = 0.0, "dt").1,
        2 => (call.dt = -call.dt, "dt").1,
        3 => (call.measurement.x[1] = bad, "x").1,
        4 => (call.measurement = good.measurement.with_rate([0.0, bad]), "x_dot").1,
        5 => (call.measurement = good.measurement.with_applied([bad]), "applied").1,
        6 => (call.reference.r[0] = bad, "r").1,
        7 => (call.reference.r_n_dot = bad, "r_n_dot").1,
        8 => (call.measurement.x[0] = 1000.0, "a(x)").1,
        9 => (call.reference.r[1] = 1e308, "u_b").1,
        // These two fail only after the compensator has made its step.
        10 => (call.measurement.x[1] = 0.0, "b(x)").1,
        _ => (call.measurement.x[1] = 1e-320, "b(x)").1,
    };
    (call, name)
}

fn name(error: Error) -> &'static str {
    match error {
        Error::NonFinite { name, .. }
        | Error::NonFiniteEntry { name, .. }
        | Error::NotPositive { name, .. }
        | Error::Singular { name, .. }
        | Error::Missing { name } => name,
        other => panic!("unexpected kind: {other}"),
    }
}

/// Two controllers see the same good calls; one of them sees bad ones in between.
fn is_unmoved_by_bad_calls<E, A>(
    error_rate: E,
    antecedents: A,
    calls: &[(Call, Option<(usize, f64)>)],
) where
    E: ErrorRate<f64, 2> + Clone + PartialEq + core::fmt::Debug,
    A: Antecedents<FuzzyNetwork<f64, 2, 3>> + Clone + PartialEq + core::fmt::Debug,
{
    let mut tried = controller(error_rate, 5.0, antecedents);
    let mut spared = tried.clone();
    for (good, bad) in calls {
        if let Some((kind, value)) = bad {
            let (call, expected) = spoiled(*good, *kind, *value);
            let error = tried.update(&call.measurement, &call.reference, call.dt).unwrap_err();
            assert_eq!(name(error), expected);
            assert_eq!(tried, spared);
        }
        let update = |controller: &mut Learning<Fragile, E, f64, 2, A>| {
            controller.update(&good.measurement, &good.reference, good.dt).unwrap()
        };
        assert_eq!(update(&mut tried), update(&mut spared));
        assert_eq!(tried, spared);
    }
}

fn bad() -> impl Strategy<Value = (usize, f64)> {
    (0..12_usize, prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY]))
}

proptest! {
    #[test]
    fn a_bad_call_names_what_was_bad_and_leaves_no_trace(
        calls in prop::collection::vec((good_call(), prop::option::of(bad())), 1..20),
    ) {
        macro_rules! with {
            ($($antecedents:expr),+) => {$(
                is_unmoved_by_bad_calls(Measured, $antecedents, &calls);
                is_unmoved_by_bad_calls(BackwardDifference::new(), $antecedents, &calls);
                is_unmoved_by_bad_calls(FilteredDifference::new(0.1).unwrap(), $antecedents, &calls);
                is_unmoved_by_bad_calls(ModelAided::new(), $antecedents, &calls);
            )+};
        }
        with!(Fixed, Flow::default());
    }
}

/// Makes one bad call after one good one, and expects no trace of it.
fn refused<E>(mut controller: Learning<Fragile, E, f64, 2>, x: [f64; 2], dt: f64) -> Error
where
    E: ErrorRate<f64, 2> + Clone + PartialEq + core::fmt::Debug,
{
    let start = Measurement::new([0.0, 1.0]).with_rate([1.0, 0.0]);
    controller.update(&start, &Reference::setpoint(0.5), 0.1).unwrap();
    let before = controller.clone();
    let error = controller.update(&Measurement::new(x), &Reference::setpoint(0.5), dt).unwrap_err();
    assert_eq!(controller, before);
    error
}

#[test]
fn a_rate_that_is_not_measured_is_missing() {
    let error = refused(controller(Measured, 5.0, Flow::default()), [0.0, 1.0], 0.1);
    assert_eq!(error, Error::Missing { name: "measured rate of x_n" });
}

#[test]
fn a_difference_quotient_beyond_the_range_is_named() {
    let (flow, filter) = (Flow::default(), FilteredDifference::new(0.0).unwrap());
    // −2/1e-310; in the last one the difference alone is beyond the range, 1/1e-310.
    for (error, expected) in [
        (refused(controller(BackwardDifference::new(), 5.0, flow), [0.0, 2.0], 1e-310), "y/dt"),
        (refused(controller(filter, 5.0, flow), [0.0, 2.0], 1e-310), "y/(tau + dt)"),
        (refused(controller(ModelAided::new(), 5.0, flow), [0.0, 2.0], 1e-310), "y/dt"),
        (
            refused(controller(BackwardDifference::new(), 5.0, flow), [0.0, 1e-10], 1e-310),
            "rate of y",
        ),
    ] {
        assert!(
            matches!(error, Error::NonFinite { name, .. } if name == expected),
            "{error} for {expected}"
        );
    }
}

#[test]
fn a_learned_term_beyond_the_range_is_an_error_of_u_n() {
    // The rule may move u_n by α·dt, which is beyond the range of f64.
    let error =
        refused(controller(BackwardDifference::new(), 1e300, Flow::default()), [0.0, 1.5], 1e10);
    assert!(matches!(error, Error::NonFinite { name: "u_n", .. }), "{error}");
}
