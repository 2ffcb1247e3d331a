//! An ensemble that was interrupted is continued from its file as if nothing had happened; a file of another one is left alone.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::atomic::{AtomicU64, Ordering},
};

use brunovsky::{
    Error,
    ensemble::{Ensemble, RecordError, Run, rand::RngExt},
};

use crate::support::pendulums;

/// A file of its own for each test, removed when the test is over.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name).with_extension("csv");
        let _ = fs::remove_file(&path);
        Self(path)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

/// Figures of every kind that a line must keep to the bit, a reason that needs quotes, and a count of the runs that were made.
fn counted(made: &AtomicU64) -> Ensemble<'_, 2> {
    Ensemble::new(5, ["a, in \"m\"", "b"], move |mut run: Run| {
        made.fetch_add(1, Ordering::SeqCst);
        match run.index() {
            2 => Err("too, \"far\"\nand back"),
            3 => Ok([-0.0, f64::MIN_POSITIVE / 3.0]),
            4 => Ok([f64::MAX, 0.1 + 0.2]),
            5 => Ok([f64::NAN, 1.0]),
            _ => Ok([run.random(), -run.random::<f64>()]),
        }
    })
}

#[test]
fn a_recorded_ensemble_is_the_ensemble() {
    let scratch = Scratch::new("is");
    assert_eq!(pendulums().recorded(30, &scratch.0, "").unwrap(), pendulums().runs(30));
    // Read back, with not a run made but the one that is repeated.
    assert_eq!(pendulums().recorded(30, &scratch.0, "").unwrap(), pendulums().runs(30));
}

/// Torn after every one of its bytes, in the header, in a line or at its end, the file becomes what it was.
#[test]
fn a_file_torn_anywhere_is_completed_to_the_same_bytes() {
    let (scratch, made) = (Scratch::new("torn"), AtomicU64::new(0));
    let ensemble = counted(&made);
    let whole_runs = ensemble.recorded(8, &scratch.0, "a\nb").unwrap();
    let whole = fs::read(&scratch.0).unwrap();
    let lines = |bytes: &[u8]| bytes.iter().filter(|&&byte| byte == b'\n').count() as u64;
    assert_eq!(lines(&whole), 2 + 8);
    for end in 0..=whole.len() {
        fs::write(&scratch.0, &whole[..end]).unwrap();
        made.store(0, Ordering::SeqCst);
        assert_eq!(ensemble.recorded(8, &scratch.0, "a\nb").unwrap(), whole_runs);
        assert_eq!(fs::read(&scratch.0).unwrap(), whole, "torn after {end} bytes");
        // What was whole is not made again, but for the first run, which is compared.
        let kept = lines(&whole[..end]).saturating_sub(2);
        let repeated = u64::from(kept > 0);
        assert_eq!(made.load(Ordering::SeqCst), 8 - kept + repeated);
    }
}

/// A panic in run 20 stands for a killed process. At most what the other threads had begun is missing, and nothing is out of order.
#[test]
fn a_killed_ensemble_goes_on_where_it_was() {
    let (scratch, reference) = (Scratch::new("killed"), Scratch::new("not_killed"));
    let figure = |mut run: Run| Ok::<_, Error>([run.random::<f64>()]);
    let whole = Ensemble::new(9, ["x"], figure).recorded(50, &reference.0, "").unwrap();
    let killed = Ensemble::new(9, ["x"], |run: Run| {
        assert!(run.index() != 20, "killed");
        figure(run)
    });
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    let outcome = std::panic::catch_unwind(core::panic::AssertUnwindSafe(|| {
        pool.install(|| killed.recorded(50, &scratch.0, ""))
    }));
    assert!(outcome.is_err());
    let left = fs::read(&scratch.0).unwrap();
    assert!(fs::read(&reference.0).unwrap().starts_with(&left));
    assert_eq!(Ensemble::new(9, ["x"], figure).recorded(50, &scratch.0, "").unwrap(), whole);
    assert_eq!(fs::read(&scratch.0).unwrap(), fs::read(&reference.0).unwrap());
}

#[test]
fn a_longer_file_serves_a_shorter_ensemble_and_the_other_way_round() {
    let scratch = Scratch::new("longer");
    let long = pendulums().recorded(30, &scratch.0, "").unwrap();
    let bytes = fs::read(&scratch.0).unwrap();
    let short = pendulums().recorded(10, &scratch.0, "").unwrap();
    assert_eq!(short.outcomes(), &long.outcomes()[..10]);
    assert_eq!(fs::read(&scratch.0).unwrap(), bytes);
    let longer = pendulums().recorded(40, &scratch.0, "").unwrap();
    assert_eq!(longer, pendulums().runs(40));
}

