//! Everything that a typical program names: `use brunovsky::prelude::*;`.

pub use crate::{
    Error, Scalar,
    controller::{
        Accept, AntiWindup, Backstepping, Clelc, Command, Compensated, Controller, Decoupling,
        FeedbackLinearization, Gains, Limited, Measurement, Mode, ModelReferenceAdaptive, Pid,
        PidGains, Reference, StateFeedback, Supervised,
    },
    fuzzy::{FuzzyNetwork, Gaussian, Network},
    integrators::{Adaptive, DormandPrince, Euler, Heun, Integrator, Rk4, Rodas, Tolerance},
    learning::{
        BackwardDifference, Certificate, Compensator, FilteredDifference, Fixed, Flow,
        GradientDescent, Guarded, LearningMode, Measured, ModelAided, Monitor, NeuroFuzzy,
        NullCompensator, NullRule, SlidingMode, Switching, Watchdog,
    },
    plant::{ControlAffine, FeedbackLinearizable, Plant, Uncertain},
    simulation::{ErrorMetrics, Hardware, Sensors, Simulation, StepInfo, TotalVariation},
    trajectory::Trajectory,
};
pub use nalgebra::{SMatrix, SVector};
