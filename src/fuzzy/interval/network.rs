use nalgebra::SVector;

use super::{Elliptic, IntervalMembership, TypeReduction, UncertainGaussian};
use crate::{
    Error, Scalar,
    error::{below, not_negative},
    fuzzy::{
        FuzzyNetwork, Gaussian, Grid, Inputs, Network, Over, Rules, Strengths, grades::Grades,
    },
};

/// A zeroth-order Takagi–Sugeno–Kang network of interval type 2 with I inputs, K memberships an input, of a kind `M`, and Kᴵ rules.
///
/// Each rule fires with a strength between w̲_r = Πᵢ μ̲ᵢₖ and w̄_r = Πᵢ μ̄ᵢₖ, which [`TypeReduction`] makes one number of. Over a full grid both normalized
/// strengths are outer products, and either reduction is a mean of the lower and the upper network,
///
/// w̃ = a·w̲/Σw̲ + (1 − a)·w̄/Σw̄, with a = Σw̲/(Σw̲ + Σw̄) (Nie–Tan) or 1 − m (Biglarbegian–Melek–Mendel),
///
/// which costs twice what type 1 does. The sums are products of sums over an input, and never formed: a is found from their quotient.
///
/// The memberships do not travel: learn with antecedents that are [`Fixed`](crate::learning::Fixed).
///
/// ```
/// use brunovsky::{fuzzy::{IntervalNetwork, TypeReduction}, learning::Fixed, prelude::*};
///
/// // Widths that are known to 20 %.
/// let network = IntervalNetwork::<_, f64, 2, 3>::gaussian([1.0, 1.0], 0.2, TypeReduction::NieTan)?;
/// let rule = SlidingMode::new(2.0)?.with_antecedents(Fixed);
/// let learner = NeuroFuzzy::new(network, BackwardDifference::new(), rule);
/// # let _ = learner;
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntervalNetwork<M, T: Scalar, const I: usize, const K: usize>
where
    Inputs<I>: Grid,
{
    memberships: [[M; K]; I],
    reduction: TypeReduction<T>,
    consequents: Rules<T, I, K>,
}

/// How strongly each rule of an interval type-2 network fires at one input, after type reduction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntervalFiring<T, const I: usize, const K: usize> {
    /// The lower and the upper network with their weights, which sum to 1.
    parts: [(T, Grades<T, I, K>); 2],
    norm_squared: T,
}

impl<M: IntervalMembership<T>, T: Scalar, const I: usize, const K: usize>
    IntervalNetwork<M, T, I, K>
