use super::AdaptationRule;
#[cfg(feature = "serde")]
use crate::error::{at_most, finite};
use crate::{
    Error, Scalar,
    error::positive,
    fuzzy::{Grid, Inputs, Network, Rules, Strengths},
    scalar::constant,
};

/// Recursive least squares on the consequents, which finds those with the smallest sum of squares Σ (w̃ᵀf − u_n − s)² over all samples so far:
///
/// k = P·w̃/(λ + r), f⁺ = f + k·s, P⁺ = P − (1 − (1 − λ)/r)·k·w̃ᵀP, r = w̃ᵀPw̃,
///
/// with the forgetting factor λ = e^{−h/τ}, at least ½, and 1 without a memory τ. As u_n + s = −Δ, it fits −Δ as a function of e. A step leaves
/// λ/(λ + r) of s at that e, so a constant Δ is learned without overshoot; with an input gain b for the model's b̂, while b/b̂ < 2.
///
/// P stands for what is not known of the consequents, in units of the variance of s, and starts as P(0) = p·𝟙: p large learns in a few samples
/// and believes every one, p small asks for many. Without a memory the gain goes to 0 like 1/k.
///
/// **It forgets where it learns** (directional forgetting). A loop that does its work brings e to rest, and plain exponential forgetting, P/λ, would forget
/// all the rules that are not in use there, and blow P up. Here the sample replaces what was known in its own direction, and nothing else: while e rests,
/// u_n is the mean of −Δ over the memory, weighted with λ for every sample since, and what was learned elsewhere is still there when e comes back.
///
/// **P is bounded.** tr P ≤ tr P(0): where forgetting would pass that, it forgets less.
///
/// **P stays positive.** It is kept as P = U·D·Uᵀ, U upper triangular with ones on its diagonal, D diagonal, and changed by Bierman's method, which
/// multiplies the entries of D by positive numbers.
///
/// The consequents are of one network, at antecedents that are [`Fixed`](super::Fixed). The state is one number for each pair of rules, Kᴵ·Kᴵ in
/// all, on the stack and copied at every sample: 81 for I = 2, K = 3; 729 for I = 3, K = 3; 6561 for I = 4, K = 3. A step costs about 3·Kᴵ·Kᴵ
/// multiplications. Use [`GradientDescent`](super::GradientDescent) where that is too much.
///
/// ```
/// use brunovsky::{learning::RecursiveLeastSquares, prelude::*};
///
/// let rule = RecursiveLeastSquares::new(100.0)?.with_memory(20.0)?;
/// // The size of its state follows from the network.
/// let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([1.0, 1.0])?;
/// let learner = NeuroFuzzy::new(network, ModelAided::new(), rule);
/// # let _ = learner;
/// # Ok::<(), brunovsky::Error>(())
/// ```
///
/// # References
/// R. Kulhavý, "Restricted exponential forgetting in real-time identification", Automatica 23(5), 1987.
/// G. J. Bierman, "Factorization Methods for Discrete Sequential Estimation", Academic Press, 1977, chapter V.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecursiveLeastSquares<T: Scalar, const I: usize, const K: usize>
where
    Inputs<I>: Grid,
{
    /// Row j is column j of U above the diagonal, and d_j on it.
    factors: Rules<Rules<T, I, K>, I, K>,
    variance: T,
    /// τ.
    memory: Option<T>,
}

