//! Plants by their equations: Lie derivatives, relative degree, Jacobians and the chain form.

mod box_samples;
mod errors;
mod invariance;
mod jacobians;
mod lie_derivatives;
mod linearized;
mod relative_degree;
mod strange;