where
    Inputs<I>: Grid,
{
    /// A network with the given memberships and all consequents zero.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::Above`] or [`Error::NonFinite`] for an m that is not between 0 and 1.
    pub fn new(memberships: [[M; K]; I], reduction: TypeReduction<T>) -> Result<Self, Error> {
        const { assert!(K > 0, "a fuzzy network needs at least one membership an input") };
        let reduction = reduction.validated()?;
        Ok(Self { memberships, reduction, consequents: Rules::filled(T::zero()) })
    }

    /// The membership functions, one row an input.
    pub fn memberships(&self) -> [[M; K]; I] {
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

impl<T: Scalar, const I: usize, const K: usize> IntervalNetwork<UncertainGaussian<T>, T, I, K>
where
    Inputs<I>: Grid,
{
    /// The memberships of [`FuzzyNetwork::evenly_spaced`], with widths from (1 − `uncertainty`)·σ to (1 + `uncertainty`)·σ, 0 ≤ `uncertainty` < 1.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for a range, its spacing or a width; [`Error::Negative`], [`Error::NotBelow`] or
    /// [`Error::NonFinite`] for the uncertainty; that of [`new`](Self::new) for the reduction.
    pub fn gaussian(
        ranges: [T; I],
        uncertainty: T,
        reduction: TypeReduction<T>,
    ) -> Result<Self, Error> {
        let one = T::one();
        below("uncertainty", not_negative("uncertainty", uncertainty)?, one)?;
        let widths = |width: T| [width * (one - uncertainty), width * (one + uncertainty)];
        Self::spaced(ranges, reduction, |own| {
            UncertainGaussian::new(own.centre(), widths(own.width()))
        })
    }
}

impl<T: Scalar, const I: usize, const K: usize> IntervalNetwork<Elliptic<T>, T, I, K>
where
    Inputs<I>: Grid,
{
    /// K memberships evenly spaced over \[−rangeᵢ, rangeᵢ\] for each input, each of which reaches to the centres of its neighbours, with the `exponents`
    /// a̲ and a̅; one alone sits at 0 and reaches to ±rangeᵢ.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for a range or its spacing; those of [`Elliptic::new`] for the exponents; that of
    /// [`new`](Self::new) for the reduction.
    pub fn elliptic(
        ranges: [T; I],
        exponents: [T; 2],
        reduction: TypeReduction<T>,
    ) -> Result<Self, Error> {
        Self::spaced(ranges, reduction, |own| Elliptic::new(own.centre(), own.width(), exponents))
    }
}

impl<M: IntervalMembership<T>, T: Scalar, const I: usize, const K: usize>
    IntervalNetwork<M, T, I, K>
where
    Inputs<I>: Grid,
{
    /// One membership for each of those that are evenly spaced.
    fn spaced(
        ranges: [T; I],
        reduction: TypeReduction<T>,
        membership: impl Fn(Gaussian<T>) -> Result<M, Error>,
    ) -> Result<Self, Error> {
        let places = FuzzyNetwork::<T, I, K>::evenly_spaced(ranges)?.memberships();
        let first = membership(Gaussian::new(T::zero(), T::one())?)?;
        let mut memberships = [[first; K]; I];
        for (own, place) in memberships.as_flattened_mut().iter_mut().zip(places.as_flattened()) {
            *own = membership(*place)?;
        }
        Self::new(memberships, reduction)
    }
}

impl<T: Scalar, const I: usize, const K: usize> Strengths<T> for IntervalFiring<T, I, K>
where
    Inputs<I>: Grid,
{
    type Rules = Rules<T, I, K>;

    fn strengths(&self) -> Rules<T, I, K> {
        let mut strengths = Rules::filled(T::zero());
        for (weight, grades) in &self.parts {
            strengths.add(grades.rows(), *weight);
        }
        strengths
    }

    fn norm_squared(&self) -> T {
        self.norm_squared
    }
}

impl<M: IntervalMembership<T>, T: Scalar, const I: usize, const K: usize> Network
    for IntervalNetwork<M, T, I, K>
where
    Inputs<I>: Grid,
{
    type Scalar = T;
    type Input = SVector<T, I>;
    type Firing = IntervalFiring<T, I, K>;

    fn fire(&self, e: &SVector<T, I>) -> IntervalFiring<T, I, K> {
        let mut rows = [[[T::zero(); K]; I]; 2];
        let [lower, upper] = &mut rows;
        let mut ratio = T::one();
        let inputs = lower.iter_mut().zip(upper).zip(&self.memberships).zip(e.iter());
        for (((lower, upper), row), e) in inputs {
            let shares = M::shares(row, *e);
            (*lower, *upper) = (shares.lower, shares.upper);
            ratio *= shares.ratio;
        }
        let (lower, upper) = (Grades::of(rows[0]), Grades::of(rows[1]));
        let a = self.reduction.lower(ratio);
        let b = T::one() - a;
        let norm_squared = a * a * lower.dot(&lower)
            + (a * b + a * b) * lower.dot(&upper)
            + b * b * upper.dot(&upper);
        IntervalFiring { parts: [(a, lower), (b, upper)], norm_squared }
    }

    fn output(&self, firing: &IntervalFiring<T, I, K>) -> T {
        firing.parts.iter().fold(T::zero(), |sum, (weight, grades)| {
            sum + *weight * self.consequents.mean(grades.rows())
        })
    }

    fn move_consequents(&mut self, firing: &IntervalFiring<T, I, K>, rate: T) {
        for (weight, grades) in &firing.parts {
            self.consequents.add(grades.rows(), rate * *weight);
        }
    }

    fn change_consequents(&mut self, change: impl FnOnce(&mut [T])) {
        change(&mut self.consequents);
    }
}

impl<M: IntervalMembership<T>, T: Scalar, const I: usize, const K: usize> Over<T, I>
    for IntervalNetwork<M, T, I, K>
where
    Inputs<I>: Grid,
{
}

checked! {
    [M: IntervalMembership<T>, T: Scalar, const I: usize, const K: usize]
    IntervalNetwork<M, T, I, K>, [M, T; Inputs<I>: Grid]
    {
        memberships: Array<Array<M, K>, I> = Array(memberships.map(Array)),
        reduction: TypeReduction<T>,
        consequents: Rules<T, I, K>,
    } =>
    Self::new(memberships.0.map(|row| row.0), reduction).and_then(|mut network| {
        network.set_consequents(&consequents)?;
        Ok(network)
    })
}
