use nalgebra::SVector;

use super::{Firing, Grid, Inputs, Network, Over, Rules, Triangular, grades::Grades};
use crate::{Error, Scalar, error::positive, scalar::constant};

/// A zeroth-order Takagi–Sugeno–Kang network with I inputs, K [`Triangular`] memberships an input and Kᴵ rules: u_n = Σ_r w̃_r(e)·f_r.
///
/// At most 2ᴵ rules fire, and no exponential is taken. Where neighbours have their feet at each other's peaks, as in
/// [`evenly_spaced`](Self::evenly_spaced), it interpolates: u_n is f_r at the peaks of rule r and multilinear in between, so it represents every function
/// that is linear in each input without error.
///
/// Outside of all feet of an input, its nearest membership fires alone; so u_n goes on as the constant that it is at the outermost peak, and in a gap
/// between two supports it jumps in the middle. No quotient is 0/0.
///
/// Its memberships do not travel: learn with antecedents that are [`Fixed`](crate::learning::Fixed).
///
/// ```
/// use brunovsky::{fuzzy::TriangularNetwork, learning::Fixed, prelude::*};
///
/// let network = TriangularNetwork::<f64, 2, 3>::evenly_spaced([1.0, 1.0])?;
/// let rule = SlidingMode::new(2.0)?.with_antecedents(Fixed);
/// let learner = NeuroFuzzy::new(network, BackwardDifference::new(), rule);
/// # let _ = learner;
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TriangularNetwork<T: Scalar, const I: usize, const K: usize>
where
    Inputs<I>: Grid,
{
    memberships: [[Triangular<T>; K]; I],
    consequents: Rules<T, I, K>,
}

impl<T: Scalar, const I: usize, const K: usize> TriangularNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    /// A network with the given memberships and all consequents zero.
    pub fn new(memberships: [[Triangular<T>; K]; I]) -> Self {
        const { assert!(K > 0, "a fuzzy network needs at least one membership an input") };
        Self { memberships, consequents: Rules::filled(T::zero()) }
    }

    /// K peaks evenly spaced over \[−rangeᵢ, rangeᵢ\] for each input, with feet at the neighbours' peaks; one alone at 0 with feet at ±rangeᵢ. Consequents
    /// are zero.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for a range that is not positive and finite, or whose spacing is not.
    pub fn evenly_spaced(ranges: [T; I]) -> Result<Self, Error> {
        let one = T::one();
        let mut memberships = [[Triangular::new(-one, T::zero(), one)?; K]; I];
        for (row, range) in memberships.iter_mut().zip(ranges) {
            positive("range", range)?;
            let intervals = constant::<T>(K.saturating_sub(1).max(1) as f64);
            let width = if K > 1 { range / intervals * constant(2.0) } else { range };
            let spacing = positive("spacing of memberships", width)?;
            let place = |k: f64| spacing * constant(k - 0.5 * K.saturating_sub(1) as f64);
            for (k, membership) in row.iter_mut().enumerate() {
                let k = k as f64;
                *membership = Triangular::new(place(k - 1.0), place(k), place(k + 1.0))?;
            }
        }
        Ok(Self::new(memberships))
    }

    /// The membership functions, one row an input.
    pub fn memberships(&self) -> [[Triangular<T>; K]; I] {
        self.memberships
    }

    /// The consequents f_r, in the order of the rules.
    pub fn consequents(&self) -> Rules<T, I, K> {
        self.consequents
    }

    /// Replaces the consequents f_r.
    ///
    /// # Errors
    /// [`Error::Length`] unless there are Kᴵ of them, [`Error::NonFinite`] for one that is not finite; the network is then as before.
    pub fn set_consequents(&mut self, consequents: &[T]) -> Result<(), Error> {
        self.consequents = Rules::consequents(consequents)?;
        Ok(())
    }
}

impl<T: Scalar, const I: usize, const K: usize> Network for TriangularNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    type Scalar = T;
    type Input = SVector<T, I>;
    type Firing = Firing<T, I, K>;

    fn fire(&self, e: &SVector<T, I>) -> Firing<T, I, K> {
        let mut rows = [[T::zero(); K]; I];
        for ((shares, row), e) in rows.iter_mut().zip(&self.memberships).zip(e.iter()) {
            *shares = Triangular::shares(row, *e);
        }
        Firing::of(Grades::of(rows))
    }

    fn output(&self, firing: &Firing<T, I, K>) -> T {
        self.consequents.mean(firing.grades.rows())
    }

    fn move_consequents(&mut self, firing: &Firing<T, I, K>, rate: T) {
        self.consequents.add(firing.grades.rows(), rate);
    }

    fn change_consequents(&mut self, change: impl FnOnce(&mut [T])) {
        change(&mut self.consequents);
    }
}

impl<T: Scalar, const I: usize, const K: usize> Over<T, I> for TriangularNetwork<T, I, K> where
    Inputs<I>: Grid
{
}

checked! {
    [T: Scalar, const I: usize, const K: usize] TriangularNetwork<T, I, K>, [T; Inputs<I>: Grid]
    {
        memberships: Array<Array<Triangular<T>, K>, I> = Array(memberships.map(Array)),
        consequents: Rules<T, I, K>,
    } => {
        let mut network = Self::new(memberships.0.map(|row| row.0));
        network.set_consequents(&consequents).map(|()| network)
    }
}
