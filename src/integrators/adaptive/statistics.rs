/// What a [`Solver`](super::Solver) has spent.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Statistics {
    /// Evaluations of f, those for finite differences included.
    pub evaluations: u64,
    /// Steps within the tolerance.
    pub accepted: u64,
    /// Steps that were tried and discarded: their error was too large, or they met a number that is not finite.
    pub rejected: u64,
    /// Linearizations of f, one for each start of a step of a stiff method.
    pub jacobians: u64,
    /// LU factorizations, one for each step that a stiff method tried.
    pub factorizations: u64,
}