/// Refuses the file for each reason, and leaves every byte of it.
#[test]
fn a_file_of_another_ensemble_is_refused_and_left_alone() {
    let scratch = Scratch::new("another");
    let figure = |mut run: Run| Ok::<_, Error>([run.random::<f64>()]);
    let other = |mut run: Run| Ok::<_, Error>([2.0 * run.random::<f64>()]);
    Ensemble::new(1, ["x"], figure).recorded(5, &scratch.0, "gain 3").unwrap();
    let bytes = fs::read(&scratch.0).unwrap();
    let attempts = [
        Ensemble::new(2, ["x"], figure).recorded(5, &scratch.0, "gain 3"),
        Ensemble::new(1, ["y"], figure).recorded(5, &scratch.0, "gain 3"),
        Ensemble::new(1, ["x"], figure).recorded(5, &scratch.0, "gain 4"),
        Ensemble::new(1, ["x"], figure).recorded(5, &scratch.0, "gain 3, more"),
    ];
    for attempt in attempts {
        assert!(matches!(attempt, Err(RecordError::Foreign { .. })), "{attempt:?}");
    }
    let changed = Ensemble::new(1, ["x"], other).recorded(9, &scratch.0, "gain 3");
    assert!(matches!(changed, Err(RecordError::Changed { index: 0, .. })), "{changed:?}");
    assert_eq!(fs::read(&scratch.0).unwrap(), bytes);

    for foreign in ["a letter to a friend", "a letter to a friend\n", "#\n"] {
        fs::write(&scratch.0, foreign).unwrap();
        let attempt = Ensemble::new(1, ["x"], figure).recorded(5, &scratch.0, "gain 3");
        assert!(matches!(attempt, Err(RecordError::Foreign { .. })), "{attempt:?}");
        assert_eq!(fs::read_to_string(&scratch.0).unwrap(), foreign);
    }
}

#[test]
fn lines_that_are_not_the_next_run_are_refused_and_left_alone() {
    let scratch = Scratch::new("lines");
    let figure = |run: Run| Ok::<_, Error>([run.index() as f64]);
    let ensemble = Ensemble::new(1, ["x"], figure);
    ensemble.recorded(3, &scratch.0, "").unwrap();
    let good = fs::read_to_string(&scratch.0).unwrap();
    for (from, to) in [
        ("\n1,1.0,\n", "\n2,1.0,\n"),
        ("\n1,1.0,\n", "\n1,1,\n"),
        ("\n1,1.0,\n", "\n1,NaN,\n"),
        ("\n1,1.0,\n", "\n1,1.0\n"),
        ("\n1,1.0,\n", "\n1,1.0,lost\n"),
        ("\n1,1.0,\n", "\n1,one,\n"),
        ("\n1,1.0,\n", "\n1,1.0,,\n"),
        ("\n1,1.0,\n", "\n\n1,1.0,\n"),
        ("\n1,1.0,\n", "\n\0\0\0\n"),
    ] {
        let bad = good.replace(from, to);
        assert_ne!(bad, good);
        fs::write(&scratch.0, &bad).unwrap();
        let attempt = ensemble.recorded(3, &scratch.0, "");
        assert!(matches!(attempt, Err(RecordError::Malformed { index: 1, .. })), "{attempt:?}");
        assert_eq!(fs::read_to_string(&scratch.0).unwrap(), bad);
    }
}

/// While one ensemble writes, its own experiment tries to write the same file with another.
#[test]
fn a_file_that_is_being_written_is_busy() {
    let scratch = Scratch::new("busy");
    let inner = Ensemble::new(1, ["x"], |_| Ok::<_, Error>([1.0]));
    let outer = Ensemble::new(1, ["busy"], |_| {
        let attempt = inner.recorded(1, &scratch.0, "");
        Ok::<_, Error>([f64::from(u8::from(matches!(attempt, Err(RecordError::Busy))))])
    });
    assert_eq!(outer.recorded(1, &scratch.0, "").unwrap().outcomes(), [Ok([1.0])]);
    // Afterwards it is foreign, but free.
    assert!(matches!(inner.recorded(1, &scratch.0, ""), Err(RecordError::Foreign { .. })));
}

#[test]
fn a_folder_that_does_not_exist_is_an_error() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no such folder").join("runs.csv");
    assert!(matches!(pendulums().recorded(1, path, ""), Err(RecordError::Io(_))));
}
