//! Failed runs are listed with their reason, and improve nothing.

use brunovsky::{
    Error,
    ensemble::{Ensemble, Run},
};

use crate::support::{given, pendulums};

#[test]
fn failed_runs_are_listed_by_index_with_their_reason() {
    let runs = pendulums().runs(20);
    let reason = "mass = -1 must be greater than 0";
    assert_eq!(runs.failures().collect::<Vec<_>>(), [(5, reason), (13, reason)]);
    assert_eq!(runs.completed().count(), 18);
    assert_eq!(runs.failure_rate(0.95).unwrap().value, 0.1);
    assert!(runs.summaries(0.95).unwrap().iter().all(|s| s.failed() == 2 && s.total() == 20));
}

#[test]
fn a_figure_that_is_not_finite_is_a_failure_by_its_name() {
    let ensemble = Ensemble::new(0, ["a", "b"], |run: Run| match run.index() {
        0 => Ok::<_, Error>([1.0, f64::NAN]),
        1 => Ok([f64::NEG_INFINITY, f64::INFINITY]),
        _ => Ok([1.0, 2.0]),
    });
    let runs = ensemble.runs(3);
    let reasons = [(0, "b = NaN is not finite"), (1, "a = -inf is not finite")];
    assert_eq!(runs.failures().collect::<Vec<_>>(), reasons);
    assert_eq!(runs.completed().collect::<Vec<_>>(), [(2, &[1.0, 2.0])]);
}

/// Reasons are one line each, and none is empty: a record has one line a run.
#[test]
fn a_reason_is_one_line() {
    let ensemble = Ensemble::new(0, ["x"], |run: Run| {
        Err::<[f64; 1], _>(if run.index() == 0 { "two\r\nlines" } else { "" })
    });
    let runs = ensemble.runs(2);
    assert_eq!(runs.failures().collect::<Vec<_>>(), [(0, "two  lines"), (1, "failed")]);
}

/// Of 1, 2, …, 10 the two largest fail: the mean is that of the rest, and every quantile is where it was, or infinite.
#[test]
fn failing_does_not_improve_a_quantile() {
    let values: Vec<f64> = (1..=10).map(f64::from).collect();
    let mut failing = values.clone();
    failing[8..].fill(f64::NAN);
    let [all] = given(&values).summaries(0.5).unwrap();
    let [some] = given(&failing).summaries(0.5).unwrap();
    for p in [0.05, 0.1, 0.35, 0.5, 0.75, 0.8] {
        assert_eq!(some.quantile(p).unwrap().value, all.quantile(p).unwrap().value);
    }
    for p in [0.81, 0.9, 0.99] {
        assert_eq!(some.quantile(p).unwrap().value, f64::INFINITY);
    }
    for p in [0.05, 0.5, 0.75, 0.9] {
        assert!(some.quantile(p).unwrap().low >= all.quantile(p).unwrap().low);
        assert!(some.quantile(p).unwrap().high >= all.quantile(p).unwrap().high);
    }
    assert_eq!(some.mean().unwrap().value, 4.5);
    assert_eq!((some.failed(), some.worst().unwrap().index), (2, 7));
}

#[test]
fn without_completed_runs_there_are_no_means() {
    let [none] = given(&[f64::NAN, f64::NAN]).summaries(0.95).unwrap();
    assert_eq!(none.mean(), Err(Error::Missing { name: "completed run" }));
    assert_eq!(none.deviation(), Err(Error::Missing { name: "second completed run" }));
    assert_eq!(none.quantile(0.5).unwrap().value, f64::INFINITY);
    assert_eq!((none.worst(), none.best()), (None, None));

    let runs = given(&[]);
    let [nothing] = runs.summaries(0.95).unwrap();
    assert_eq!(nothing.quantile(0.5), Err(Error::Missing { name: "run" }));
    assert_eq!(runs.failure_rate(0.95), Err(Error::Missing { name: "run" }));
}

#[test]
fn levels_and_shares_outside_of_0_to_1_are_refused() {
    let runs = given(&[1.0, 2.0]);
    let [summary] = runs.summaries(0.95).unwrap();
    for bad in [0.0, 1.0, -0.5, 1.5, f64::NAN, f64::INFINITY] {
        assert!(runs.summaries(bad).is_err());
        assert!(runs.failure_rate(bad).is_err());
        assert!(summary.quantile(bad).is_err());
    }
    let error = Error::NotBelow { name: "confidence level", value: 95.0, limit: 1.0 };
    assert_eq!(runs.summaries(95.0), Err(error));
}
