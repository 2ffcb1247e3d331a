//! The same runs, to the last bit, on any number of threads and alone.

use std::sync::atomic::{AtomicU64, Ordering};

use brunovsky::{
    Error,
    ensemble::{Ensemble, Outcome, Run},
};

use crate::support::pendulums;

/// Numbers as their bits, so that −0 is not 0.
fn bits<const M: usize>(outcomes: &[Outcome<M>]) -> Vec<Result<[u64; M], &String>> {
    outcomes.iter().map(|outcome| outcome.as_ref().map(|x| x.map(f64::to_bits))).collect()
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let ensemble = pendulums();
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| ensemble.runs(200))
    };
    let one = on(1);
    assert_eq!(one.outcomes().len(), 200);
    for threads in [2, 7] {
        assert_eq!(bits(on(threads).outcomes()), bits(one.outcomes()));
    }
}

#[test]
fn a_run_alone_is_that_of_the_ensemble() {
    let ensemble = pendulums();
    let runs = ensemble.runs(40);
    for index in (0..40).rev() {
        assert_eq!(bits(&[ensemble.run(index)]), bits(&runs.outcomes()[index as usize..][..1]));
    }
}

#[test]
fn a_shorter_ensemble_is_the_start_of_a_longer_one() {
    let ensemble = pendulums();
    assert_eq!(ensemble.runs(30).outcomes(), &ensemble.runs(50).outcomes()[..30]);
    assert!(ensemble.runs(0).outcomes().is_empty());
}

/// Seven threads, of which the one with run 0 is the last to be done: nothing waits for it, and nothing is out of order.
#[test]
fn runs_are_in_order_however_long_they_take() {
    let started = AtomicU64::new(0);
    let ensemble = Ensemble::new(0, ["index"], |run: Run| {
        started.fetch_add(1, Ordering::SeqCst);
        while run.index() == 0 && started.load(Ordering::SeqCst) < 50 {
            std::thread::yield_now();
        }
        Ok::<_, Error>([run.index() as f64])
    });
    let pool = rayon::ThreadPoolBuilder::new().num_threads(7).build().unwrap();
    let runs = pool.install(|| ensemble.runs(50));
    let found: Vec<_> = runs.completed().map(|(index, [x])| (index, *x)).collect();
    assert_eq!(found, (0..50).map(|index| (index, index as f64)).collect::<Vec<_>>());
}

#[test]
fn the_bar_changes_nothing() {
    assert_eq!(pendulums().with_progress().runs(20), pendulums().runs(20));
}
