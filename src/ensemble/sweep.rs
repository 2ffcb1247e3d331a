use core::fmt;
use std::{
    format,
    io::Write,
    path::Path,
    string::{String, ToString},
    vec::Vec,
};

use super::{Design, Ensemble, Outcome, RecordError, Run, Runs};
use crate::Error;

/// An experiment that is run at every point of a [`Design`], several times at each.
///
/// Replica i has the random numbers of run i of an [`Ensemble`] with the same seed, at every point: differences between points are not
/// blurred by different noise (common random numbers).
///
/// ```
/// use brunovsky::ensemble::{Axis, Design, Run, Sweep};
///
/// let gain = Axis::linear("k", 0.5, 2.5)?;
/// let period = Axis::logarithmic("h in s", 0.1, 1.0)?;
/// let grid = Design::grid([gain.levels(5)?, period.levels(3)?]);
/// // ẋ = −k·x by explicit Euler.
/// let sweep = Sweep::new(grid, 1, 0, ["|x| after 50 steps"], |[k, h]: [f64; 2], _run: Run| {
///     Ok::<_, brunovsky::Error>([(1.0 - k * h).abs().powi(50)])
/// })?;
/// for ([k, h], runs) in sweep.map().cells() {
///     let stable = runs.completed().all(|(_, [x])| *x < 1.0);
///     assert_eq!(stable, k * h < 2.0);
/// }
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug)]
pub struct Sweep<'a, const D: usize, const M: usize> {
    design: Design<D>,
    replicas: u64,
    ensemble: Ensemble<'a, M>,
}

impl<'a, const D: usize, const M: usize> Sweep<'a, D, M> {
    /// `replicas` ≥ 1 runs of `experiment` at each point of the `design`; its results are the figures of `names`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0 replicas.
    pub fn new<E: fmt::Display>(
        design: Design<D>,
        replicas: u64,
        seed: u64,
        names: [&'static str; M],
        experiment: impl Fn([f64; D], Run) -> Result<[f64; M], E> + Send + Sync + 'a,
    ) -> Result<Self, Error> {
        if replicas == 0 {
            return Err(Error::NotPositive { name: "replicas", value: 0.0 });
        }
        let points = design.points().to_vec();
        let ensemble = Ensemble::of_indices(seed, names, move |index| {
            let point = usize::try_from(index / replicas).ok().and_then(|point| points.get(point));
            let point = point.ok_or_else(|| format!("there is no point {}", index / replicas))?;
            experiment(*point, Run::new(seed, index % replicas)).map_err(|error| error.to_string())
        });
        Ok(Self { design, replicas, ensemble })
    }

    /// With a bar on the terminal while it runs; nothing is drawn where the standard error output is not a terminal.
    #[cfg(feature = "progress")]
    pub fn with_progress(self) -> Self {
        Self { ensemble: self.ensemble.with_progress(), ..self }
    }

    /// One replica at one point, alone; both count from 0.
    pub fn run(&self, point: u64, replica: u64) -> Outcome<M> {
        if replica >= self.replicas {
            return Err(format!("there is no replica {replica}"));
        }
        self.ensemble.run(point.saturating_mul(self.replicas).saturating_add(replica))
    }

    /// All runs, in parallel as [`Ensemble::runs`].
    pub fn map(&self) -> Map<D, M> {
        self.cut(&self.ensemble.runs(self.count()))
    }

    /// All runs, kept in the file `path` and resumed from it as [`Ensemble::recorded`]; the design and the number of replicas belong to the
    /// configuration.
    ///
    /// # Errors
    /// As [`Ensemble::recorded`].
    pub fn recorded(
        &self,
        path: impl AsRef<Path>,
        configuration: &str,
    ) -> Result<Map<D, M>, RecordError> {
        let (replicas, design) = (self.replicas, self.design.description());
        let configuration = format!("{configuration}, {replicas} replicas, {design}");
        Ok(self.cut(&self.ensemble.recorded(self.count(), path, &configuration)?))
    }

    fn count(&self) -> u64 {
        (self.design.points().len() as u64).saturating_mul(self.replicas)
    }

    fn cut(&self, runs: &Runs<M>) -> Map<D, M> {
        let replicas = usize::try_from(self.replicas).unwrap_or(usize::MAX);
        let cell = |outcomes: &[Outcome<M>]| Runs::new(*runs.names(), outcomes.to_vec());
        Map {
            design: self.design.clone(),
            cells: runs.outcomes().chunks(replicas).map(cell).collect(),
        }
    }
}

/// What a [`Sweep`] found at each point.
#[derive(Debug, Clone, PartialEq)]
pub struct Map<const D: usize, const M: usize> {
    design: Design<D>,
    cells: Vec<Runs<M>>,
}

impl<const D: usize, const M: usize> Map<D, M> {
    /// The points with their runs, in the order of the design.
    pub fn cells(&self) -> impl Iterator<Item = (&[f64; D], &Runs<M>)> {
        self.design.points().iter().zip(&self.cells)
    }

    /// One number a point, in the order of the design: the pixels of a heat map, row by row.
    pub fn values(&self, f: impl Fn(&Runs<M>) -> f64) -> Vec<f64> {
        self.cells.iter().map(f).collect()
    }

    /// Writes a line a point as CSV: the parameters, the numbers of runs and of failures, and of each figure the mean of the completed runs
    /// with the ends of its interval at the confidence `level`; empty fields where no run completed.
    ///
    /// # Errors
    /// Those of writing; [`std::io::ErrorKind::InvalidInput`] for a level outside of (0, 1).
    pub fn write_csv(&self, file: impl Write, level: f64) -> std::io::Result<()> {
        let mut file = csv::Writer::from_writer(file);
        let mut header: Vec<String> = self.design.names().iter().map(ToString::to_string).collect();
        header.extend(["runs", "failed"].map(ToString::to_string));
        for name in self.cells.iter().take(1).flat_map(|runs| runs.names()) {
            header.extend(["mean", "low", "high"].map(|end| format!("{name}, {end}")));
        }
        file.write_record(header)?;
        for (point, runs) in self.cells() {
            let mut line: Vec<String> = point.iter().map(|value| format!("{value:?}")).collect();
            line.extend([runs.outcomes().len(), runs.failures().count()].map(|n| n.to_string()));
            let summaries = runs.summaries(level);
            let invalid = |error| std::io::Error::new(std::io::ErrorKind::InvalidInput, error);
            for summary in summaries.map_err(invalid)? {
                let mean = summary.mean().map(|mean| [mean.value, mean.low, mean.high]);
                line.extend(match mean {
                    Ok(values) => values.map(|value| format!("{value:?}")),
                    Err(_) => [const { String::new() }; 3],
                });
            }
            file.write_record(line)?;
        }
        file.flush()
    }
}
