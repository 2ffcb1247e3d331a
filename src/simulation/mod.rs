//! The laboratory: a sampled controller on a continuous plant, and figures of merit for what comes out.
//!
//! [`Simulation`] is an iterator of [`Sample`]s, so `step_by`, `zip`, `take_while` and `collect::<Result<Vec<_>, _>>()` are its recorder.
//! [`StepInfo`] measures a response by the definitions of MATLAB's `stepinfo`, [`ErrorMetrics`] integrates an error,
//! [`TotalVariation`] counts how much a signal moves; all three take a signal one sample at a time and allocate nothing.
//!
//! `Recording` (feature `csv`) keeps signals in files.
//!
//! This module depends on all others, and none on it.

mod closed_loop;
mod error_metrics;
mod hardware;
#[cfg(feature = "csv")]
mod recording;
mod sample;
mod sensor;
mod step_info;
mod total_variation;

pub use closed_loop::Simulation;
pub use error_metrics::ErrorMetrics;
pub use hardware::Hardware;
#[cfg(feature = "csv")]
pub use recording::{Column, Recording, RecordingError};
pub use sample::{Sample, Tick};
pub use sensor::{Sensor, Sensors, State, Truth};
pub use step_info::StepInfo;
pub use total_variation::TotalVariation;