impl<T: Scalar, const I: usize, const K: usize> RecursiveLeastSquares<T, I, K>
where
    Inputs<I>: Grid,
{
    /// The rule with P(0) = `variance`·𝟙, p > 0, that never forgets.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for p, or for p times the number of rules.
    pub fn new(variance: T) -> Result<Self, Error> {
        positive("variance", variance)?;
        let mut factors = Rules::filled(Rules::filled(T::zero()));
        for (j, row) in factors.iter_mut().enumerate() {
            if let Some(d) = row.get_mut(j) {
                *d = variance;
            }
        }
        let rule = Self { factors, variance, memory: None };
        positive("trace of the covariance", rule.most())?;
        Ok(rule)
    }

    /// The same rule with a `memory` of τ > 0 seconds, λ = e^{−h/τ}.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_memory(self, memory: T) -> Result<Self, Error> {
        Ok(Self { memory: Some(positive("memory", memory)?), ..self })
    }

    /// tr P, how little is known of the consequents: at most p·Kᴵ.
    pub fn uncertainty(&self) -> T {
        self.factors.iter().enumerate().fold(T::zero(), |trace, (j, column)| {
            let d = column.get(j).copied().unwrap_or(T::zero());
            // d·u² is at most the trace, u² alone may leave the range.
            column.iter().take(j).fold(trace + d, |sum, u| sum + d * *u * *u)
        })
    }

    /// The same, if its factors are those of a covariance that this rule comes to.
    #[cfg(feature = "serde")]
    fn factored(self) -> Result<Self, Error> {
        for (j, column) in self.factors.iter().enumerate() {
            for (i, entry) in column.iter().enumerate() {
                finite("factor of the covariance", *entry)?;
                if i == j {
                    positive("diagonal factor of the covariance", *entry)?;
                } else if i > j {
                    at_most("size of what is below the factors", entry.abs(), T::zero())?;
                }
            }
        }
        let trace = finite("trace of the covariance", self.uncertainty())?;
        // What forgetting fills up to P(0) is rounded.
        let most = self.most() * constant(1.0 + 1e-3);
        at_most("trace of the covariance", trace, most)?;
        Ok(self)
    }

    /// tr P(0).
    fn most(&self) -> T {
        self.variance * constant(self.factors.len() as f64)
    }

    /// P·w̃ and w̃ᵀPw̃.
    fn weighed(&self, w: &[T]) -> (Rules<T, I, K>, T) {
        let (mut weighed, mut r) = (Rules::<T, I, K>::filled(T::zero()), T::zero());
        for (j, (column, w_j)) in self.factors.iter().zip(w).enumerate() {
            let f = column.iter().zip(w).take(j).fold(*w_j, |sum, (u, w)| sum + *u * *w);
            let g = column.get(j).map_or(T::zero(), |d| *d * f);
            r += f * g;
            for (sum, u) in weighed.iter_mut().zip(column.iter()).take(j) {
                *sum += *u * g;
            }
            if let Some(sum) = weighed.get_mut(j) {
                *sum += g;
            }
        }
        (weighed, r)
    }

    /// P⁻¹ ↦ P⁻¹ + β·w̃w̃ᵀ, where β·w̃ᵀPw̃ > −1.
    fn inform(&mut self, w: &[T], beta: T) {
        let mut weighed = Rules::<T, I, K>::filled(T::zero());
        // 1 + β·w̃ᵀPw̃, as far as the columns before this one go.
        let mut alpha = T::one();
        for (j, (column, w_j)) in self.factors.iter_mut().zip(w).enumerate() {
            let (above, rest) = column.split_at_mut(j.min(w.len()));
            let Some(d) = rest.first_mut() else { break };
            let f = above.iter().zip(w).fold(*w_j, |sum, (u, w)| sum + *u * *w);
            let g = *d * f;
            let before = alpha;
            alpha += beta * f * g;
            *d *= before / alpha;
            for (u, sum) in above.iter_mut().zip(weighed.iter_mut()) {
                let old = *u;
                *u -= beta * f / before * *sum;
                *sum += g * old;
            }
            if let Some(sum) = weighed.get_mut(j) {
                *sum = g;
            }
        }
    }

    /// Takes in a sample at the strengths `w`, and the gain k that belongs to it.
    fn measured(&mut self, w: &[T], dt: T) -> Rules<T, I, K> {
        let (mut gain, r) = self.weighed(w);
        let square = gain.iter().fold(T::zero(), |sum, v| sum + *v * *v);
        if square.is_zero() || r <= T::zero() {
            // Nothing is left to learn there.
            return Rules::filled(T::zero());
        }
        // What the sample adds to the information in its direction, less what is forgotten there.
        let beta = self.memory.map_or(T::one(), |memory| {
            let lambda = (-dt / memory).exp().max(constant(0.5));
            let beta = T::one() - (T::one() - lambda) / r;
            if beta >= T::zero() {
                return beta;
            }
            let room = (self.most() - self.uncertainty()).max(T::zero());
            beta.max(-(square / room + r).recip())
        });
        self.inform(w, beta);
        let scale = T::one() + beta * r;
        for k in gain.iter_mut() {
            *k /= scale;
        }
        gain
    }
}

impl<T, W, const I: usize, const K: usize> AdaptationRule<W> for RecursiveLeastSquares<T, I, K>
where
    T: Scalar,
    W: Network<Scalar = T, Firing: Strengths<T, Rules = Rules<T, I, K>>>,
    Inputs<I>: Grid,
{
    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: T, dt: T) {
        let gain = self.measured(&firing.strengths(), dt);
        network.change_consequents(|consequents| {
            for (f, k) in consequents.iter_mut().zip(gain.iter()) {
                *f += *k * s;
            }
        });
    }
}

checked! {
    [T: Scalar, const I: usize, const K: usize] RecursiveLeastSquares<T, I, K>,
    [T; Inputs<I>: Grid]
    { factors: Rules<Rules<T, I, K>, I, K>, variance: T, memory: Option<T> } =>
    Self::new(variance).and_then(|new| {
        let new = match memory {
            Some(memory) => new.with_memory(memory)?,
            None => new,
        };
        Self { factors, ..new }.factored()
    })
}
