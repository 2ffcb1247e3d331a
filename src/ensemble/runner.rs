use core::{convert::Infallible, fmt, ops::Range};
use std::{
    boxed::Box,
    path::Path,
    string::{String, ToString},
    sync::{Mutex, PoisonError},
    vec::Vec,
};

use super::{
    Run, Runs,
    in_order::InOrder,
    progress::Progress,
    record::{Record, RecordError},
};
use crate::Error;

/// The figures of a run, or why it failed.
pub type Outcome<const M: usize> = Result<[f64; M], String>;

/// An experiment that can be run many times: a closure from [`Run`] to M named figures.
pub struct Ensemble<'a, const M: usize> {
    seed: u64,
    names: [&'static str; M],
    experiment: Box<dyn Fn(u64) -> Outcome<M> + Send + Sync + 'a>,
    progress: bool,
}

impl<'a, const M: usize> Ensemble<'a, M> {
    /// Runs of `experiment`, whose results are the figures of `names`, in that order; a name should bring its unit.
    ///
    /// The experiment must not depend on anything but its [`Run`]; a static counter, say, would make it another one each time.
    pub fn new<E: fmt::Display>(
        seed: u64,
        names: [&'static str; M],
        experiment: impl Fn(Run) -> Result<[f64; M], E> + Send + Sync + 'a,
    ) -> Self {
        Self::of_indices(seed, names, move |index| experiment(Run::new(seed, index)))
    }

    /// The same for an experiment that makes its [`Run`] itself.
    pub(super) fn of_indices<E: fmt::Display>(
        seed: u64,
        names: [&'static str; M],
        experiment: impl Fn(u64) -> Result<[f64; M], E> + Send + Sync + 'a,
    ) -> Self {
        let experiment = move |index| match experiment(index) {
            Ok(figures) => finite(&names, figures),
            Err(error) => Err(reason(&error)),
        };
        Self { seed, names, experiment: Box::new(experiment), progress: false }
    }

    /// With a bar on the terminal while it runs; nothing is drawn where the standard error output is not a terminal.
    #[cfg(feature = "progress")]
    pub fn with_progress(self) -> Self {
        Self { progress: true, ..self }
    }

    /// Run `index` alone.
    pub fn run(&self, index: u64) -> Outcome<M> {
        (self.experiment)(index)
    }

    /// Runs 0 to `count` − 1.
    ///
    /// With the feature `parallel` they run in the current pool of `rayon`: on all cores, on as many threads as `RAYON_NUM_THREADS` says, or
    /// on those of the pool whose `install` this is called in. The result is the same.
    pub fn runs(&self, count: u64) -> Runs<M> {
        let Ok(runs) = self.conduct(Vec::new(), count, |_, _| Ok::<_, Infallible>(()));
        runs
    }

    /// Runs 0 to `count` − 1, each written to the file `path` as soon as it and all before it are done; those that the file has already are
    /// taken from there.
    ///
    /// The file is CSV with the run's index, its figures, and the reason if it failed, under a line that names the crate's version, the seed,
    /// and the `configuration`: whatever else decides what the experiment does, and the program cannot see, as text. Runs are only ever
    /// appended, in order, so after an interruption the file is that of a shorter ensemble, but for a torn last line, which is cut off. It
    /// may have more than `count` runs.
    ///
    /// # Errors
    /// [`RecordError::Foreign`] for a file of another version, seed, configuration or set of figures, [`RecordError::Changed`] if the file's
    /// first run, repeated, is not what the file says, [`RecordError::Malformed`] for a line that is not a run,
    /// [`RecordError::Busy`] if another process writes to it, [`RecordError::Io`]. A file that is refused is left as it was.
    pub fn recorded(
        &self,
        count: u64,
        path: impl AsRef<Path>,
        configuration: &str,
    ) -> Result<Runs<M>, RecordError> {
        let (mut record, done) =
            Record::open(path.as_ref(), self.seed, &self.names, configuration, |index| {
                self.run(index)
            })?;
        let runs = self.conduct(done, count, |index, outcome| record.append(index, outcome))?;
        record.finish()?;
        Ok(runs)
    }

    /// The runs that are `done`, and those that are missing to `count`; each of these is given to `sink`, in order.
    fn conduct<E: Send>(
        &self,
        done: Vec<Outcome<M>>,
        count: u64,
        sink: impl FnMut(u64, &Outcome<M>) -> Result<(), E> + Send,
    ) -> Result<Runs<M>, E> {
        let first = done.len() as u64;
        let progress = Progress::new(self.progress, first, count);
        let results = Mutex::new(InOrder::new(done, sink));
        each(first..count, |index| {
            let outcome = self.run(index);
            progress.advance();
            results.lock().unwrap_or_else(PoisonError::into_inner).take(index, outcome)
        })?;
        let mut outcomes =
            results.into_inner().unwrap_or_else(PoisonError::into_inner).into_results();
        outcomes.truncate(usize::try_from(count).unwrap_or(usize::MAX));
        Ok(Runs::new(self.names, outcomes))
    }
}

/// What stands for the closure is its seed and its figures.
impl<const M: usize> fmt::Debug for Ensemble<'_, M> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Ensemble")
            .field("seed", &self.seed)
            .field("names", &self.names)
            .finish_non_exhaustive()
    }
}

/// `figures`, or which of them is not finite.
pub(super) fn finite<const M: usize>(names: &[&'static str; M], figures: [f64; M]) -> Outcome<M> {
    match names.iter().zip(figures).find(|(_, value)| !value.is_finite()) {
        None => Ok(figures),
        Some((name, value)) => Err(reason(&Error::NonFinite { name, value })),
    }
}

/// The reason as one line that is not empty.
fn reason(error: &impl fmt::Display) -> String {
    let line = error.to_string().replace(['\n', '\r'], " ");
    if line.is_empty() { "failed".to_string() } else { line }
}

/// `f` of all `indices` until one fails, begun in their order: the bridge hands them out one by one, so that results come nearly in order and
/// few have to wait for an earlier one.
#[cfg(feature = "parallel")]
fn each<E: Send>(
    indices: Range<u64>,
    f: impl Fn(u64) -> Result<(), E> + Send + Sync,
) -> Result<(), E> {
    use rayon::iter::{ParallelBridge, ParallelIterator};
    indices.par_bridge().try_for_each(f)
}

/// `f` of all `indices` in their order until one fails.
#[cfg(not(feature = "parallel"))]
fn each<E>(mut indices: Range<u64>, f: impl Fn(u64) -> Result<(), E>) -> Result<(), E> {
    indices.try_for_each(f)
}
