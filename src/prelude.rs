//! Everything that a typical program names: `use brunovsky::prelude::*;`.

pub use crate::{
    Error, Scalar,
    controller::{
        Accept, Clelc, Command, Controller, Decoupling, FeedbackLinearization, Gains, Limited,
        Measurement, Mode, Reference, Supervised,
    },
    fuzzy::{FuzzyNetwork, Gaussian},
    integrators::{Adaptive, DormandPrince, Euler, Heun, Integrator, Rk4, Rodas, Tolerance},
    learning::{
        Antecedents, BackwardDifference, Certificate, Compensator, FilteredDifference,
        GradientDescent, Guarded, LearningMode, Measured, ModelAided, Monitor, NeuroFuzzy,
        NullCompensator, NullRule, SlidingMode, Switching, Watchdog,
    },
    plant::{ControlAffine, FeedbackLinearizable, Plant, Uncertain},
    simulation::{ErrorMetrics, Hardware, Sensors, Simulation, StepInfo, TotalVariation},
    trajectory::Trajectory,
};
pub use nalgebra::{SMatrix, SVector};
