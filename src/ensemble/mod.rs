//! Many runs of one experiment: Monte Carlo ensembles, parameter sweeps, and what can be said of them (feature `ensemble`).
//!
//! An experiment is a closure from a [`Run`] to M named figures, or to an `Err`. The run brings an index and random numbers that follow from
//! (seed, index) alone: whatever the number of threads, and whether it is one of 10⁵ or repeated alone, run i is the same to the last bit.
//!
//! ```
//! use brunovsky::ensemble::{Ensemble, Run, rand::RngExt};
//! use brunovsky::{plant::Pendulum, prelude::*};
//!
//! let believed = Pendulum::<f64>::new(1.0, 0.5, 0.1, 9.81)?;
//! let ensemble = Ensemble::new(7, ["steady error in rad"], |mut run: Run| {
//!     let true_one = Pendulum::new(run.random_range(0.8..1.2), 0.5, 0.1, 9.81)?;
//!     let start = [run.random_range(-0.5..0.5), 0.0];
//!     let flc = FeedbackLinearization::new(believed, Gains::from_lambda(4.0)?);
//!     let run = Simulation::new(&true_one, flc, |_| Reference::setpoint(1.0), start, 0.01)?;
//!     let mut off = 0.0;
//!     for sample in run.until(5.0)? {
//!         off = (1.0 - sample?.x[0]).abs();
//!     }
//!     Ok::<_, Error>([off])
//! });
//! let runs = ensemble.runs(100);
//! let [off] = runs.summaries(0.95)?;
//! println!("mean {:.4}, 95 % quantile {:.4}", off.mean()?, off.quantile(0.95)?);
//!
//! let worst = off.worst().ok_or(Error::Missing { name: "completed run" })?;
//! assert_eq!(ensemble.run(worst.index), Ok([worst.value])); // the worst case again, alone
//! # Ok::<(), brunovsky::Error>(())
//! ```
//!
//! | what | with |
//! |---|---|
//! | many runs, in parallel | [`Ensemble::runs`] |
//! | the same, kept in a file and resumed from it | [`Ensemble::recorded`] |
//! | one run alone | [`Ensemble::run`], or [`Run::new`] for an experiment that returns more than its figures |
//! | every combination of gains or parameters, or a Latin hypercube of them | [`Sweep`] over a [`Design`] |
//! | mean, quantiles, share of failures, each with its confidence interval | [`Summary`], [`Runs::failure_rate`] |
//!
//! # Failures
//! A run fails if the experiment returns `Err` or a figure is not finite. An experiment says itself what it calls divergence:
//! `Err(Error::NotBelow { name: "distance in m", value, limit })`, say. Failed runs are not lost: [`Runs::failures`] lists index and reason.
//!
//! Figures are costs: smaller is better. A failed run is worse than every completed one, so in a **quantile it counts as +∞**, and failing
//! cannot improve it. A **mean is that of the completed runs**, as no number stands for a failure; read it beside
//! [`Runs::failure_rate`].
//!
//! # Features
//! * `parallel`: runs on all cores, in the [`rayon`](https://docs.rs/rayon) pool that is current. Without it they run one after the other.
//! * `progress`: `Ensemble::with_progress`, a bar on the terminal.
//!
//! The room needs the standard library. It depends on no other: what an experiment does is its own.

mod design;
mod estimate;
mod grid;
mod in_order;
mod latin_hypercube;
mod mean;
mod order_statistics;
mod progress;
mod proportion;
mod record;
mod run;
mod runner;
mod runs;
mod summary;
mod sweep;

pub use design::{Axis, Design};
pub use estimate::Estimate;
pub use grid::Levels;
pub use rand;
pub use record::RecordError;
pub use run::Run;
pub use runner::{Ensemble, Outcome};
pub use runs::Runs;
pub use summary::{Case, Summary};
pub use sweep::{Map, Sweep};
