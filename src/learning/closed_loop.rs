use nalgebra::SVector;

use super::LearningMode;

/// What a feedback-linearized loop of order N knows at a sample, before it learns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosedLoop<T, const N: usize> {
    /// The measured state x.
    pub x: SVector<T, N>,
    /// The error e = r − x.
    pub e: SVector<T, N>,
    /// The feedforward u_f = ṙ_n (eq_ff).
    pub u_f: T,
    /// The feedback u_b = k·e (eq_fb).
    pub u_b: T,
    /// The model's drift a(x).
    pub drift: T,
    /// The model's input gain b(x).
    pub gain: T,
    /// The input that the plant received over the period that ends at this sample; 0 before the first.
    pub u: T,
    /// The input that the loop had asked for over that period; 0 before the first.
    pub asked: T,
    /// ẋ_n measured at this sample under that input, if there is a sensor for it.
    pub rate: Option<T>,
    /// What the compensator is to do.
    pub learning: LearningMode,
}
