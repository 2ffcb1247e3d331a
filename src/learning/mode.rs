/// What a learner is to do at a sample.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LearningMode {
    /// u_n = 0 and nothing is learned: feedback linearization, bit for bit. What was learned is kept, and s is still watched.
    Off,
    /// u_n is what was learned so far, and nothing is learned.
    Frozen,
    /// u_n is added and learned.
    #[default]
    Active,
}
